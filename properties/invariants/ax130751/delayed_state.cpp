// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/delayed_state.hpp"

namespace canproof::ax130751 {

bool DelayedState::is(const bool state) const noexcept {
    return state_ == state;
}

}  // namespace canproof::ax130751
