// SPDX-License-Identifier: Apache-2.0
// Tests the greatest values of times, frequency and temperature threshold of the AX130751 (manual, 1.2 to 1.4, 1.8). If
// the device lost a bit of such a value, the value would be too small.
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751GreatestValues : public Ax130751Blocks {
  protected:
    /// Sets 6220h:3 (DO Write State 1 Output Line), waits for one cycle and returns the state of the relay.
    bool control(int state) {
        set8(0x6220, 3, state);
        pass(1);
        return relay_on();
    }
};

}  // namespace

TEST_F(Ax130751GreatestValues, RelayGoesOffADayAfterItsControlWithTheGreatestOffDelay) {
    verifies<req::AOR_RELAY_012>();
    set32(0x22A2, 1, 86'400'000);
    set8(0x22A0, 1, 1);
    EXPECT_TRUE(control(1));
    EXPECT_TRUE(control(0));
    now = now + milliseconds(86'399'999);
    device->advance(now);
    EXPECT_TRUE(relay_on());
    pass(1);
    EXPECT_FALSE(relay_on());
}

TEST_F(Ax130751GreatestValues, RelayTogglesEachMinuteAtTheGreatestRelayBlinkRate2250h) {
    verifies<req::AOR_RELAY_008>();
    set8(0x2242, 1, 5);
    set16(0x2250, 1, 60000);
    EXPECT_TRUE(control(1));
    pass(59999);
    EXPECT_TRUE(relay_on());
    pass(1);
    EXPECT_FALSE(relay_on());
}

TEST_F(Ax130751GreatestValues, DigitalOutputsToggleEachMinuteAtTheGreatestBlinkRate2223h) {
    verifies<req::AOR_DO_010>();
    for (int output = 1; output <= 2; ++output) {
        set16(0x6310, output, 1020);  // digital output, hotshot
        set8(0x2241, output, 3);      // blinking
        set16(0x2223, output, 60000);
        set8(0x6220, output, 1);
    }
    pass(1);
    pass(59999);
    EXPECT_TRUE(is_on(1));
    EXPECT_TRUE(is_on(2));
    pass(1);
    EXPECT_FALSE(is_on(1));
    EXPECT_FALSE(is_on(2));
}

TEST_F(Ax130751GreatestValues, LongestRampsTakeTenSecondsInBothDirections) {
    verifies<req::AOR_OUT_012, req::AOR_OUT_013>();
    for (int output = 1; output <= 2; ++output) {
        set16(0x2330, output, 10000);
        set16(0x2331, output, 10000);
    }
    set16(0x7300, 1, 5000);  // from 0 to 5 V
    command(2, 5000);
    pass(5000);
    EXPECT_FLOAT_EQ(volts(1), 2.5F);
    EXPECT_FLOAT_EQ(volts(2), 2.5F);
    pass(5000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    EXPECT_FLOAT_EQ(volts(2), 5.0F);
    set16(0x7300, 1, 0);
    command(2, 0);
    pass(5000);
    EXPECT_FLOAT_EQ(volts(1), 2.5F);
    EXPECT_FLOAT_EQ(volts(2), 2.5F);
    pass(5000);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    EXPECT_FLOAT_EQ(volts(2), 0.0F);
}

TEST_F(Ax130751GreatestValues, PwmOutputsHaveUpTo30Kilohertz) {
    verifies<req::AOR_OUT_020>();
    for (int output = 1; output <= 2; ++output) {
        set16(0x6310, output, 40);  // PWM
        no_ramps(output);
        set16(0x2380, output, 30000);
        command(output, 375);  // commands 37.5 %
    }
    pass(1);
    EXPECT_FLOAT_EQ(hertz(1), 30000.0F);
    EXPECT_FLOAT_EQ(hertz(2), 30000.0F);
}

TEST_F(Ax130751GreatestValues, OverTemperatureBeginsAbove150Degrees) {
    verifies<req::AOR_DIAG_004>();
    set8(0x5032, 0, 150);
    inputs.cpu_temperature = 150.0F;
    set_inputs();
    EXPECT_EQ(pass(1), Frames{});
    inputs.cpu_temperature = 150.1F;
    set_inputs();
    EXPECT_EQ(pass(1).size(), 1U);
}

/// A digital output whose control is the temperature goes ON at 5032h (Over Temperature Threshold) and above. It goes
/// OFF at 5032h minus 5033h (Hysteresis to Clear Temperature Fault) and below, see Table 5.
TEST_F(Ax130751GreatestValues, DigitalOutputControlledByTemperatureSwitchesAtUpTo150Degrees) {
    verifies<req::AOR_SRC_007, req::AOR_DO_002>();
    set8(0x5031, 0, 0);
    set8(0x5032, 0, 150);
    set8(0x5033, 0, 10);
    set16(0x6310, 1, 1020);
    set8(0x2340, 1, 9);  // processor temperature
    const auto on_at = [this](float celsius) {
        inputs.cpu_temperature = celsius;
        set_inputs();
        pass(1);
        return is_on(1);
    };
    EXPECT_FALSE(on_at(149.9F));
    EXPECT_TRUE(on_at(150.0F));
    EXPECT_TRUE(on_at(140.1F));
    EXPECT_FALSE(on_at(140.0F));
}

}  // namespace canproof::test
