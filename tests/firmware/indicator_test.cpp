// SPDX-License-Identifier: Apache-2.0
// Tests the eight indicator states of the CAN-CBX-AO412 (3.2.1), each over two periods of its pattern, in steps of 50
// ms.
#include "firmware/canopen/indicator.hpp"

#include "generated/cbx_ao412/requirements.hpp"
#include "generated/cbx_ao412/tables.hpp"
#include "tests/support/shows_rule.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using State = generated::cbx_ao412::IndicatorState;

IndicatorPattern pattern(State state) {
    const auto* row = generated::cbx_ao412::indicator_flashes::find(state);
    return {row->flashes, milliseconds(row->on_ms), milliseconds(row->gap_ms), milliseconds(row->pause_ms)};
}

/// Returns what the LED shows over time, one character per 50 ms from time 0: # lit, . dark.
std::string watch(State state, std::size_t steps, Duration shift = Duration{}) {
    std::string seen;
    for (std::size_t i = 0; i < steps; ++i) {
        seen += indicator_phase(pattern(state), Instant{} + milliseconds(50 * i), shift).lit ? '#' : '.';
    }
    return seen;
}

const std::string flash = "####";   // 200 ms
const std::string gap = "....";     // 200 ms
const std::string pause(20, '.');   // 1000 ms
const std::string pause1(28, '.');  // 1400 ms

}  // namespace

TEST(Indicator, EachLedStateFlashesAsPrintedInTheManual) {
    verifies<req::AO4_T5, req::AO4_E_INDICATOR, req::AO4_LED_005, req::AO4_LED_008, req::AO4_LED_009>();
    EXPECT_EQ(watch(State::off, 40), std::string(40, '.'));
    EXPECT_EQ(watch(State::on, 40), std::string(40, '#'));
    EXPECT_EQ(watch(State::blinking, 16), flash + gap + flash + gap);
    EXPECT_EQ(watch(State::flickering, 6), "#.#.#.");
    EXPECT_EQ(watch(State::flash1, 64), flash + pause1 + flash + pause1);
    EXPECT_EQ(watch(State::flash2, 64), flash + gap + flash + pause + flash + gap + flash + pause);
    const std::string three = flash + gap + flash + gap + flash + pause;
    EXPECT_EQ(watch(State::flash3, 80), three + three);
    const std::string four = flash + gap + flash + gap + flash + gap + flash + pause;
    EXPECT_EQ(watch(State::flash4, 96), four + four);
}

TEST(Indicator, ShiftDelaysTheFlashPatternOfAnLed) {
    verifies<req::AO4_LED_006>();
    EXPECT_EQ(watch(State::blinking, 12, milliseconds(200)), gap + flash + gap);
    EXPECT_EQ(watch(State::flash1, 32, milliseconds(200)), gap + flash + std::string(24, '.'));
}

TEST(Indicator, NextChangeOfTheLedIsTheEndOfThePresentPhase) {
    verifies<req::AO4_LED_008>();
    EXPECT_EQ(indicator_phase(pattern(State::flash2), Instant{} + milliseconds(0), Duration{}).next_change.us, 200000U);
    EXPECT_EQ(indicator_phase(pattern(State::flash2), Instant{} + milliseconds(250), Duration{}).next_change.us,
              400000U);
    EXPECT_EQ(indicator_phase(pattern(State::flash2), Instant{} + milliseconds(700), Duration{}).next_change.us,
              1600000U);
    EXPECT_EQ(indicator_phase(pattern(State::on), Instant{} + milliseconds(700), Duration{}).next_change, never);
}

TEST(Indicator, PatternOf0FlashesIsSteadilyLitEvenIfItHasAPause) {
    verifies<req::AO4_LED_005>();
    const IndicatorPattern lit{0U, milliseconds(1), Duration{}, milliseconds(500)};
    for (const std::uint64_t time : {0U, 1U, 499U, 500U, 1234U}) {
        EXPECT_TRUE(indicator_phase(lit, Instant{} + milliseconds(time), Duration{}).lit) << time;
        EXPECT_EQ(indicator_phase(lit, Instant{} + milliseconds(time), Duration{}).next_change, never) << time;
    }
}

TEST(Indicator, PatternOfDuration0IsSteadilyDark) {
    shows_rule("work is bounded");
    const IndicatorPattern instant{1U, Duration{}, Duration{}, Duration{}};
    EXPECT_FALSE(indicator_phase(instant, Instant{} + milliseconds(7), Duration{}).lit);
    EXPECT_EQ(indicator_phase(instant, Instant{} + milliseconds(7), Duration{}).next_change, never);
}

}  // namespace canproof::test
