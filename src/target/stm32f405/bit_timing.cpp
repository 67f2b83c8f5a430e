// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/bit_timing.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

// Bounds of the fields of CAN_BTR (RM0090 32.9.2), and the fewest quanta that leave room for both segments.
constexpr std::uint32_t most_prescaler = 1024U;
constexpr std::uint32_t most_before_sample = 16U;
constexpr std::uint32_t most_after_sample = 8U;
constexpr std::uint32_t most_jump = 4U;
constexpr std::uint32_t least_quanta = 8U;
// Of 23 quanta, at most 16 + 1 lie before the sample point: 73.9 %, and 75 % are wanted.
constexpr std::uint32_t most_quanta = 22U;
constexpr std::uint64_t million = 1000000U;

constexpr std::uint32_t difference(const std::uint32_t a, const std::uint32_t b) noexcept {
    return (a > b) ? (a - b) : (b - a);
}

constexpr std::uint32_t at_most(const std::uint32_t value, const std::uint32_t most) noexcept {
    return (value < most) ? value : most;
}

/// Returns the deviation of clock_hz / clocks from `bit_rate` in parts per million, rounded up.
std::uint64_t error_ppm(const std::uint32_t clock_hz, const std::uint32_t clocks,
                        const std::uint32_t bit_rate) noexcept {
    const std::uint64_t wanted = std::uint64_t{bit_rate} * clocks;
    const std::uint64_t given = clock_hz;
    const std::uint64_t off = (wanted > given) ? (wanted - given) : (given - wanted);
    return ((off * million) + (wanted - 1U)) / wanted;
}

constexpr std::uint32_t at_least(const std::uint32_t value, const std::uint32_t least) noexcept {
    return (value > least) ? value : least;
}

/// Returns the timing of a bit of `quanta` time quanta with the sample point near seven eighths of the bit, at 90 % or
/// before.
BitTiming timing_of(const std::uint32_t prescaler, const std::uint32_t quanta) noexcept {
    const std::uint32_t eighth = (quanta + 4U) / 8U;
    const std::uint32_t tenth = (quanta + 9U) / 10U;  // rounded up
    const std::uint32_t least_after = (quanta > (most_before_sample + 1U)) ? (quanta - (most_before_sample + 1U)) : 1U;
    const std::uint32_t wished = at_least(at_least(eighth, tenth), least_after);
    const std::uint32_t after = at_most(wished, most_after_sample);
    return BitTiming{prescaler, quanta - (1U + after), after, at_most(after, most_jump)};
}

/// Returns the distance of the sample point from seven eighths of the bit, in thousandths of a bit.
std::uint32_t sample_error(const BitTiming& timing) noexcept {
    return difference(((1U + timing.before_sample) * 1000U) / timing.quanta(), 875U);
}

}  // namespace

static_assert(implements<req::CO_CAN_001> && implements<req::CO_CAN_009> && implements<req::CO_CAN_014>);
Result<BitTiming, BitTimingError> bit_timing(const std::uint32_t clock_hz, const std::uint32_t bit_rate) noexcept {
    using Found = Result<BitTiming, BitTimingError>;
    BitTiming best{};
    std::uint64_t best_error{std::uint64_t{most_error_ppm} + 1U};
    if ((bit_rate == 0U) || (bit_rate > clock_hz)) {
        return Found::failure(BitTimingError::no_such_rate);
    }
    for (std::uint32_t quanta = least_quanta; quanta <= most_quanta; ++quanta) {
        const std::uint64_t quantum_rate = std::uint64_t{bit_rate} * quanta;
        const std::uint64_t nearest = (clock_hz + (quantum_rate / 2U)) / quantum_rate;
        if ((nearest == 0U) || (nearest > most_prescaler)) {
            continue;
        }
        const BitTiming timing = timing_of(static_cast<std::uint32_t>(nearest), quanta);
        const std::uint64_t error = error_ppm(clock_hz, timing.clocks(), bit_rate);
        const bool is_as_near = (error == best_error) && (sample_error(timing) <= sample_error(best));
        if ((error < best_error) || is_as_near) {
            best = timing;
            best_error = error;
        }
    }
    return (best_error <= most_error_ppm) ? Found::success(best) : Found::failure(BitTimingError::no_such_rate);
}

}  // namespace canproof::stm32f405
