// SPDX-License-Identifier: Apache-2.0
// The signals between function blocks (AX060805, 3.1): undefined, a discrete value or a continuous value.
#pragma once

#include <cstdint>

namespace canproof::ax060805 {

enum class SignalKind : std::uint8_t { undefined, discrete, continuous };

/// A signal. Only the value that `kind` names is valid; the other is 0.
struct Signal {
    SignalKind kind{SignalKind::undefined};
    std::uint32_t discrete{0U};
    float continuous{0.0F};
};

constexpr Signal undefined_signal() noexcept {
    return Signal{};
}
constexpr Signal discrete_signal(const std::uint32_t value) noexcept {
    return Signal{SignalKind::discrete, value, 0.0F};
}
constexpr Signal continuous_signal(const float value) noexcept {
    return Signal{SignalKind::continuous, 0U, value};
}
constexpr bool is_defined(const Signal& signal) noexcept {
    return signal.kind != SignalKind::undefined;
}

/// Converts a signal to a continuous value, rounded to single precision; 0 for an undefined signal (3.1.5).
float as_continuous(const Signal& signal) noexcept;

/// Converts a continuous value to a discrete one and drops the fraction. Negative values and NaN become 0. Values of
/// 2^32 and above become FFFFFFFFh (3.1.6).
std::uint32_t to_discrete(float value) noexcept;

}  // namespace canproof::ax060805
