// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/lss.hpp"

namespace canproof {

bool Lss::is_consistent() const noexcept {
    return (static_cast<std::uint32_t>(state_) <= 1U) && (selected_ <= lss_number_count) && (identified_ <= 6U) &&
           scan_.is_consistent() && is_lss_node_id(pending_.node_id) &&
           (static_cast<std::uint32_t>(switching_) <= 2U) && ((due_ == never) != is_silent());
}

}  // namespace canproof
