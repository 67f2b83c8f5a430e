// SPDX-License-Identifier: Apache-2.0
// Tests which errors stay in 1003h, the list of active errors of the AX060805 (manual, 4.2.4). The device is node 127
// and sends emergency messages on 0FFh.
#include "generated/ax060805/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_errors.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using List = std::vector<std::uint32_t>;

}  // namespace

TEST_F(Ax060805Errors, EndOfBusOffRemovesNoActiveErrorFromTheList) {
    verifies<req::INC_ERR_002, req::INC_ERR_015, req::CO_EMCY_010>();
    write(0x1029, 1, 1, 1);
    write(0x1029, 2, 1, 1);
    fail_accelerometer();
    for (int round = 0; round < 5; ++round) {
        inputs.can_state = 3;
        set_inputs();
        inputs.can_state = 0;
        EXPECT_EQ(set_inputs(), (Frames{"0FF#4081010000000000"})) << round;  // error FF00h is still active, so the
                                                                             // error register 1001h is 01h
    }
    EXPECT_EQ(listed(), (List{0x0000FF00}));
}

TEST_F(Ax060805Errors, EndOfAnErrorWhoseBeginningStillWaitsIsReportedOnce) {
    verifies<req::INC_ERR_020>();
    const auto overrun = [this](bool lost) {
        inputs.can_overrun = lost;
        return set_inputs();
    };
    EXPECT_EQ(overrun(true), (Frames{"0FF#1081010000000000"}));
    send("000#027F");  // stopped: emergency messages wait
    EXPECT_EQ(overrun(false), Frames{});
    EXPECT_EQ(overrun(true), Frames{});
    EXPECT_EQ(overrun(false), Frames{});  // this end and the beginning that waits cancel each other
    EXPECT_EQ(send("000#807F"), (Frames{"0FF#0000000000000000"}));
}

TEST_F(Ax060805Errors, PowerOnReportsOnlyErrorsThatArePresentAtPowerOn) {
    verifies<req::INC_ERR_006, req::INC_ERR_008>();
    inputs.accelerometer_fault = true;
    EXPECT_EQ(power_on(), (Frames{"77F#00", "0FF#00FF010000000000"}));
    inputs.accelerometer_fault = false;
    inputs.can_overrun = true;
    EXPECT_EQ(power_on(), (Frames{"77F#00", "0FF#1081010000000000"}));
}

TEST_F(Ax060805Errors, ResetCommunicationKeepsTheOrderOfTheErrorList) {
    verifies<req::INC_ERR_002, req::CO_EMCY_011>();
    write(0x1029, 2, 1, 1);
    fail_accelerometer();
    heat(130.0F);  // the temperature error 4200h is the latest error
    EXPECT_EQ(listed(), (List{0x00004200, 0x0000FF00}));
    send("000#8200");
    EXPECT_EQ(listed(), (List{0x00004200, 0x0000FF00}));
    heat(20.0F);
    heat(130.0F);
    fail_accelerometer(false);
    fail_accelerometer();
    send("000#8200");
    EXPECT_EQ(listed(), (List{0x0000FF00, 0x00004200}));
}

TEST_F(Ax060805Errors, ResetCommunicationDoesNotRefillAnEmptiedErrorList) {
    verifies<req::INC_ERR_003, req::CO_EMCY_011>();
    fail_accelerometer();
    write(0x1003, 0, 0, 1);
    EXPECT_EQ(listed(), (List{}));
    send("000#8200");
    EXPECT_EQ(listed(), (List{}));
    EXPECT_EQ(read(0x1001), 1U);  // the error is still active
}

}  // namespace canproof::test
