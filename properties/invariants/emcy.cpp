// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/emcy.hpp"

#include "generated/canopen/index.hpp"
#include "properties/invariants/both.hpp"

namespace canproof {

bool Emcy::is_consistent() const noexcept {
    const std::uint32_t listed = objects_.read(generated::canopen::index::error_list, 0U);
    bool sound = (active_ < (std::uint64_t{1U} << max_errors)) && (pending_count_ <= pending_capacity) &&
                 ((listed == 0U) || (listed <= list_capacity()));
    if (pending_count_ != 0U) {
        for (std::size_t i = 0U; i < pending_capacity; ++i) {
            sound = both(sound, !both(i < pending_count_, pending_[i].error >= max_errors));
        }
    }
    if (queued_count_ != 0U) {
        for (std::size_t i = 0U; i < queued_.size(); ++i) {
            sound = both(sound, !both(i < queued_count_, queued_[i].error >= max_errors));
        }
    }
    return sound;
}

}  // namespace canproof
