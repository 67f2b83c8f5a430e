// Holding numbers within bounds.
#pragma once

namespace canproof {

/// The smaller of two numbers; the second when the first is none. One comparison, where std::fmin sorts out every NaN.
constexpr double lesser(const double a, const double b) noexcept {
    return (a < b) ? a : b;
}
/// The greater of two numbers; the second when the first is none.
constexpr double greater(const double a, const double b) noexcept {
    return (a > b) ? a : b;
}

}  // namespace canproof
