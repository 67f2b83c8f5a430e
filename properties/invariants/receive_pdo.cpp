// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/receive_pdo.hpp"

#include "properties/invariants/both.hpp"

namespace canproof {

bool ReceivePdos::is_consistent() const noexcept {
    Instant first{never};
    bool sound = failed_ <= 0xFFFFFFU;
    for (const ReceivePdo& rpdo : rpdos_) {
        const bool has_id = (rpdo.identifier <= 0x7FFU) || (rpdo.identifier == ReceivePdo::nobody);
        sound = both(sound, has_id);
        sound = both(sound, !rpdo.waits || (rpdo.waiting.length >= rpdo.mapping.length()));
        first = earliest(first, rpdo.due);
    }
    return sound && (next_ == first);
}

}  // namespace canproof
