// SPDX-License-Identifier: Apache-2.0
// Tests that each receive PDO has its own errors and its own event timer, and that a SYNC applies the RPDOs in order of
// their numbers (CiA 301, 7.2.2.2, 7.2.7.1, 7.5.2.35).
#include "generated/canopen/requirements.hpp"
#include "tests/support/rpdo_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST_F(Rpdo, WriteToAParameterOfOneRpdoKeepsTheLengthErrorOfAnother) {
    verifies<req::CO_PDO_020, req::CO_PDO_039>();
    talk(*this, {
                    {"205#11", {"085#1082110100000000"}},
                    {"605#2F011402FE000000", {"585#6001140200000000"}},  // 1401h:2, type 254
                    {"305#01", {}},
                    {"605#2F011402FF000000", {"585#6001140200000000"}},
                    {"205#1122", {"085#0000000100000000"}},
                });
}

TEST_F(Rpdo, LengthErrorOfAnRpdoWhoseTimerRunsEndsWithALongEnoughFrame) {
    verifies<req::CO_PDO_020>();
    send("605#2B0014050A000000");  // 1400h:5 event timer (here a time-out) of RPDO1: 10 ms
    talk(*this, {
                    {"205#1122", {}},
                    {"205#11", {"085#1082110100000000"}},
                    {"205#1122", {"085#0000000100000000"}},
                });
}

TEST_F(Rpdo, WriteToAParameterOfOneRpdoKeepsTheValueErrorOfAnother) {
    verifies<req::CO_PDO_034, req::CO_PDO_039>();
    map_rpdo3({"10000022"});  // maps 2200h, whose maximum is 100
    talk(*this, {
                    {"405#6500", {"085#0082110100000000"}},
                    {"605#2F011402FE000000", {"585#6001140200000000"}},
                    {"405#6400", {"085#0000000100000000"}},
                });
}

TEST_F(Rpdo, WriteToAParameterOfOneRpdoKeepsTheTimeOutOfAnother) {
    verifies<req::CO_PDO_021, req::CO_PDO_039>();
    send("605#2F29100101000000");  // 1029h:1 error behaviour: no change of state
    send("605#2B0014050A000000");  // 1400h:5 event timer (here a time-out) of RPDO1: 10 ms
    send("205#1122");
    EXPECT_EQ(pass(10), (Frames{"10:085#5082110100000000"}));
    EXPECT_EQ(send("605#2F011402FE000000"), (Frames{"585#6001140200000000"}));
    EXPECT_EQ(send("205#1122"), (Frames{"085#0000000100000000"}));
}

TEST_F(Rpdo, TimeOutErrorLastsWhileAnyRpdoIsLate) {
    verifies<req::CO_PDO_021, req::CO_PDO_067>();
    send("605#2F29100101000000");
    send("605#2B0014050A000000");  // 1400h:5 event timer of RPDO1: 10 ms
    send("605#2B01140514000000");  // 1401h:5 event timer of RPDO2: 20 ms
    send("205#1122");
    send("305#0100020003000400");
    EXPECT_EQ(pass(20), (Frames{"10:085#5082110100000000"}));
    EXPECT_TRUE(send("305#0100020003000400").empty());  // RPDO1 is still overdue, so the error does not end
    EXPECT_EQ(send("205#1122"), (Frames{"085#0000000100000000"}));
}

TEST_F(Rpdo, SynchronousRpdoIsMonitoredFromItsReceptionOn) {
    verifies<req::CO_PDO_021>();
    send("605#2F29100101000000");
    send("605#2F00140201000000");  // 1400h:2 transmission type of RPDO1: 1
    send("605#2B0014050A000000");  // 1400h:5 event timer of RPDO1: 10 ms
    send("205#1122");
    EXPECT_TRUE(pass(9).empty());
    EXPECT_EQ(pass(1), (Frames{"1:085#5082110100000000"}));  // the time-out is reported although no SYNC was received
    EXPECT_EQ(send("205#1122"), (Frames{"085#0000000100000000"}));
}

TEST_F(Rpdo, NoDeadlineIsSetAfterTheMonitoringOfAnRpdoHasEnded) {
    verifies<req::CO_PDO_039, req::CO_PDO_040, req::CO_PDO_066>();
    for (const char* end : {"605#2B00140500000000", "605#2F001402FE000000", "000#8005", "000#8205"}) {
        send("605#2B0014050A000000");
        EXPECT_EQ(device->next_deadline().us, never.us) << end;
        send("205#1122");
        EXPECT_EQ(device->next_deadline().us, (now + milliseconds(10)).us) << end;
        send(end);
        EXPECT_EQ(pass(0), Frames{});
        if (end != std::string{"000#8205"}) {  // reset communication makes the TPDOs valid again, and they have
                                               // deadlines
            EXPECT_EQ(device->next_deadline().us, never.us) << end;
            EXPECT_EQ(pass(100), Frames{}) << end;
        }
        send("000#0105");
    }
}

/// RPDO1 and RPDO3 both set 2000h:1. At a SYNC, RPDO3 is applied last, whichever of the two was received first.
TEST_F(Rpdo, SynchronousRpdosAreAppliedInOrderOfTheirNumbers) {
    verifies<req::CO_PDO_002>();
    map_rpdo3({"08010020"});
    send("605#2F00140201000000");
    send("605#2F02140201000000");
    send("205#1122");
    send("405#33");
    send("080#");
    EXPECT_EQ(send("605#4000200100000000"), (Frames{"585#4F00200133000000"}));
    send("405#44");
    send("205#5566");
    send("080#");
    EXPECT_EQ(send("605#4000200100000000"), (Frames{"585#4F00200144000000"}));
}

}  // namespace canproof::test
