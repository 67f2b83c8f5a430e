// SPDX-License-Identifier: Apache-2.0
// Tests which value of 5555h (Start in Operational Mode) starts an AX130751 at a reset of the communication, and what
// its outputs do then (manual, 1.8, 3.4.86).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751SelfStart : public Ax130751Blocks {
  protected:
    void reset_communication() { send("000#827F"); }
    /// Opens and closes an LSS session, which resets the communication.
    void pass_through_lss() {
        send("7E5#0401");
        send("7E5#0400");
    }
    /// Sets 5555h (Start in Operational Mode) to TRUE, stores all parameters, and powers the device on again. The
    /// device then starts itself.
    void start_by_itself() {
        set8(0x5555, 0, 1);
        EXPECT_FALSE(store().empty());
        power_on();
        pass(1);
        EXPECT_EQ(device->state(), NmtState::operational);
    }
};

}  // namespace

TEST_F(Ax130751SelfStart, UnsavedWriteToStartInOperationalMode5555hStartsNothingAfterAResetOfTheCommunication) {
    verifies<req::AOR_START_005, req::AOR_START_002>();
    send("000#807F");
    set8(0x5555, 0, 1);
    reset_communication();
    pass(100);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    pass_through_lss();
    pass(100);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_EQ(get8(0x5555, 0), 1U) << "the written value stays readable";
    send("000#817F");
    pass(100);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
}

TEST_F(Ax130751SelfStart, StoredStartMode5555hAppliesDespiteAnUnsavedWrite) {
    verifies<req::AOR_START_001>();
    start_by_itself();
    set8(0x5555, 0, 0);
    send("000#807F");
    reset_communication();
    pass(1);
    EXPECT_EQ(device->state(), NmtState::operational);
    send("000#807F");
    pass_through_lss();
    pass(1);
    EXPECT_EQ(device->state(), NmtState::operational);
}

TEST_F(Ax130751SelfStart, SaveOfTheManufacturerParametersStoresStartMode5555h) {
    verifies<req::AOR_START_001, req::AOR_START_005>();
    for (const int group : {1, 4}) {
        SCOPED_TRACE(group);
        send("000#807F");
        set8(0x5555, 0, 1);
        store(2);  // communication parameters
        store(3);  // application parameters
        reset_communication();
        pass(1);
        EXPECT_EQ(device->state(), NmtState::pre_operational);
        store(group);
        reset_communication();
        pass(1);
        EXPECT_EQ(device->state(), NmtState::operational);
        set8(0x5555, 0, 0);
        store(group);
        reset_communication();
        pass(1);
        EXPECT_EQ(device->state(), NmtState::pre_operational);
    }
}

TEST_F(Ax130751SelfStart, RestoreAppliesToStartMode5555hFromTheNextResetNode) {
    verifies<req::AOR_START_001, req::AOR_START_005>();
    start_by_itself();
    restore(1);
    send("000#807F");
    reset_communication();
    pass(1);
    EXPECT_EQ(device->state(), NmtState::operational);
    send("000#817F");
    pass(1);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
}

// 2330h has its default, a ramp of 5 V in 1000 ms: 1.0 V 200 ms after the cycle in which the ramp begins.
TEST_F(Ax130751SelfStart, RampStartsFromOffAfterAResetOfTheCommunicationThatStartsTheNodeAgain) {
    verifies<req::AOR_OUT_045, req::AOR_OUT_026>();
    start_by_itself();
    for (const bool by_lss : {false, true}) {
        SCOPED_TRACE(by_lss);
        command(1, 5000);
        pass(1100);
        EXPECT_FLOAT_EQ(volts(1), 5.0F);
        if (by_lss) {
            pass_through_lss();
        } else {
            reset_communication();
        }
        pass(1);
        EXPECT_EQ(device->state(), NmtState::operational);
        EXPECT_FLOAT_EQ(volts(1), 0.0F);
        pass(1 + 200);
        EXPECT_FLOAT_EQ(volts(1), 1.0F);
    }
}

TEST_F(Ax130751SelfStart, RampStartsFromOffAfterStopAndStartWithinOneCycle) {
    verifies<req::AOR_OUT_045, req::AOR_OUT_026>();
    command(1, 5000);
    pass(1100);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    send("000#027F");
    start();
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    pass(1 + 200);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
}

// The first cycle after a reset of the node, 1 ms later, already drives the outputs, because they were OFF before it.
TEST_F(Ax130751SelfStart, ResetOfTheNodeDelaysNoOutputByACycle) {
    verifies<req::AOR_OUT_041>();
    no_ramps(1);
    set8(0x2342, 1, 0);
    set16(0x7321, 1, 2000);  // the output is 2 V at a control value of 0
    start_by_itself();
    EXPECT_FLOAT_EQ(volts(1), 2.0F);
    send("000#817F");
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 2.0F);
    send("000#807F");
    send("000#817F");
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 2.0F) << "the node has left operational before the reset";
}

TEST_F(Ax130751SelfStart, ReceivedCommandIsValidInTheFirstCycleAfterPowerOn) {
    verifies<req::AOR_SRC_004>();
    set8(0x3010, 0, 1);  // table 1 reads 7300h:1 (AO Output Process Value), which RPDO1 maps
    set8(0x3011, 0, 1);
    set16(0x3017, 1, 700);
    store();
    power_on();
    pass(1);
    EXPECT_EQ(get16(0x3018, 0), 700) << "point 1 is (0, 700), and the command is 0";
}

}  // namespace canproof::test
