// SPDX-License-Identifier: Apache-2.0
// Checks the constants of the CAN-CBX-AO412 (manual, 3.2.1, 7.9.23, 7.10, 7.11) by the behaviour of the device just
// below and just above each constant, within much less than 1 % of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr double step_v = 0.001 * 30.9 / 12.4;  // one step of the converter is 2.492 mV

class CbxEdges : public CbxTest {
  protected:
    void put(int index, int output, int value) {
        const auto bits = static_cast<std::uint16_t>(value);
        write(fmt::format("603#2B{:02X}{:02X}{:02X}{:02X}{:02X}0000", index & 0xFF, index >> 8, output, bits & 0xFF,
                          bits >> 8));
    }
    int steps(int output) const { return static_cast<int>(std::lround(static_cast<double>(volts(output)) / step_v)); }
};

}  // namespace

TEST_F(CbxEdges, CalibrationOffsetOfEachOutputIsExactOnBothSidesOfAStep) {
    verifies<req::AO4_AOUT_004, req::AO4_K_OFFSET_SCALE, req::AO4_OD_2404>();
    // An offset of n moves the output by n * 312.5 uV, rounded to steps of 2.49194 mV (half a step is rounded up). For
    // example 8 * 312.5 / 2491.94 = 1.0032, one step.
    for (int output = 1; output <= 4; ++output) {
        for (const int offset : {3, 4, 8, 11, 12, 1600, 15999, -4, -12, -20000}) {
            put(0x2404, output, offset);
            EXPECT_EQ(steps(output), static_cast<int>(std::floor(offset * 312.5e-6 / step_v + 0.5))) << offset;
        }
    }
}

TEST_F(CbxEdges, CalibrationGainOfEachOutputIsExactToAStep) {
    verifies<req::AO4_AOUT_004, req::AO4_K_GAIN_DIVISOR, req::AO4_OD_2405>();
    for (int output = 1; output <= 4; ++output) {
        put(0x6411, output, 24000);  // 24000 / 8 = 3000 steps
        for (const int gain : {32767, 16384, 100, 43, 44, -44, -20000}) {
            put(0x2405, output, gain);
            EXPECT_EQ(steps(output), static_cast<int>(std::floor((24000 * (1.0 + gain / 262144.0) + 4.0) / 8.0)))
                << gain;
        }
    }
}

TEST_F(CbxEdges, OutputReachesPlusAndMinus4095StepsAtTheCalculatedValues) {
    verifies<req::AO4_AOUT_003, req::AO4_K_DAC_STEPS, req::AO4_K_CODES_PER_STEP>();
    const std::vector<std::pair<int, int>> cases{{32755, 4094},   {32756, 4095},   {32767, 4095},
                                                 {-32757, -4095}, {-32756, -4094}, {-32768, -4095}};
    for (const auto& [value, expected] : cases) {
        put(0x6411, 2, value);
        EXPECT_EQ(steps(2), expected) << value;
    }
}

TEST_F(CbxEdges, SelfStartingNodesTiming1F91hSetsTheDelayOfTheSelfStart) {
    verifies<req::AO4_START_001, req::AO4_OD_1F91>();
    write("603#23801F0008000000");
    write("603#2310100173617665");
    power_on();
    pass(99);  // 100 ms by default
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    pass(1);
    EXPECT_EQ(device->state(), NmtState::operational);
}

TEST_F(CbxEdges, SelfStartDelayIsUpTo65535Milliseconds) {
    verifies<req::AO4_START_001, req::AO4_OD_1F91>();
    write("603#23801F0008000000");
    write("603#2B911F01FFFF0000");
    write("603#2310100173617665");
    power_on();
    pass(65534);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    pass(1);
    EXPECT_EQ(device->state(), NmtState::operational);
}

TEST_F(CbxEdges, EachFlashOfALedLasts200Milliseconds) {
    verifies<req::AO4_LED_008, req::AO4_T5>();
    inputs.internal_fault = true;  // LED M shows two flashes, the first at 200 ms, then a pause of 1000 ms
    set_inputs();
    const std::vector<std::pair<std::uint64_t, bool>> cases{{199, false},  {200, true},  {399, true},  {400, false},
                                                            {599, false},  {600, true},  {799, true},  {800, false},
                                                            {1799, false}, {1800, true}, {1999, true}, {2000, false}};
    for (const auto& [ms, lit] : cases) {
        pass(ms - now.us / 1000);
        EXPECT_EQ(device->outputs().led_m, lit) << ms;
    }
}

}  // namespace canproof::test
