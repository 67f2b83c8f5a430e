// SPDX-License-Identifier: Apache-2.0
// Tests LSS of devices that reset their communication by themselves when they leave LSS configuration, as the Axiomatic
// manuals describe.
#include "generated/canopen/requirements.hpp"
#include "tests/conformance/lss_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// A device that resets itself, with node-ID 80 as in the screen capture of the manuals, and the default bit rate
/// (AX130751 3.1).
class AxLss : public Lss {
  protected:
    AxLss() {
        resets_itself = true;
        start({80, 125000});
    }
};

}  // namespace

// Frames 95 to 102 of the screen capture, at their times (AX130751 3.1.3, AX188001 3.1.1.2, AX060805 4.1.1.2).
TEST_F(AxLss, ReplayOfTheCapturedChangeTo250KbitPerSecondGivesTheSameFrames) {
    verifies<req::CO_LSS_019, req::CO_LSS_018, req::CO_LSS_081>();
    EXPECT_EQ(send("7E5#0401"), Frames{});                  // frame 95 of the capture, 11:42:45.248
    EXPECT_EQ(pass(9220), Frames{});                        //
    EXPECT_EQ(send("7E5#130003"), (Frames{"7E4#130000"}));  // frames 96 and 97, 11:42:54.468
    EXPECT_EQ(pass(4219), Frames{});                        //
    EXPECT_EQ(send("7E5#158813"), Frames{});                // frame 98, 11:42:58.687: a switch delay of 1388h = 5000 ms
    EXPECT_EQ(pass(4999), Frames{});
    EXPECT_EQ(bit_rate(), 125000U);
    EXPECT_EQ(pass(1), Frames{});
    EXPECT_EQ(bit_rate(), 250000U);
    EXPECT_EQ(pass(12892), Frames{});                   // 17.892 s after frame 98
    EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170000"}));  // frames 99 and 100, 11:43:16.579
    EXPECT_EQ(pass(6438), Frames{});                    //
    EXPECT_EQ(send("7E5#0400"), (Frames{"750#00"}));    // frames 101 and 102, 11:43:23.017
    EXPECT_EQ(state(), NmtState::pre_operational);
    EXPECT_EQ(device->stored().node_id, 80);
    EXPECT_EQ(device->stored().bit_rate, 250000U);
}

// AX130751 3.1.2, AX188001 3.1.1.1, AX060805 4.1.1.1
TEST_F(AxLss, LssStepsOfTheManualChangeTheNodeId) {
    verifies<req::CO_LSS_018, req::CO_LSS_081, req::CO_LSS_016>();
    start({127, 125000});  // node-ID and bit rate as shipped
    talk({{"7E5#0401", {}},
          {"7E5#1150", {"7E4#110000"}},
          {"7E5#17", {"7E4#170000"}},
          {"7E5#0400", {"750#00"}},
          {"67F#4000100000000000", {}},
          {"650#4000100000000000", {"5D0#4300100078563412"}}});
    EXPECT_EQ(start(device->stored()), (Frames{"750#00"}));
}

TEST_F(AxLss, LeavingLssConfigurationResetsCommunicationEvenWhenNothingChanged) {
    verifies<req::CO_LSS_018>();
    send("000#0150");
    talk({{"7E5#0401", {}}, {"7E5#0400", {"750#00"}}});
    EXPECT_EQ(state(), NmtState::pre_operational);
    talk(own_address);
    talk({{"7E5#0400000000000000", {"750#00"}}});
}

TEST_F(AxLss, LeavingLssConfigurationResetsCommunicationOnly) {
    verifies<req::CO_LSS_018>();
    talk({{"650#2B17100064000000", {"5D0#6017100000000000"}},  // 1017h producer heartbeat time: 100 ms
          {"650#2F002001AA000000", {"5D0#6000200100000000"}},
          {"7E5#0401", {}},
          {"7E5#0400", {"750#00"}},
          {"650#4017100000000000", {"5D0#4B17100000000000"}},
          {"650#4000200100000000", {"5D0#4F002001AA000000"}}});
}

TEST_F(AxLss, SwitchToLssWaitingInLssWaitingResetsNothing) {
    verifies<req::CO_LSS_018>();
    send("000#0150");
    talk({{"7E5#0400", {}}, {"7E5#0402", {}}});
    EXPECT_EQ(state(), NmtState::operational);
}

TEST_F(Lss, DeviceWithoutSelfResetIsNotResetByLeavingLssConfiguration) {
    verifies<req::CO_LSS_018>();
    configure();
    talk({{"7E5#1107000000000000", {"7E4#1100000000000000"}}, {"7E5#0400000000000000", {}}});
    EXPECT_EQ(device->node().node_id(), 5);
}

}  // namespace canproof::test
