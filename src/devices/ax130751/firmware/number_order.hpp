// SPDX-License-Identifier: Apache-2.0
// Comparisons of doubles by their bits. The FPU of a Cortex-M4F has no doubles, and a comparison by the library takes
// about 40 instructions, three times as many as here.
#pragma once

#include "firmware/base/bytes.hpp"

namespace canproof::ax130751 {

/// Returns an unsigned number that is greater for a greater `value`; `value` must not be NaN. Both zeros give the same
/// number.
inline std::uint64_t order_of(const double value) noexcept {
    constexpr std::uint64_t sign = std::uint64_t{1U} << 63U;
    const auto bits = bit_cast<std::uint64_t>(value);
    return (bits < sign) ? (bits + sign) : (sign - (bits - sign));
}

/// Returns whether two numbers are equal; neither may be NaN.
inline bool is_same(const double a, const double b) noexcept {
    return order_of(a) == order_of(b);
}

}  // namespace canproof::ax130751
