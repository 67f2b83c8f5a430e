// SPDX-License-Identifier: Apache-2.0
// Tests emergency messages and the error list (CiA 301, 7.2.7; CAN-CBX-AO412, 7.9.3, 7.9.4, 7.9.14, 7.9.15) on node 3.
#include <fmt/format.h>

#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Errors : public CbxTest {
  protected:
    Frames overrun(bool lost) {
        inputs.can_overrun = lost;
        return set_inputs();
    }
    Frames can_state(std::uint8_t state) {
        inputs.can_state = state;
        return set_inputs();
    }
    std::string listed(int sub) { return send(fmt::format("603#400310{:02X}00000000", sub)).at(0).substr(12); }
    std::string error_register() { return send("603#4001100000000000").at(0).substr(12, 2); }
};

}  // namespace

TEST_F(Errors, EmcyMessageContainsCodeErrorRegisterAndNumberOfListedErrors) {
    verifies<req::CO_EMCY_001, req::AO4_ERR_001, req::AO4_T_ERRORS, req::AO4_OD_1014>();
    EXPECT_EQ(overrun(true), (Frames{"083#1081110100000000"}));
    EXPECT_EQ(can_state(2), (Frames{"083#2081110200000000"}));
}

TEST_F(Errors, ErrorIsSentOnceAtItsStartAndOnceAtItsEnd) {
    verifies<req::CO_EMCY_015, req::CO_EMCY_028, req::CO_EMCY_029, req::AO4_ERR_002, req::AO4_ERR_013,
             req::AO4_ERR_014>();
    EXPECT_EQ(overrun(true).size(), 1U);
    EXPECT_TRUE(overrun(true).empty());
    EXPECT_TRUE(pass(10000).empty());
    EXPECT_EQ(overrun(false), (Frames{"083#0000000100000000"}));
    EXPECT_TRUE(overrun(false).empty());
}

TEST_F(Errors, ErrorRegisterShowsTheActiveErrors) {
    verifies<req::CO_EMCY_012, req::CO_EMCY_025, req::AO4_ERR_006, req::AO4_ERR_017, req::AO4_OD_1001>();
    EXPECT_EQ(error_register(), "00");
    overrun(true);
    EXPECT_EQ(error_register(), "11");
    inputs.internal_fault = true;
    set_inputs();
    EXPECT_EQ(error_register(), "11");
    overrun(false);
    EXPECT_EQ(error_register(), "01");
    inputs.internal_fault = false;
    EXPECT_EQ(set_inputs(), (Frames{"083#0000000200000000"}));
    EXPECT_EQ(error_register(), "00");
}

TEST_F(Errors, Overrun_ErrorPassive_SoftwareFailureAndSyncLengthHaveTheirOwnErrorCodes) {
    verifies<req::CO_EMCY_016, req::AO4_ERR_007, req::AO4_ERR_010, req::AO4_T_ERRORS, req::AO4_ERR_020,
             req::AO4_ERR_022>();
    EXPECT_EQ(overrun(true), (Frames{"083#1081110100000000"}));
    EXPECT_EQ(can_state(2), (Frames{"083#2081110200000000"}));
    EXPECT_EQ(can_state(0), (Frames{"083#0000110200000000"}));  // overrun is still active
    inputs.internal_fault = true;
    EXPECT_EQ(set_inputs(), (Frames{"083#1061110300000000"}));
    EXPECT_TRUE(can_state(1).empty());  // the warning limit is not yet an error
    EXPECT_EQ(send("080#0102"), (Frames{"083#4082110400000000"}));
}

// Section 7.9.4 of the manual lists 5000h (hardware) and 6110h (software) as two separate failures.
TEST_F(Errors, HardwareAndSoftwareFailureAreReportedAsErrorCodes5000hAnd6110h) {
    verifies<req::AO4_ERR_010, req::AO4_ERR_018, req::AO4_T_ERRORS, req::AO4_S_HARDWARE_FAULT>();
    inputs.hardware_fault = true;
    EXPECT_EQ(set_inputs(), (Frames{"083#0050010100000000"}));
    EXPECT_TRUE(set_inputs().empty());
    inputs.internal_fault = true;
    EXPECT_EQ(set_inputs(), (Frames{"083#1061010200000000"}));
    inputs.hardware_fault = false;
    EXPECT_EQ(set_inputs(), (Frames{"083#0000010200000000"}));  // the software failure is still active
    EXPECT_EQ(error_register(), "01");
    inputs.internal_fault = false;
    EXPECT_EQ(set_inputs(), (Frames{"083#0000000200000000"}));
    EXPECT_EQ(listed(1), "10610000");
    EXPECT_EQ(listed(2), "00500000");
    EXPECT_EQ(error_register(), "00");
}

TEST_F(Errors, ErrorListKeepsTheTenLatestErrorsNewestFirst) {
    verifies<req::CO_EMCY_013, req::CO_EMCY_026, req::AO4_ERR_003, req::AO4_ERR_015, req::AO4_ERR_005,
             req::AO4_OD_1003>();
    can_state(2);
    EXPECT_EQ(listed(0), "01000000");
    EXPECT_EQ(listed(1), "20810000");
    for (int i = 0; i < 9; ++i) {
        overrun(true);
        overrun(false);
    }
    EXPECT_EQ(listed(0), "0A000000");
    EXPECT_EQ(listed(1), "10810000");
    EXPECT_EQ(listed(10), "20810000");
    overrun(true);  // the eleventh error
    EXPECT_EQ(listed(0), "0A000000");
    EXPECT_EQ(listed(10), "10810000");
    EXPECT_EQ(send("603#4003100B00000000"), (Frames{"583#8003100B11000906"}));
}

TEST_F(Errors, WritingZeroTo1003hSubIndex0EmptiesTheErrorList) {
    verifies<req::CO_EMCY_014, req::CO_EMCY_027, req::AO4_ERR_004, req::AO4_ERR_016, req::CO_EMCY_032>();
    overrun(true);
    EXPECT_EQ(send("603#2F03100001000000"), (Frames{"583#8003100030000906"}));
    EXPECT_EQ(listed(0), "01000000");
    write("603#2F03100000000000");
    EXPECT_EQ(listed(0), "00000000");
    EXPECT_EQ(listed(1), "00000000");
    EXPECT_EQ(send("603#2303100100000000"), (Frames{"583#8003100102000106"}));
    EXPECT_EQ(error_register(), "11");  // 1001h (error register) still shows the active error, although the list is
                                        // empty
    EXPECT_TRUE(overrun(true).empty());
    EXPECT_EQ(overrun(false), (Frames{"083#0000000000000000"}));  // the end of the error is reported
}

TEST_F(Errors, WritingZeroTo1003hSubIndex0EmptiesAFullErrorListCompletely) {
    verifies<req::CO_EMCY_014, req::AO4_ERR_004>();
    for (int i = 0; i < 10; ++i) {
        overrun(true);
        overrun(false);
    }
    EXPECT_EQ(listed(10), "10810000");
    write("603#2F03100000000000");
    for (int sub = 0; sub <= 10; ++sub) {
        EXPECT_EQ(listed(sub), "00000000") << sub;
    }
}

TEST_F(Errors, RewritingTheSameEmcyCobIdKeepsWaitingMessages) {
    verifies<req::CO_EMCY_020>();
    write("603#2B15100064000000");  // 1015h inhibit time EMCY: 100 * 100 us = 10 ms
    EXPECT_EQ(overrun(true).size(), 1U);
    EXPECT_TRUE(can_state(2).empty());
    write("603#2314100083000000");
    EXPECT_EQ(pass(10), (Frames{"10:083#2081110200000000"}));
}

TEST_F(Errors, Bit31OfTheEmcyCobIdSwitchesEmcyMessagesOff) {
    verifies<req::CO_EMCY_002, req::CO_EMCY_019, req::CO_EMCY_034>();
    write("603#2314100083000080");
    EXPECT_TRUE(overrun(true).empty());
    EXPECT_EQ(listed(1), "10810000");
    EXPECT_EQ(error_register(), "11");
}

TEST_F(Errors, WaitingEmcyMessagesAreDroppedWhenEmcyIsSwitchedOff) {
    verifies<req::CO_EMCY_002>();
    write("603#2B15100064000000");  // 1015h inhibit time EMCY: 100 * 100 us = 10 ms
    EXPECT_EQ(overrun(true).size(), 1U);
    EXPECT_TRUE(can_state(2).empty());
    write("603#2314100083000080");
    EXPECT_TRUE(pass(100).empty());
    write("603#2314100083000000");
    EXPECT_TRUE(pass(100).empty());
    EXPECT_EQ(overrun(false), (Frames{"083#0000110200000000"}));
}

TEST_F(Errors, EmcyMessagesAreAtLeastTheInhibitTimeApart) {
    verifies<req::CO_EMCY_003, req::CO_EMCY_020, req::AO4_OD_1015>();
    write("603#2B15100064000000");  // 1015h inhibit time EMCY: 100 * 100 us = 10 ms
    EXPECT_EQ(overrun(true).size(), 1U);
    EXPECT_TRUE(can_state(2).empty());
    EXPECT_TRUE(overrun(false).empty());
    EXPECT_EQ(pass(20), (Frames{"10:083#2081110200000000", "20:083#0000110200000000"}));
}

TEST_F(Errors, EmcyInhibitTimeRunsFromTheActualTransmissionOfALateMessage) {
    verifies<req::CO_EMCY_003>();
    write("603#2B15100064000000");  // 1015h inhibit time EMCY: 100 * 100 us = 10 ms
    EXPECT_EQ(overrun(true).size(), 1U);
    EXPECT_TRUE(can_state(2).empty());
    EXPECT_TRUE(overrun(false).empty());
    now = now + milliseconds(14);  // 4 ms late
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"083#2081110200000000"}));
    EXPECT_TRUE(pass(9).empty());
    EXPECT_EQ(pass(1), (Frames{"1:083#0000110200000000"}));
}

TEST_F(Errors, ResetCommunicationEndsTheEmcyInhibitTime) {
    verifies<req::CO_EMCY_018>();
    write("603#2B151000E8030000");  // 1015h inhibit time EMCY: 1000 * 100 us = 100 ms
    EXPECT_EQ(overrun(true).size(), 1U);
    EXPECT_TRUE(can_state(2).empty());
    // the reset has emptied 1003h (error list), so the message has 0 as the number of listed errors
    EXPECT_EQ(send("000#8203"), (Frames{"703#00", "083#2081110000000000"}));
}

TEST_F(Errors, DelayedEmcyMessageCarriesTheErrorRegisterOfItsTransmissionTime) {
    verifies<req::CO_EMCY_010, req::AO4_ERR_001>();
    write("603#2B15100064000000");  // 1015h inhibit time EMCY: 100 * 100 us = 10 ms
    EXPECT_EQ(overrun(true), (Frames{"083#1081110100000000"}));
    EXPECT_TRUE(can_state(2).empty());
    EXPECT_TRUE(overrun(false).empty());
    EXPECT_TRUE(can_state(0).empty());
    EXPECT_EQ(error_register(), "00");
    // The messages are 8120h, the end of 8110h and the end of 8120h. When they are sent, 1001h (error register) is 00h,
    // and 1003h (error list) has two entries.
    EXPECT_EQ(pass(30), (Frames{"10:083#2081000200000000", "20:083#0000000200000000", "30:083#0000000200000000"}));
}

TEST_F(Errors, OverrunInStoppedIsReportedAfterStopped) {
    verifies<req::CO_EMCY_004>();
    send("000#0203");
    EXPECT_TRUE(overrun(true).empty());
    EXPECT_EQ(send("000#8003"), (Frames{"083#1081110100000000"}));
}

TEST_F(Errors, ErrorPassiveInStoppedIsReportedAfterStopped) {
    verifies<req::CO_EMCY_004>();
    send("000#0203");
    EXPECT_TRUE(can_state(2).empty());
    EXPECT_TRUE(pass(10).empty());
    EXPECT_EQ(send("000#8003"), (Frames{"083#2081110100000000"}));
}

TEST_F(Errors, EmcyIdentifierIsLockedWhileTheCobIdIsValid) {
    verifies<req::CO_EMCY_005, req::CO_EMCY_021>();
    write("603#2314100083000000");  // a write of the identifier that 1014h already has is accepted
    EXPECT_EQ(send("603#2314100084000000"), (Frames{"583#8014100022000008"}));
    EXPECT_EQ(send("603#2314100083000040"), (Frames{"583#8014100030000906"}));  // refused: bit 30 of 1014h COB-ID EMCY
    EXPECT_EQ(send("603#2314100083080000"), (Frames{"583#8014100030000906"}));  // refused: bit 11 of 1014h COB-ID EMCY
    EXPECT_EQ(send("603#2314100003060080"), (Frames{"583#8014100030000906"}));  // refused: 603h is reserved for SDO
    write("603#2314100083000080");
    write("603#2314100084000000");
    EXPECT_EQ(overrun(true), (Frames{"084#1081110100000000"}));
    write("603#2314100085000080");  // together with bit 31 (not valid), another identifier may be written
    write("603#2314100085000000");
    EXPECT_EQ(overrun(false), (Frames{"085#0000000100000000"}));
}

TEST_F(Errors, ResetCommunicationEmptiesTheErrorHistory) {
    verifies<req::CO_NMT_006, req::AO4_OD_1003>();
    overrun(true);
    EXPECT_EQ(send("603#4003100000000000"), (Frames{"583#4F03100001000000"}));
    EXPECT_EQ(send("000#8203"), (Frames{"703#00"}));
    EXPECT_EQ(error_register(), "11");  // the error is still active
    EXPECT_EQ(send("603#4003100000000000"), (Frames{"583#4F03100000000000"}));
}

TEST_F(Errors, RecoveryFromBusOffIsReportedOnce) {
    verifies<req::CO_EMCY_030, req::CO_EMCY_017, req::CO_EMCY_031, req::AO4_ERR_008, req::AO4_ERR_011,
             req::AO4_ERR_019>();
    EXPECT_TRUE(can_state(3).empty());
    EXPECT_TRUE(overrun(true).empty());
    EXPECT_TRUE(send("603#4001100000000000").empty());
    // Error passive (8120h) and overrun (8110h) occurred while nothing could be sent. Their messages are sent first;
    // 1003h (error list) then has two entries. 8140h (recovered from bus-off) is the third; the end of 8120h follows.
    EXPECT_EQ(can_state(0),
              (Frames{"083#2081110200000000", "083#1081110200000000", "083#4081110300000000", "083#0000110300000000"}));
    EXPECT_EQ(listed(1), "40810000");
    EXPECT_TRUE(pass(1000).empty());
}

TEST_F(Errors, NodeSendsNothingInBusOff) {
    verifies<req::CO_EMCY_017, req::AO4_ERR_011>();
    write("603#2306100050C30000");  // 1006h communication cycle period: 50 ms
    write("603#2305100080000040");
    write("603#2B17100064000000");  // 1017h producer heartbeat time: 100 ms
    EXPECT_EQ(pass(100), (Frames{"50:080#", "100:080#", "100:703#7F"}));
    EXPECT_TRUE(can_state(3).empty());
    EXPECT_TRUE(pass(500).empty());
    EXPECT_EQ(can_state(0).size(),
              3U);  // 8120h, 8140h and the end of 8120h are sent, but nothing of the 500 ms in bus-off
    EXPECT_EQ(pass(100), (Frames{"50:080#", "100:080#", "100:703#7F"}));
}

TEST_F(Errors, EachValueOfTheCanStateSignalIsAStateOfTheController) {
    verifies<req::CO_E_CAN_STATE>();
    EXPECT_TRUE(can_state(1).empty());                          // error warning (state 1) is not reported
    EXPECT_EQ(can_state(2), (Frames{"083#2081110100000000"}));  // error passive is the first listed error
    EXPECT_TRUE(can_state(3).empty());                          // bus-off
    // The recovery (8140h) is the second entry of 1003h (error list). The end of error passive follows.
    EXPECT_EQ(can_state(0), (Frames{"083#4081110200000000", "083#0000000200000000"}));
}

TEST_F(Errors, UnknownControllerStateCountsAsBusOff) {
    verifies<req::AO4_ERR_008>();
    EXPECT_TRUE(can_state(4).empty());
    EXPECT_TRUE(send("603#4001100000000000").empty());
    EXPECT_TRUE(can_state(255).empty());
    EXPECT_TRUE(send("603#4001100000000000").empty());
    EXPECT_EQ(can_state(0), (Frames{"083#2081110100000000", "083#4081110200000000", "083#0000000200000000"}));
}

TEST_F(Errors, ErrorThatOutlastsResetNodeIsReportedAgain) {
    verifies<req::AO4_ERR_012>();
    overrun(true);
    EXPECT_EQ(send("000#8103"), (Frames{"703#00", "083#1081110100000000"}));
    EXPECT_EQ(error_register(), "11");
    EXPECT_EQ(listed(1), "10810000");
    overrun(false);
    can_state(2);
    EXPECT_EQ(send("000#8103"), (Frames{"703#00", "083#2081110100000000"}));
    EXPECT_EQ(error_register(), "11");
    can_state(0);
    inputs.internal_fault = true;
    set_inputs();
    EXPECT_EQ(send("000#8103"), (Frames{"703#00", "083#1061010100000000"}));
    EXPECT_EQ(error_register(), "01");
}

TEST_F(Errors, HardwareFailureThatOutlastsResetNodeIsReportedAgain) {
    verifies<req::AO4_ERR_018, req::AO4_ERR_012>();
    inputs.hardware_fault = true;
    set_inputs();
    EXPECT_EQ(send("000#8103"), (Frames{"703#00", "083#0050010100000000"}));
    EXPECT_EQ(error_register(), "01");
    EXPECT_EQ(listed(1), "00500000");
}

TEST_F(Errors, FlickeringErrorInStoppedIsReportedByAtMostOneStartAndOneEnd) {
    verifies<req::CO_EMCY_006, req::CO_EMCY_022>();
    send("000#0203");
    for (int i = 0; i < 1000; ++i) {
        overrun(true);
        overrun(false);
    }
    // The last overrun has begun and ended: its message (8110h) is sent, then the message of its end. The list has ten
    // errors (0Ah), its maximum, and 1001h (error register) is 0.
    EXPECT_EQ(send("000#8003"), (Frames{"083#1081000A00000000", "083#0000000A00000000"}));
    overrun(true);
    send("000#0203");
    for (int i = 0; i < 1000; ++i) {
        overrun(false);
        overrun(true);
    }
    overrun(false);
    EXPECT_EQ(send("000#8003"), (Frames{"083#0000000A00000000"}));
}

}  // namespace canproof::test
