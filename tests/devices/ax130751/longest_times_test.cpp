// SPDX-License-Identifier: Apache-2.0
// The greatest value of each time of the AX130751 (1.2 to 1.4): a time that lost a bit on its way would end too early.
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751LongestTimes : public Ax130751Blocks {
  protected:
    /// Sets 6220h:3 (DO Write State 1 Output Line), runs a cycle and returns the state of the relay.
    bool control(int state) {
        set8(0x6220, 3, state);
        pass(1);
        return relay_on();
    }
};

}  // namespace

TEST_F(Ax130751LongestTimes, RelayGoesOffADayAfterItsControl) {
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

TEST_F(Ax130751LongestTimes, RelayTogglesEachMinute) {
    verifies<req::AOR_RELAY_008>();
    set8(0x2242, 1, 5);
    set16(0x2250, 1, 60000);
    EXPECT_TRUE(control(1));
    pass(59999);
    EXPECT_TRUE(relay_on());
    pass(1);
    EXPECT_FALSE(relay_on());
}

TEST_F(Ax130751LongestTimes, DigitalOutputsBlinkEachMinute) {
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

TEST_F(Ax130751LongestTimes, RampsTakeTenSecondsInBothDirections) {
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

}  // namespace canproof::test
