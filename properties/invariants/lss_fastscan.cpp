// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/lss_fastscan.hpp"

namespace canproof {

bool LssFastscan::is_consistent() const noexcept {
    return (position_ < lss_number_count) && (confirmed_ < 15U);
}

}  // namespace canproof
