// SPDX-License-Identifier: Apache-2.0
// Tests process values and averages of the AX188001 (manual, 1.1, 1.2).
#include "devices/ax188001/firmware/process_value.hpp"

#include <gtest/gtest.h>

#include "generated/ax188001/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax188001;

constexpr Scaling shipped{16.0, 4368.0};
constexpr Scaling fahrenheit{18.0, 320.0};
constexpr ReservedValues reserved{-1, -512};

}  // namespace

TEST(ProcessValue, ProcessValueIsInSixteenthsOfADegreeFromMinus273AsShipped) {
    verifies<req::TCS_VAL_002>();
    EXPECT_EQ(process_value(0.0, shipped), 4368);
    EXPECT_EQ(process_value(100.0, shipped), 5968);
    EXPECT_EQ(process_value(-273.0, shipped), 0);
    EXPECT_EQ(process_value(1735.0, shipped), 32128);
}

TEST(ProcessValue, ProcessValueCanBeScaledToTenthsOfADegreeFahrenheit) {
    verifies<req::TCS_VAL_003>();
    EXPECT_EQ(process_value(0.0, fahrenheit), 320);
    EXPECT_EQ(process_value(100.0, fahrenheit), 2120);
    EXPECT_EQ(process_value(-40.0, fahrenheit), -400);
}

TEST(ProcessValue, ProcessValueRoundsHalvesAwayFromZero) {
    verifies<req::TCS_VAL_001>();
    const Scaling one{1.0, 0.0};
    EXPECT_EQ(process_value(2.5, one), 3);
    EXPECT_EQ(process_value(-2.5, one), -3);
    EXPECT_EQ(process_value(2.499, one), 2);
    EXPECT_EQ(process_value(0.03125, shipped), 4369);  // 0.03125 degC are half a count: 4368 + 0.5 is rounded up
}

TEST(ProcessValue, ProcessValueIsClampedTo16Bits) {
    verifies<req::TCS_VAL_004>();
    EXPECT_EQ(process_value(1820.0, shipped), 32767);
    EXPECT_EQ(process_value(1820.0, Scaling{-1000.0, 0.0}), -32768);
    EXPECT_EQ(process_value(32767.4, Scaling{1.0, 0.0}), 32767);
    EXPECT_EQ(process_value(-32768.4, Scaling{1.0, 0.0}), -32768);
    EXPECT_EQ(process_value(1000.25, Scaling{1100.0, 0.0}), 32767);  // 1,100,275
    EXPECT_EQ(process_value(1000.25, Scaling{1100.5, 0.0}), 32767);  // 1,100,775.125
    EXPECT_EQ(process_value(-270.5, Scaling{1.0e16, 0.0}), -32768);  // -2.705e18, of which a double holds no fraction
}

TEST(ProcessValue, MeasuredProcessValueIsNeverAReservedValue) {
    verifies<req::TCS_VAL_007>();
    // -17.8333 degC is -0.1 °F, the process value -1; -46.222 degC is -51.2 °F, the process value -512
    EXPECT_EQ(process_value(-321.0 / 18.0, fahrenheit), -1);
    EXPECT_EQ(measured_process_value(-321.0 / 18.0, fahrenheit, reserved), 0);
    EXPECT_EQ(measured_process_value(-832.0 / 18.0, fahrenheit, reserved), -511);
    EXPECT_EQ(measured_process_value(-322.0 / 18.0, fahrenheit, reserved), -2);
    EXPECT_EQ(measured_process_value(-833.0 / 18.0, fahrenheit, reserved), -513);
}

TEST(Average, AverageLeavesOutInvalidChannels) {
    verifies<req::TCS_AVG_001, req::TCS_AVG_005>();
    const auto both = average(std::array<Measurement, 2>{{{10.0, true}, {20.0, true}}});
    EXPECT_TRUE(both.valid);
    EXPECT_EQ(both.value, 15.0);
    EXPECT_EQ(average(std::array<Measurement, 2>{{{10.0, true}, {20.0, false}}}).value, 10.0);
    EXPECT_EQ(average(std::array<Measurement, 2>{{{10.0, false}, {20.0, true}}}).value, 20.0);
    EXPECT_FALSE((average(std::array<Measurement, 2>{{{10.0, false}, {20.0, false}}}).valid));
}

}  // namespace canproof::test
