// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/transmit_queue.hpp"

#include "properties/invariants/both.hpp"

namespace canproof {

bool TransmitQueue::is_bounded() const noexcept {
    return (size() <= capacity) && (open_ || empty()) && (!boot_up_waits_ || !empty());
}

bool TransmitQueue::is_in_order(const std::size_t at) const noexcept {
    const auto here = static_cast<std::uint32_t>(first_ + at);
    const bool is_behind_boot_up = both(at == 1U, boot_up_waits_);
    return !both(!is_behind_boot_up, id_at(here - 1U) > id_at(here));
}

bool TransmitQueue::is_consistent() const noexcept {
    bool sound = is_bounded();
    if (size() > 1U) {
        for (std::size_t at = 1U; at < capacity; ++at) {
            sound = both(sound, !both(at < size(), !is_in_order(at)));
        }
    }
    return sound;
}

}  // namespace canproof
