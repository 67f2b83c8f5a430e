// SPDX-License-Identifier: Apache-2.0
// Clamps numbers to bounds.
#pragma once

namespace canproof {

/// Returns the smaller of two numbers; `b` when one of them is NaN. Needs one comparison; std::fmin needs more, because
/// it returns the other number when one of them is NaN.
constexpr double lesser(const double a, const double b) noexcept {
    return (a < b) ? a : b;
}
/// Returns the greater of two numbers; `b` when one of them is NaN.
constexpr double greater(const double a, const double b) noexcept {
    return (a > b) ? a : b;
}

}  // namespace canproof
