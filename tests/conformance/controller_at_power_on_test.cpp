// SPDX-License-Identifier: Apache-2.0
// Tests the state of the CAN controller at power-on (CiA 301, 7.2.7.1): errors found at boot-up are reported when the
// bus works.
#include "generated/canopen/requirements.hpp"
#include "tests/support/lss_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class ControllerAtPowerOn : public testing::Test, public LssBench {
  protected:
    /// Starts node 5, whose stored LSS configuration cannot be read: error 6300h, shown by bit 0 of 1001h.
    Frames start_damaged() { return start({5, 125000, true}); }
    Frames recover() {
        device->node().set_controller(0, overrun, now);
        return sent();
    }
};

}  // namespace

/// The boot-up message, which cannot be sent during bus-off, is lost. The errors found at boot-up are reported later.
TEST_F(ControllerAtPowerOn, ErrorFoundDuringBusOffIsReportedAfterBusOff) {
    verifies<req::CO_EMCY_017, req::CO_EMCY_031, req::CO_NMT_012>();
    can_state = 3;
    EXPECT_EQ(start_damaged(), Frames{});
    EXPECT_EQ(pass(1000), Frames{});
    // The messages of 6300h (damaged data) and 8120h (error passive) wait; 1003h (error list) has both errors, and
    // 1001h (error register) shows them. 8140h (recovered from bus-off) is the third error; the end of 8120h is last.
    EXPECT_EQ(recover(),
              (Frames{"085#0063110200000000", "085#2081110200000000", "085#4081110300000000", "085#0000010300000000"}));
    EXPECT_EQ(pass(1000), Frames{});
}

TEST_F(ControllerAtPowerOn, FramesLostAtPowerOnAreReportedAfterTheBootUpMessage) {
    verifies<req::CO_EMCY_016>();
    overrun = true;
    EXPECT_EQ(power_on(), (Frames{"705#00", "085#1081110100000000"}));
    overrun = false;
    EXPECT_EQ(recover(), (Frames{"085#0000000100000000"}));
}

TEST_F(ControllerAtPowerOn, ErrorPassiveIsReportedAfterTheBootUpMessage) {
    verifies<req::CO_EMCY_016>();
    can_state = 2;
    EXPECT_EQ(power_on(), (Frames{"705#00", "085#2081110100000000"}));
    EXPECT_EQ(recover(), (Frames{"085#0000000100000000"}));
}

TEST_F(ControllerAtPowerOn, WarningLimitIsNotReportedAsAnError) {
    verifies<req::CO_EMCY_016>();
    can_state = 1;
    EXPECT_EQ(power_on(), (Frames{"705#00"}));
}

TEST_F(ControllerAtPowerOn, StoringTheLssConfigurationAgainEndsTheErrorOfDamagedData) {
    verifies<req::CO_LSS_016, req::CO_LSS_087>();
    EXPECT_EQ(start_damaged(), (Frames{"705#00", "085#0063010100000000"}));
    send("7E5#0401000000000000");
    EXPECT_EQ(send("7E5#1700000000000000"), (Frames{"7E4#1700000000000000"}));
    EXPECT_EQ(send("000#8205"), (Frames{"705#00", "085#0000000000000000"}));
    EXPECT_EQ(send("000#8105"), (Frames{"705#00"}));
}

/// The device is switched off during bus-off, and switched on again when the bus works.
TEST_F(ControllerAtPowerOn, PowerOnClearsTheBusOffOfThePreviousPowerCycle) {
    verifies<req::CO_EMCY_017>();
    device->node().set_controller(3, true, now);
    EXPECT_EQ(sent(), Frames{});
    device->power_on({5, 125000}, now);
    EXPECT_EQ(sent(), (Frames{"705#00"}));
}

}  // namespace canproof::test
