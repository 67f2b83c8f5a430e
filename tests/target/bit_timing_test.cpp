// SPDX-License-Identifier: Apache-2.0
// Bit timing of the CAN controller for every bit rate that LSS or the switch of a device offers. The test computes the
// bit rate that results: clock of APB1 / (prescaler × quanta per bit).
#include "target/stm32f405/bit_timing.hpp"

#include <cmath>
#include <map>
#include <optional>

#include "generated/canopen/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;

constexpr std::uint32_t mhz_42 = 42000000;  // clock of APB1: a quarter of the core clock of 168 MHz
constexpr std::uint32_t mhz_40 = 40000000;  // clock of APB1: a quarter of the core clock of 160 MHz

double given_rate(const BitTiming& timing, std::uint32_t clock) {
    return double{1} * clock / timing.prescaler / (1 + timing.before_sample + timing.after_sample);
}

bool has_good_sample_point(const BitTiming& timing) {
    const std::uint32_t quanta = 1 + timing.before_sample + timing.after_sample;
    return (1 + timing.before_sample) * 100 >= 75 * quanta && (1 + timing.before_sample) * 100 <= 90 * quanta;
}

/// Maps each bit rate in bit/s to its clocks per bit: clock / rate.
using Clocks = std::map<std::uint32_t, std::uint32_t>;

void expect_timings(std::uint32_t clock, const Clocks& clocks_of) {
    for (const auto& [rate, clocks] : clocks_of) {
        SCOPED_TRACE(rate);
        const auto found = bit_timing(clock, rate);
        ASSERT_TRUE(found.ok());
        const BitTiming& timing = found.value();
        EXPECT_EQ(timing.clocks(), clocks);
        EXPECT_LE(std::abs(given_rate(timing, clock) / rate - 1), 0.0041);
        EXPECT_TRUE(has_good_sample_point(timing));
        EXPECT_GE(timing.jump, 1U);
        EXPECT_LE(timing.jump, timing.after_sample);
    }
}

/// Returns the distance of the sample point from seven eighths of the bit, in eighths of a quantum.
std::uint32_t sample_distance(const BitTiming& timing) {
    const int eighths = static_cast<int>(8 * (1 + timing.before_sample)) - static_cast<int>(7 * timing.quanta());
    return static_cast<std::uint32_t>(std::abs(eighths));
}

/// Returns the deviation of the bit rate in ppm, rounded up.
std::uint64_t deviation(const BitTiming& timing, std::uint32_t clock, std::uint64_t rate) {
    const std::uint64_t wanted = rate * timing.clocks();
    const std::uint64_t off = wanted > clock ? wanted - clock : clock - wanted;
    return (off * 1000000 + wanted - 1) / wanted;
}

/// Returns the timing that bit_timing.hpp promises, found by trying all of 8 or more quanta. Of these, 1 to 16 lie
/// before the sample point and 1 to 8 after it, and the sample point is at 75 to 90 %. The prescaler, 1 to 1024, is the
/// one nearest to clock / rate / quanta. The least deviation of the bit rate wins, then the sample point nearest
/// to 87.5 %, then the most quanta.
std::optional<BitTiming> naive_timing(std::uint32_t clock, std::uint32_t rate) {
    std::optional<BitTiming> best;
    for (std::uint32_t before = 1; before <= 16; ++before) {
        for (std::uint32_t after = 1; after <= 8; ++after) {
            const std::uint32_t quanta = 1 + before + after;
            const auto prescaler = static_cast<std::uint32_t>(std::lround(double{1} * clock / rate / quanta));
            const BitTiming timing{prescaler, before, after, std::min<std::uint32_t>(after, 4)};
            if (quanta < 8 || prescaler < 1 || prescaler > 1024 || !has_good_sample_point(timing) ||
                deviation(timing, clock, rate) > 4100) {
                continue;
            }
            if (!best) {
                best = timing;
                continue;
            }
            const std::uint64_t off = deviation(timing, clock, rate), best_off = deviation(*best, clock, rate);
            // distances of different numbers of quanta have the common denominator 8 × quanta × quanta
            const std::uint32_t distance = sample_distance(timing) * best->quanta();
            const std::uint32_t best_distance = sample_distance(*best) * quanta;
            if (off < best_off || (off == best_off && distance < best_distance) ||
                (off == best_off && distance == best_distance && quanta > best->quanta())) {
                best = timing;
            }
        }
    }
    return best;
}

}  // namespace

TEST(BitTiming, BitRatesOfTheAx130751AreReachedAt168MHz) {
    verifies<req::CO_CAN_001, req::CO_CAN_014>();
    // Section 3.1 of the manual: 42 MHz / 666.667 kbit/s = 63 clocks per bit, a whole number.
    expect_timings(mhz_42, {{1000000, 42},
                            {666667, 63},
                            {500000, 84},
                            {250000, 168},
                            {125000, 336},
                            {50000, 840},
                            {20000, 2100},
                            {10000, 4200}});
}

TEST(BitTiming, BitRatesOfTheOtherDevicesAreReachedAt160MHz) {
    verifies<req::CO_CAN_001, req::CO_CAN_014>();
    // 800 kbit/s (index 1 in CiA 305) has 40 MHz / 0.8 MHz = 50 clocks per bit. At 42 MHz it would have 52.5, which is
    // no whole number.
    expect_timings(mhz_40, {{1000000, 40},
                            {800000, 50},
                            {500000, 80},
                            {250000, 160},
                            {125000, 320},
                            {50000, 800},
                            {20000, 2000},
                            {10000, 4000}});
    // CAN-CBX-AO412, Table 11: thirds and sixths of 1 Mbit/s. 40 MHz / 166 kHz = 240.96 clocks per bit, which 240
    // approximates.
    expect_timings(mhz_40, {{666667, 60},
                            {333333, 120},
                            {166000, 240},
                            {100000, 400},
                            {83333, 480},
                            {66667, 600},
                            {33333, 1200},
                            {12500, 3200}});
}

TEST(BitTiming, BitRateThatTheClockCannotGiveIsRefused) {
    verifies<req::CO_CAN_009>();
    // At 42 MHz, 800 kbit/s would need 52.5 clocks per bit: 52 clocks are 0.96 % too fast, 53 are 0.94 % too slow.
    for (const std::uint32_t rate : {800000U, 0U, 100U, 6000000U, 42000000U, 4294967295U}) {
        SCOPED_TRACE(rate);
        EXPECT_EQ(bit_timing(mhz_42, rate).error(), BitTimingError::no_such_rate);
    }
}

// 10 clocks per bit at 1 Mbit/s: 10.041 MHz is 0.41 % too fast, 9.959 MHz 0.41 % too slow.
TEST(BitTiming, BitRateIsGivenUpTo0Point41PercentOfError) {
    verifies<req::CO_CAN_001, req::CO_CAN_009>();
    for (const std::uint32_t clock : {10041000U, 9959000U}) {
        EXPECT_TRUE(bit_timing(clock, 1000000).ok());
    }
    for (const std::uint32_t clock : {10041001U, 9958999U}) {
        EXPECT_EQ(bit_timing(clock, 1000000).error(), BitTimingError::no_such_rate);
    }
}

TEST(BitTiming, RegisterValueHasTheFieldsOfTheReferenceManual) {
    verifies<req::CO_CAN_001>();
    // The bit timing has 3 clocks per quantum, 1 + 11 + 2 quanta per bit, and a jump width of 2. The register contains
    // 3, 11, 2 and 2, each minus one, at bits 0, 16, 20 and 24.
    EXPECT_EQ(bit_timing_register(BitTiming{3, 11, 2, 2}), (1U << 24U) | (1U << 20U) | (10U << 16U) | 2U);
    EXPECT_EQ(bit_timing_register(BitTiming{1024, 16, 8, 4}), 0x037F03FFU);
}

// Of 11 quanta, 10 before the sample point are 90.9 % and 9 are 81.8 %. Of 23 quanta, at most 17 (1 + 16) can lie
// before the sample point, 73.9 %; of 25, 68 %. No other number of quanta, 8 to 22, divides 23, 25 or 92 clocks.
TEST(BitTiming, SamplePointIsAt75To90PercentOrTheBitRateIsRefused) {
    verifies<req::CO_CAN_014, req::CO_CAN_009>();
    EXPECT_EQ(bit_timing(mhz_40, 434783).error(), BitTimingError::no_such_rate);  // 40 MHz / 434,783 bit/s = 92 clocks
    for (std::uint32_t quanta = 8; quanta <= 25; ++quanta) {
        const auto found = bit_timing(quanta * 1000000, 1000000);       // a bit has as many clocks as quanta
        EXPECT_EQ(found.ok(), quanta != 23 && quanta != 25) << quanta;  // 24 clocks are 2 times 12 quanta
        EXPECT_TRUE(!found.ok() || has_good_sample_point(found.value())) << quanta;
    }
}

// The low rates make a difference: some need the prescaler 1024, 22 quanta, or a prescaler that is rounded up.
TEST(BitTiming, TimingIsTheBestOfAllThatTheRegisterPermits) {
    verifies<req::CO_CAN_001, req::CO_CAN_009, req::CO_CAN_014>();
    std::vector<std::uint32_t> rates{1000000, 800000, 666667, 500000, 333333, 250000, 166000, 125000, 5488, 434};
    for (std::uint32_t rate = 1900; rate < 2200; ++rate) {
        rates.push_back(rate);
    }
    for (std::uint32_t rate = 10000; rate < 1000000; rate += 1777) {
        rates.push_back(rate);
    }
    std::size_t reached = 0;
    for (const std::uint32_t clock :
         std::initializer_list<std::uint32_t>{mhz_40, mhz_42, 8000000U, 22000000U, 24000000U, 45000000U}) {
        for (const std::uint32_t rate : rates) {
            const auto found = bit_timing(clock, rate);
            const auto best = naive_timing(clock, rate);
            ASSERT_EQ(found.ok(), best.has_value()) << clock << ' ' << rate;
            if (best) {
                ASSERT_EQ(bit_timing_register(found.value()), bit_timing_register(*best)) << clock << ' ' << rate;
                ++reached;
            }
        }
    }
    EXPECT_GT(reached, 2000U);
}

TEST(BitTiming, EveryBitTimingFieldStaysWithinItsRegisterRange) {
    verifies<req::CO_CAN_001, req::CO_CAN_014>();
    for (std::uint32_t rate = 5000; rate <= 1000000; rate += 997) {
        for (const std::uint32_t clock : std::initializer_list<std::uint32_t>{mhz_40, mhz_42, 8000000U, 45000000U}) {
            const auto found = bit_timing(clock, rate);
            if (!found.ok()) {
                continue;
            }
            const BitTiming& timing = found.value();
            ASSERT_TRUE(timing.prescaler >= 1 && timing.prescaler <= 1024) << rate;
            ASSERT_TRUE(timing.before_sample >= 1 && timing.before_sample <= 16) << rate;
            ASSERT_TRUE(timing.after_sample >= 1 && timing.after_sample <= 8) << rate;
            ASSERT_TRUE(timing.jump >= 1 && timing.jump <= 4) << rate;
            ASSERT_LE(std::abs(given_rate(timing, clock) / rate - 1), 0.0041) << rate;
            ASSERT_TRUE(has_good_sample_point(timing)) << rate;
        }
    }
}

}  // namespace canproof::test
