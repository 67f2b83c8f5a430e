// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/error_control.hpp"

#include "generated/canopen/index.hpp"

namespace canproof {

namespace {

namespace index = generated::canopen::index;

}  // namespace

bool ErrorControl::is_consistent() const noexcept {
    const bool produces = heartbeat_time_.us != 0U;
    const bool is_guarded = (life_deadline_ != never) || life_failed_;
    const std::uint64_t guard_time = objects_.read(index::guard_time, 0U);
    return (heartbeat_time_.us == milliseconds(objects_.read(index::producer_heartbeat_time, 0U)).us) &&
           (life_time_.us == milliseconds(guard_time * objects_.read(index::life_time_factor, 0U)).us) &&
           ((next_heartbeat_ == never) || produces) && !(produces && is_guarded) &&
           ((life_time_.us != 0U) || !is_guarded);
}

bool ErrorControl::shows(const NmtState state) const noexcept {
    return state_ == state;
}

}  // namespace canproof
