// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/relay.hpp"

namespace canproof::ax130751 {

bool Relay::is_consistent() const noexcept {
    if ((effect_ == UnlatchEffect::ignored) && (latch_ != Latch::latching)) {
        return false;
    }
    return delayed_.is(blinking_ || state_);
}

}  // namespace canproof::ax130751
