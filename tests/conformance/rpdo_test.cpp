// SPDX-License-Identifier: Apache-2.0
// Tests receive PDOs (CiA 301, 7.2.2, 7.5.2.35) on the conformance slave, with the fixture of support/rpdo_bench.hpp.
#include "generated/canopen/requirements.hpp"
#include "tests/support/rpdo_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

// -- When a PDO takes effect ------------------------------------------------------------------------------------------

TEST_F(Rpdo, RpdosOfTypes254And255SetTheirObjectsAtOnce) {
    verifies<req::CO_PDO_001, req::CO_T_TRANSMISSION_TYPE>();
    talk(*this, {
                    {"205#1122", {}},
                    {"605#4000200100000000", {"585#4F00200111000000"}},
                    {"605#4000200200000000", {"585#4F00200222000000"}},
                    {"605#2F001402FE000000", {"585#6000140200000000"}},  // 1400h:2 transmission type of RPDO1: 254
                    {"205#3344", {}},
                    {"605#4000200100000000", {"585#4F00200133000000"}},
                    {"605#4000200200000000", {"585#4F00200244000000"}},
                    {"305#01000200FEFF0080", {}},
                    {"605#4000210100000000", {"585#4B00210101000000"}},
                    {"605#4000210200000000", {"585#4B00210202000000"}},
                    {"605#4000210300000000", {"585#4B002103FEFF0000"}},
                    {"605#4000210400000000", {"585#4B00210400800000"}},
                });
}

TEST_F(Rpdo, RpdosOfTypes0To240WaitForTheSyncAndUseTheLastValues) {
    verifies<req::CO_PDO_002, req::CO_T_TRANSMISSION_TYPE>();
    int value = 0x10;
    for (const char* type : {"00", "01", "02", "F0"}) {
        const std::string last = std::to_string(++value);
        const std::string before = std::to_string(value - 1);
        send("605#2F00200100000000");
        talk(*this, {
                        {std::string{"605#2F001402"} + type + "000000", {"585#6000140200000000"}},
                        {"205#9900", {}},
                        {"205#" + last + "00", {}},
                        {"605#4000200100000000", {"585#4F00200100000000"}},
                        {"080#", {}},
                        {"605#4000200100000000", {"585#4F002001" + last + "000000"}},
                        {"605#2F00200100000000", {"585#6000200100000000"}},
                        {"080#", {}},  // has no effect, because no new RPDO was received
                        {"605#4000200100000000", {"585#4F00200100000000"}},
                    });
    }
}

TEST_F(Rpdo, RpdosOutsideOperationalAreNeitherAppliedNorKept) {
    verifies<req::CO_PDO_003, req::CO_PDO_036>();
    talk(*this, {
                    {"605#2F00140201000000", {"585#6000140200000000"}},  // 1400h:2 transmission type of RPDO1: 1
                    {"205#1122", {}},
                    {"000#8005", {}},
                    {"305#0100020003000400", {}},
                    {"205#3344", {}},
                    {"080#", {}},
                    {"000#0105", {}},
                    {"080#", {}},
                    {"605#4000200100000000", {"585#4F00200100000000"}},
                    {"605#4000210100000000", {"585#4B00210100000000"}},
                    {"205#5566", {}},
                    {"000#0205", {}},  // the stop discards the RPDO that waits for a SYNC
                    {"080#", {}},
                    {"000#0105", {}},
                    {"080#", {}},
                    {"605#4000200100000000", {"585#4F00200100000000"}},
                });
}

// -- Length -----------------------------------------------------------------------------------------------------------

TEST_F(Rpdo, TooShortRpdoIsAnErrorUntilTheRightLengthArrives) {
    verifies<req::CO_PDO_004, req::CO_PDO_020>();
    // The EMCY message has error 8210h, bits 0 and 4 of 1001h (error register), and one listed error.
    talk(*this, {
                    {"305#", {"085#1082110100000000"}},
                    {"305#01", {}},
                    {"305#0100", {}},
                    {"305#010002", {}},
                    {"305#01000200", {}},
                    {"305#0100020003", {}},
                    {"305#010002000300", {}},
                    {"305#01000200030004", {}},
                    {"605#4000210100000000", {"585#4B00210100000000"}},
                    {"605#4001100000000000", {"585#4F01100011000000"}},
                    {"305#0100020003000400", {"085#0000000100000000"}},
                    {"605#4000210100000000", {"585#4B00210101000000"}},
                    {"605#4001100000000000", {"585#4F01100000000000"}},
                });
}

TEST_F(Rpdo, LengthErrorLastsWhileAnyRpdoIsTooShort) {
    verifies<req::CO_PDO_020>();
    talk(*this, {
                    {"305#01", {"085#1082110100000000"}},
                    {"205#11", {}},
                    {"305#0100020003000400", {}},  // the error of RPDO1 is still active
                    {"205#1122", {"085#0000000100000000"}},
                });
}

TEST_F(Rpdo, RpdoLongerThanItsMappingSetsTheMappedObjects) {
    verifies<req::CO_PDO_037>();
    talk(*this, {
                    {"205#112233", {}},
                    {"605#4000200100000000", {"585#4F00200111000000"}},
                    {"605#4000200200000000", {"585#4F00200222000000"}},
                    {"605#4000200300000000", {"585#4F00200300000000"}},
                    {"205#8877665544332211", {}},
                    {"605#4000200100000000", {"585#4F00200188000000"}},
                    {"605#4000200200000000", {"585#4F00200277000000"}},
                });
}

// -- Values -----------------------------------------------------------------------------------------------------------

TEST_F(Rpdo, ValueOutsideItsLimitsDiscardsTheWholeRpdo) {
    verifies<req::CO_PDO_005, req::CO_PDO_034>();
    map_rpdo3({"08030020", "10000022"});  // 2000h:3, then 2200h: -100 … 100
    talk(*this, {
                    {"405#016400", {}},  // 2200h = 100
                    {"605#4000200300000000", {"585#4F00200301000000"}},
                    {"605#4000220000000000", {"585#4B00220064000000"}},
                    {"405#026500", {"085#0082110100000000"}},  // 101 is refused: 8200h, bits 0 and 4 of 1001h
                    {"405#029BFF", {}},                        // -101: the error continues
                    {"605#4000200300000000", {"585#4F00200301000000"}},
                    {"605#4000220000000000", {"585#4B00220064000000"}},
                    {"405#029CFF", {"085#0000000100000000"}},  // 2200h = -100
                    {"605#4000200300000000", {"585#4F00200302000000"}},
                    {"605#4000220000000000", {"585#4B0022009CFF0000"}},
                    {"405#039BFF", {"085#0082110200000000"}},  // 2200h = -101 is refused
                    {"605#4000200300000000", {"585#4F00200302000000"}},
                    {"605#4000220000000000", {"585#4B0022009CFF0000"}},
                });
}

TEST_F(Rpdo, Real32MustNotBeNanAndMustLieWithinItsLimits) {
    verifies<req::CO_PDO_005, req::CO_PDO_034>();
    map_rpdo3({"20000222"});  // maps 2202h, a REAL32 of -10 … 10
    talk(*this, {
                    {"405#00002041", {}},  // 2202h = 10.0
                    {"605#4002220000000000", {"585#4302220000002041"}},
                    {"405#01002041", {"085#0082110100000000"}},  // the next REAL32 above 10.0 is refused
                    {"405#0000C07F", {}},                        // 2202h = NaN
                    {"405#0000807F", {}},                        // 2202h = infinity
                    {"605#4002220000000000", {"585#4302220000002041"}},
                    {"405#000020C1", {"085#0000000100000000"}},  // 2202h = -10.0
                    {"605#4002220000000000", {"585#43022200000020C1"}},
                });
}

TEST_F(Rpdo, RpdoBitsAreCountedFromTheLeastSignificantOfTheFirstByte) {
    verifies<req::CO_PDO_001>();
    // Maps 2002h:1 and 2002h:2 (bits 0 and 1), a gap of one bit (bit 2), 2100h:1 (bits 3 to 18) and 2002h:3 (bit 19).
    map_rpdo3({"01010220", "01020220", "01000100", "10010021", "01030220"});
    // To set 2100h:1 = 1234h, 2002h:2 = 1 and 2002h:3 = 1: 1234h << 3 = 91A0h, plus bits 1 and 19: 891A2h.
    talk(*this, {
                    {"405#A29108", {}},
                    {"605#4002200100000000", {"585#4F02200100000000"}},
                    {"605#4002200200000000", {"585#4F02200201000000"}},
                    {"605#4000210100000000", {"585#4B00210134120000"}},
                    {"605#4002200300000000", {"585#4F02200301000000"}},
                    {"405#F1FFF7", {}},  // bits 0 and 4 to 18 are set: 2002h:1 = 1, 2100h:1 = FFFEh (-2), 2002h:3 = 0;
                                         // bits 20 to 23 are not mapped
                    {"605#4002200100000000", {"585#4F02200101000000"}},
                    {"605#4002200200000000", {"585#4F02200200000000"}},
                    {"605#4000210100000000", {"585#4B002101FEFF0000"}},
                    {"605#4002200300000000", {"585#4F02200300000000"}},
                });
}

TEST_F(Rpdo, DummyEntriesSkipTheirBits) {
    verifies<req::CO_PDO_012>();
    // Maps the dummies INTEGER8, INTEGER16 and UNSIGNED8, then 2000h:4, then the dummy UNSIGNED16.
    map_rpdo3({"08000200", "10000300", "08000500", "08040020", "10000600"});
    talk(*this, {
                    {"405#1122223344", {"085#1082110100000000"}},  // too short: with the dummies, 7 bytes are mapped
                    {"405#11222233445555", {"085#0000000100000000"}},
                    {"605#4000200400000000", {"585#4F00200444000000"}},
                });
}

TEST_F(Rpdo, RpdoOf64BitsCanCarryOneValueOrEight) {
    verifies<req::CO_PDO_001>();
    map_rpdo3({"40000622"});  // maps 2206h: UNSIGNED64
    talk(*this, {
                    {"405#0123456789ABCDEF", {}},
                    {"605#4006220000000000", {"585#4106220008000000"}},  // eight bytes are uploaded in segments
                    {"605#6000000000000000", {"585#000123456789ABCD"}},
                    {"605#7000000000000000", {"585#1DEF000000000000"}},
                });
    map_rpdo3({"08010020", "08020020", "08030020", "08040020", "08050020", "08060020", "08070020", "08080020"});
    talk(*this, {
                    {"405#0123456789ABCDEF", {}},
                    {"605#4000200100000000", {"585#4F00200101000000"}},
                    {"605#4000200200000000", {"585#4F00200223000000"}},
                    {"605#4000200300000000", {"585#4F00200345000000"}},
                    {"605#4000200400000000", {"585#4F00200467000000"}},
                    {"605#4000200500000000", {"585#4F00200589000000"}},
                    {"605#4000200600000000", {"585#4F002006AB000000"}},
                    {"605#4000200700000000", {"585#4F002007CD000000"}},
                    {"605#4000200800000000", {"585#4F002008EF000000"}},
                });
}

// -- Identifiers ------------------------------------------------------------------------------------------------------

TEST_F(Rpdo, OnlyDataFramesOfTheElevenBitIdentifierAreAccepted) {
    verifies<req::CO_PDO_006, req::CO_FRAME_001>();
    talk(*this, {
                    {"00000205#1122", {}},  // ignored: 205h as a 29-bit identifier
                    {"204#1122", {}},
                    {"405#1122", {}},  // RPDO3 is not valid
                    {"205#R2", {}},    // RPDO1 does not answer remote frames
                    {"605#4000200100000000", {"585#4F00200100000000"}},
                    // 1400h:1 COB-ID of RPDO1 with bit 31: not valid
                    {"605#2300140105020080", {"585#6000140100000000"}},
                    {"205#1122", {}},
                    {"605#4000200100000000", {"585#4F00200100000000"}},
                    {"605#2300140115020000", {"585#6000140100000000"}},  // 1400h:1 COB-ID of RPDO1: 215h
                    {"205#1122", {}},
                    {"605#4000200100000000", {"585#4F00200100000000"}},
                    {"215#1122", {}},
                    {"605#4000200100000000", {"585#4F00200111000000"}},
                });
}

TEST_F(Rpdo, TwoRpdosWithOneIdentifierEachSetTheirMappedObjects) {
    verifies<req::CO_PDO_059>();
    map_rpdo3({"08000500", "08030020"});  // maps a gap of 8 bits, then 2000h:3
    talk(*this, {
                    {"605#2302140105020080", {"585#6002140100000000"}},
                    // 1402h:1 COB-ID of RPDO3: the identifier of RPDO1
                    {"605#2302140105020000", {"585#6002140100000000"}},
                    {"205#1122", {}},
                    {"605#4000200100000000", {"585#4F00200111000000"}},
                    {"605#4000200200000000", {"585#4F00200222000000"}},
                    {"605#4000200300000000", {"585#4F00200322000000"}},
                });
}

// -- Monitoring by the event timer ------------------------------------------------------------------------------------

TEST_F(Rpdo, MissingRpdoIsAnErrorUntilTheNextReception) {
    verifies<req::CO_PDO_021, req::CO_PDO_066, req::CO_PDO_067>();
    talk(*this, {
                    {"605#2F29100101000000", {"585#6029100100000000"}},  // 1029h:1 error behaviour: no change of state
                    {"605#2B00140532000000", {"585#6000140500000000"}},  // 1400h:5 event timer of RPDO1: 50 ms
                });
    EXPECT_TRUE(pass(1000).empty());  // not monitored yet: the monitoring begins with the first reception
    EXPECT_TRUE(send("205#1122").empty());
    EXPECT_TRUE(pass(49).empty());
    EXPECT_TRUE(send("205#1122").empty());
    EXPECT_EQ(pass(60), (Frames{"50:085#5082110100000000"}));  // error 8250h
    EXPECT_TRUE(pass(1000).empty());
    EXPECT_EQ(send("205#1122"), (Frames{"085#0000000100000000"}));
    EXPECT_EQ(pass(60), (Frames{"50:085#5082110200000000"}));
    EXPECT_TRUE(send("205#11").size() == 1U);  // too short: error 8210h; it does not count as received
    EXPECT_EQ(send("605#4001100000000000"), (Frames{"585#4F01100011000000"}));
}

TEST_F(Rpdo, LeavingOperationalEndsRpdoMonitoringAndKeepsATimeOutError) {
    verifies<req::CO_PDO_066, req::CO_PDO_067>();
    send("605#2F29100101000000");
    send("605#2B00140532000000");
    send("205#1122");
    pass(20);
    send("000#8005");
    EXPECT_TRUE(pass(1000).empty());
    send("000#0105");
    EXPECT_TRUE(pass(1000).empty());
    send("205#1122");
    EXPECT_EQ(pass(50), (Frames{"50:085#5082110100000000"}));
    send("000#8005");
    EXPECT_EQ(send("605#4001100000000000"), (Frames{"585#4F01100011000000"}));
    send("000#0105");
    EXPECT_EQ(send("205#1122"), (Frames{"085#0000000100000000"}));
}

TEST_F(Rpdo, RpdoTimeOutChangesTheStateAsACommunicationError) {
    verifies<req::CO_PDO_032>();
    send("605#2B00140532000000");
    const int before = device->communication_errors();
    send("205#1122");
    EXPECT_EQ(pass(50), (Frames{"50:085#5082110100000000"}));
    EXPECT_EQ(device->node().state(), NmtState::pre_operational);  // because 1029h:1 (error behaviour) is 0
    EXPECT_EQ(device->communication_errors(), before + 1);
    send("000#0105");
    EXPECT_EQ(device->node().state(), NmtState::operational);
    EXPECT_EQ(send("205#1122"), (Frames{"085#0000000100000000"}));
    EXPECT_EQ(device->communication_errors(), before + 2);
    send("605#2F29100102000000");  // 1029h:1 error behaviour: stopped
    EXPECT_EQ(pass(50), (Frames{"50:085#5082110200000000"}));
    EXPECT_EQ(device->node().state(), NmtState::stopped);
}

TEST_F(Rpdo, LengthErrorDuringATimeOutIsNoNewCommunicationError) {
    verifies<req::CO_PDO_032, req::CO_PDO_020>();
    send("605#2B00140532000000");  // 1400h:5 event timer of RPDO1: 50 ms
    send("205#1122");
    EXPECT_EQ(pass(50), (Frames{"50:085#5082110100000000"}));
    EXPECT_EQ(device->node().state(), NmtState::pre_operational);  // because 1029h:1 (error behaviour) is 0
    send("000#0105");
    const int before = device->communication_errors();
    EXPECT_EQ(send("305#11"), (Frames{"085#1082110200000000"}));  // RPDO2 is too short
    EXPECT_EQ(device->node().state(), NmtState::operational);
    EXPECT_EQ(device->communication_errors(), before);
}

TEST_F(Rpdo, EachRpdoHasItsOwnEventTimer) {
    verifies<req::CO_PDO_021>();
    send("605#2F29100101000000");
    send("605#2B0014050A000000");  // 1400h:5 event timer of RPDO1: 10 ms
    send("605#2B01140514000000");  // 1401h:5 event timer of RPDO2: 20 ms
    send("205#1122");
    send("305#0100020003000400");
    EXPECT_EQ(pass(10), (Frames{"10:085#5082110100000000"}));
    EXPECT_TRUE(pass(10).empty());          // RPDO2 is overdue too, but error 8250h is not sent again while it is
                                            // active
    EXPECT_TRUE(send("205#1122").empty());  // RPDO2 is still overdue
    EXPECT_EQ(send("305#0100020003000400"), (Frames{"085#0000000100000000"}));
}

TEST_F(Rpdo, RpdoEventTimersStopWhenTheNodeLeavesOperational) {
    verifies<req::CO_PDO_066>();
    send("605#2F29100101000000");
    send("605#2B0014050A000000");  // 1400h:5 event timer of RPDO1: 10 ms
    send("605#2B01140564000000");  // 1401h:5 event timer of RPDO2: 100 ms
    send("205#1122");
    send("000#8005");
    send("000#0105");
    EXPECT_TRUE(send("305#0100020003000400").empty());
    EXPECT_TRUE(pass(99).empty());  // RPDO1 was not received again, so it is not monitored
    EXPECT_EQ(pass(1), (Frames{"1:085#5082110100000000"}));
}

TEST_F(Rpdo, WriteToAParameterOfAnRpdoEndsItsTimeOutErrorAndDropsItsWaitingValues) {
    verifies<req::CO_PDO_022, req::CO_PDO_039>();
    send("605#2F29100101000000");
    send("605#2B0014050A000000");
    send("205#1122");
    EXPECT_EQ(pass(10), (Frames{"10:085#5082110100000000"}));
    // switching the event timer off ends the error together with the monitoring
    EXPECT_EQ(send("605#2B00140500000000"), (Frames{"085#0000000100000000", "585#6000140500000000"}));
    send("205#1122");
    EXPECT_TRUE(pass(100).empty());
    send("605#2F00140201000000");
    send("605#2F00200100000000");
    send("205#3344");
    send("605#2F00140200000000");  // the transmission type changes from 1 to 0 while values wait
    send("080#");
    EXPECT_EQ(send("605#4000200100000000"), (Frames{"585#4F00200100000000"}));
}

TEST_F(Rpdo, ResetCommunicationEndsTimeOutAndLengthErrorsOfRpdos) {
    verifies<req::CO_PDO_020, req::CO_PDO_021>();
    send("605#2F29100101000000");
    send("605#2B0014050A000000");
    send("205#1122");
    pass(10);
    send("305#01");
    send("000#8205");  // reset communication
    EXPECT_EQ(send("605#4001100000000000"), (Frames{"585#4F01100000000000"}));
    EXPECT_TRUE(pass(100).empty());
}

}  // namespace canproof::test
