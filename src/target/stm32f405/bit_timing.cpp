// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/bit_timing.hpp"

#include <array>

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

// Greatest values of two fields of CAN_BTR (RM0090 32.9.2).
constexpr std::uint32_t most_prescaler = 1024U;
constexpr std::uint32_t most_jump = 4U;
constexpr std::uint64_t million = 1000000U;
constexpr std::uint64_t too_great_ppm = std::uint64_t{most_error_ppm} + 1U;

/// A division of a bit into `quanta` time quanta, of which `after_sample` lie after the sample point.
struct Division {
    std::uint32_t quanta;
    std::uint32_t after_sample;
};

/// The divisions of a bit: those with the sample point nearest to 87.5 % first, and of two that are equally near, the
/// one with more quanta first. No sample point is after 90 %. At most 16 + 1 quanta lie before the sample point (RM0090
/// 32.9.2). Of 23 quanta, these are 73.9 %, and 75 % are wanted. Fewer than 8 quanta leave too little room for both
/// segments.
constexpr std::array<Division, 15U> divisions{{
    {16U, 2U},  // 87.5 %
    {8U, 1U},   // 87.5 %
    {17U, 2U},  // 88.2 %
    {15U, 2U},  // 86.7 %
    {18U, 2U},  // 88.9 %
    {9U, 1U},   // 88.9 %
    {14U, 2U},  // 85.7 %
    {19U, 2U},  // 89.5 %
    {20U, 3U},  // 85.0 %
    {10U, 1U},  // 90.0 %
    {13U, 2U},  // 84.6 %
    {12U, 2U},  // 83.3 %
    {11U, 2U},  // 81.8 %
    {21U, 4U},  // 81.0 %
    {22U, 5U}   // 77.3 %
}};

/// Returns the deviation of clock_hz / clocks from `bit_rate` in parts per million, rounded up.
std::uint64_t error_ppm(const std::uint32_t clock_hz, const std::uint32_t clocks,
                        const std::uint32_t bit_rate) noexcept {
    const std::uint64_t wanted = std::uint64_t{bit_rate} * clocks;
    const std::uint64_t given = clock_hz;
    const std::uint64_t off = (wanted > given) ? (wanted - given) : (given - wanted);
    return ((off * million) + (wanted - 1U)) / wanted;
}

BitTiming timing_of(const std::uint32_t prescaler, const Division& division) noexcept {
    const std::uint32_t after = division.after_sample;
    return BitTiming{prescaler, division.quanta - (1U + after), after, (after < most_jump) ? after : most_jump};
}

}  // namespace

static_assert(implements<req::CO_CAN_001> && implements<req::CO_CAN_009> && implements<req::CO_CAN_014>);
Result<BitTiming, BitTimingError> bit_timing(const std::uint32_t clock_hz, const std::uint32_t bit_rate) noexcept {
    using Found = Result<BitTiming, BitTimingError>;
    Found best = Found::failure(BitTimingError::no_such_rate);
    std::uint64_t least_error{too_great_ppm};
    if (bit_rate == 0U) {
        return best;
    }
    for (const Division& division : divisions) {
        const std::uint64_t quantum_rate = std::uint64_t{bit_rate} * division.quanta;
        const std::uint64_t nearest = (clock_hz + (quantum_rate / 2U)) / quantum_rate;
        if ((nearest == 0U) || (nearest > most_prescaler)) {
            continue;
        }
        const BitTiming timing = timing_of(static_cast<std::uint32_t>(nearest), division);
        const std::uint64_t error = error_ppm(clock_hz, timing.clocks(), bit_rate);
        if (error < least_error) {
            best = Found::success(timing);
            least_error = error;
        }
    }
    return best;
}

}  // namespace canproof::stm32f405
