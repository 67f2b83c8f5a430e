// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/sync.hpp"

#include "generated/canopen/index.hpp"

namespace canproof {

namespace {

namespace index = generated::canopen::index;

}  // namespace

bool Sync::is_consistent() const noexcept {
    const std::uint32_t cob_id = objects_.read(index::sync_cob_id, 0U);
    const bool produces = allowed_ && ((cob_id & 0x40000000U) != 0U) && (objects_.read(index::sync_period, 0U) != 0U);
    const std::uint32_t length = (objects_.read(index::sync_counter_overflow, 0U) == 0U) ? 0U : 1U;
    return (identifier_ == (cob_id & 0x7FFU)) && (length_ == length) && ((next_ == never) || produces);
}

}  // namespace canproof
