// SPDX-License-Identifier: Apache-2.0
// Naive signals and binary functions of the AX060805 (manual, 3.1 and 3.8). The measured values of the device are known
// only within a tolerance. So every number is a span from `low` to `high`, which are equal if the number is exact.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace canproof::test {

struct NaiveSpan {
    double low{0.0};
    double high{0.0};

    bool is_point() const { return low == high; }
};

/// A signal. It is empty when the signal is undefined.
using NaiveSignal = std::optional<NaiveSpan>;

inline NaiveSpan naive_point(double value) {
    return {value, value};
}
/// Returns the span in which the device's value lies when single precision cannot represent `value` exactly.
inline NaiveSpan naive_rounded(double value) {
    const double width = static_cast<double>(static_cast<float>(value)) == value ? 0.0 : std::fabs(value) * 5.0e-7;
    return {value - width, value + width};
}
inline NaiveSpan naive_span(double a, double b, double c, double d) {
    const double low = std::min({a, b, c, d});
    const double high = std::max({a, b, c, d});
    if (low == high) {
        return naive_rounded(low);
    }
    return {low - std::fabs(low) * 5.0e-7, high + std::fabs(high) * 5.0e-7};
}
inline NaiveSpan naive_sum(const NaiveSpan& a, const NaiveSpan& b) {
    return naive_span(a.low + b.low, a.high + b.high, a.low + b.low, a.high + b.high);
}
inline NaiveSpan naive_product(const NaiveSpan& a, const NaiveSpan& b) {
    return naive_span(a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high);
}

/// Converts a continuous signal to a discrete one (section 3.1.6).
inline std::uint64_t naive_discrete(double value) {
    return value >= 4294967295.0 ? 4294967295U : value >= 1.0 ? static_cast<std::uint64_t>(std::floor(value)) : 0U;
}

/// Converts a span to an integer; returns nothing when single precision may give another integer.
inline std::optional<std::uint64_t> naive_discrete(const NaiveSpan& x) {
    return naive_discrete(x.low) == naive_discrete(x.high) ? std::optional{naive_discrete(x.low)} : std::nullopt;
}

/// One binary function (section 3.8). unknown() returns whether the result depends on rounding in single precision.
class NaiveFunction {
  public:
    struct Input {
        NaiveSignal source;
        bool has_default{false};
        double default_value{0.0};
        int unary{0};
        double scale{1.0};
        double offset{0.0};
    };

    /// Evaluates Equation 4 of the manual: A F(a1 f1(X1) + b1, a2 f2(X2) + b2) + B.
    NaiveSignal result(const std::array<Input, 2>& inputs, int operation, double scale, double offset) {
        const NaiveSignal first = operand(inputs[0]);
        const NaiveSignal second = operand(inputs[1]);
        if (!first || !second || operation == 0) {
            return std::nullopt;
        }
        return linear(scale, representable(apply(operation, *first, *second)), offset);
    }
    bool unknown() const { return unknown_; }

  private:
    NaiveSignal operand(const Input& input) {
        if (!input.source && !input.has_default) {
            return std::nullopt;
        }
        const NaiveSpan x = unary(input.unary, input.source ? *input.source : naive_point(input.default_value));
        return linear(input.scale, x, input.offset);
    }
    NaiveSpan linear(double scale, const NaiveSpan& x, double offset) {
        const NaiveSpan scaled = representable(naive_product(naive_point(scale), x));
        return representable(naive_sum(scaled, naive_point(offset)));
    }
    /// Notes a number that is too great for single precision. The device computes with infinity instead, and 0 times
    /// infinity is NaN.
    NaiveSpan representable(const NaiveSpan& x) {
        constexpr double greatest = 3.4028234e38;
        unknown_ = unknown_ || !(x.low >= -greatest && x.high <= greatest);
        return x;
    }
    NaiveSpan unary(int number, const NaiveSpan& x) {
        if (number == 3) {
            const bool spans_zero = x.low < 0.0 && x.high > 0.0;
            const double far = std::max(std::fabs(x.low), std::fabs(x.high));
            return {spans_zero ? 0.0 : std::min(std::fabs(x.low), std::fabs(x.high)), far};
        }
        if (number == 0) {
            return x;
        }
        const std::uint64_t whole = whole_of(x);
        return number == 1 ? naive_point(whole == 0U ? 1.0 : 0.0)
                           : naive_rounded(static_cast<double>(static_cast<float>(4294967295U - whole)));
    }
    NaiveSpan apply(int operation, const NaiveSpan& x, const NaiveSpan& y) {
        switch (operation) {
            case 1:
                return naive_sum(x, y);
            case 2:
                return naive_sum(x, {-y.high, -y.low});
            case 3:
                return naive_product(x, y);
            case 4:
                return quotient(x, y);
            case 6:
                return {std::max(x.low, y.low), std::max(x.high, y.high)};
            case 7:
                return {std::min(x.low, y.low), std::min(x.high, y.high)};
            case 8:
            case 9:
                return equality(x, y, operation == 8);
            case 10:
            case 12:
                return operation == 10 ? certain(y.high < x.low, x.high <= y.low)
                                       : certain(x.high < y.low, y.high <= x.low);
            case 11:
            case 13:
                return operation == 11 ? certain(y.high <= x.low, x.high < y.low)
                                       : certain(x.high <= y.low, y.high < x.low);
            default:
                return naive_rounded(
                    static_cast<double>(static_cast<float>(integer(operation, whole_of(x), whole_of(y)))));
        }
    }
    NaiveSpan quotient(const NaiveSpan& x, const NaiveSpan& y) {
        if (y.is_point() && y.low == 0.0) {
            return naive_point(0.0);
        }
        unknown_ = unknown_ || (y.low <= 0.0 && y.high >= 0.0);
        return naive_span(x.low / y.low, x.low / y.high, x.high / y.low, x.high / y.high);
    }
    NaiveSpan equality(const NaiveSpan& x, const NaiveSpan& y, bool wanted) {
        const bool same = x.is_point() && y.is_point() && x.low == y.low;
        const NaiveSpan equal = certain(same, x.high < y.low || y.high < x.low);
        return wanted ? equal : NaiveSpan{1.0 - equal.high, 1.0 - equal.low};
    }
    NaiveSpan certain(bool yes, bool no) {
        unknown_ = unknown_ || (!yes && !no);
        return naive_point(yes ? 1.0 : 0.0);
    }
    std::uint64_t whole_of(const NaiveSpan& x) {
        unknown_ = unknown_ || !naive_discrete(x);
        return naive_discrete(x.low);
    }
    static std::uint64_t integer(int operation, std::uint64_t x, std::uint64_t y) {
        switch (operation) {
            case 5:
                return y == 0U ? 0U : x % y;
            case 14:
                return x + y == 0U ? 0U : 1U;
            case 15:
                return x * y == 0U && (x == 0U || y == 0U) ? 0U : 1U;
            case 16:
                return x | y;
            case 17:
                return x & y;
            case 18:
                return x ^ y;
            case 19:
                return y >= 32U ? 0U : (x << y) % 4294967296U;
            default:
                return y >= 32U ? 0U : x >> y;
        }
    }

    bool unknown_{false};
};

}  // namespace canproof::test
