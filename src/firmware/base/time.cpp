// SPDX-License-Identifier: Apache-2.0
#include "firmware/base/time.hpp"

namespace canproof {

std::uint64_t sum_or_never(const std::uint64_t start, const std::uint64_t length) noexcept {
    return (Instant{start} + Duration{length}).us;
}

}  // namespace canproof
