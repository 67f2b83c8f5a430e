// SPDX-License-Identifier: Apache-2.0
// Clamps numbers to bounds.
#pragma once

namespace canproof {

/// Returns the smaller of two numbers; the second when the first is NaN. One comparison; std::fmin would also handle a
/// NaN in the second.
constexpr double lesser(const double a, const double b) noexcept {
    return (a < b) ? a : b;
}
/// Returns the greater of two numbers; the second when the first is NaN.
constexpr double greater(const double a, const double b) noexcept {
    return (a > b) ? a : b;
}

}  // namespace canproof
