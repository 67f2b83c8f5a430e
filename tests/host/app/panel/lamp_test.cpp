// SPDX-License-Identifier: Apache-2.0
// Tests the names of LED states, which are derived from the times at which an LED changes. Patterns are taken by hand
// from CAN-CBX-AO412, Table 5, and CiA 303-3.
#include "host/app/panel/lamp.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace canproof::host::test {

namespace {

/// Repeats these times of on, off, on, off … (in ms) until `end_ms`, and returns the name of the LED's pattern at that
/// time.
std::string after(const std::vector<std::uint64_t>& round_ms, std::uint64_t end_ms) {
    LampHistory lamp;
    std::uint64_t at = 0;
    bool lit = true;
    for (std::size_t i = 0; at <= end_ms; ++i) {
        lamp.show(lit, Instant{at * 1000U});
        at += round_ms[i % round_ms.size()];
        lit = !lit;
    }
    return lamp.words(Instant{end_ms * 1000U});
}

}  // namespace

TEST(LampWords, SteadyLampIsDescribedAsOnOrOff) {
    LampHistory lamp;
    EXPECT_EQ(lamp.words(Instant{}), "off");
    EXPECT_TRUE(lamp.show(true, Instant{1000U}));
    EXPECT_FALSE(lamp.show(true, Instant{2000U}));
    EXPECT_EQ(lamp.words(Instant{1500U}), "on");
    EXPECT_EQ(lamp.words(Instant{9000000U}), "on");
    EXPECT_TRUE(lamp.show(false, Instant{9000000U}));
    EXPECT_EQ(lamp.words(Instant{9100000U}), "off");
}

TEST(LampWords, EveryFlashPatternOfTheManualIsRecognised_AtAnyMoment) {
    for (std::uint64_t end_ms = 6000; end_ms < 8000; end_ms += 37) {
        EXPECT_EQ(after({200, 200}, end_ms), "blinking") << end_ms;
        EXPECT_EQ(after({50, 50}, end_ms), "flickering") << end_ms;
        EXPECT_EQ(after({200, 1400}, end_ms), "1 flash") << end_ms;
        EXPECT_EQ(after({200, 200, 200, 1000}, end_ms), "2 flashes") << end_ms;
        EXPECT_EQ(after({200, 200, 200, 200, 200, 1000}, end_ms), "3 flashes") << end_ms;
        EXPECT_EQ(after({200, 200, 200, 200, 200, 200, 200, 1000}, end_ms), "4 flashes") << end_ms;
    }
}

TEST(LampWords, RunLampFollowsCia303) {
    // The run LED is always lit in operational, 200 ms on and 200 ms off in pre-operational, 200 ms on and 1000 ms off
    // in stopped.
    EXPECT_TRUE(indicator_phase(run_lamp(NmtState::operational), Instant{123U}, {}).lit);
    EXPECT_EQ(indicator_phase(run_lamp(NmtState::operational), Instant{123U}, {}).next_change, never);
    EXPECT_EQ(run_lamp(NmtState::pre_operational).flashes, 1U);
    EXPECT_EQ(run_lamp(NmtState::pre_operational).on.us, 200000U);
    EXPECT_EQ(run_lamp(NmtState::pre_operational).period().us, 400000U);
    EXPECT_EQ(run_lamp(NmtState::stopped).flashes, 1U);
    EXPECT_EQ(run_lamp(NmtState::stopped).on.us, 200000U);
    EXPECT_EQ(run_lamp(NmtState::stopped).period().us, 1200000U);
    EXPECT_FALSE(indicator_phase(run_lamp(NmtState::initialising), Instant{}, {}).lit);
}

}  // namespace canproof::host::test
