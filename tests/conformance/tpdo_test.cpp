// SPDX-License-Identifier: Apache-2.0
// Tests transmit PDOs of types 254 and 255 (CiA 301, 7.2.2, 7.5.2.37): entering operational, changes of values, and
// parameters.
#include "generated/canopen/requirements.hpp"
#include "tests/conformance/tpdo_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

// -- Entering and leaving operational ---------------------------------------------------------------------------------

TEST_F(Tpdo, EventDrivenTpdosAreSentOnceOnEnteringOperational) {
    verifies<req::CO_PDO_018>();
    talk(*this, {
                    {"000#0105", {"185#0000"}},
                    {"000#0105", {}},  // no TPDO: the node is already operational
                    {"000#8005", {}},
                    {"605#2F01200155000000", {"585#6001200100000000"}},
                    {"000#0105", {"185#5500"}},
                    {"605#2F001802FF000000", {"185#5500", "585#6000180200000000"}},
                    {"000#0205", {}},
                    {"000#0105", {"185#5500"}},
                });
}

TEST_F(Tpdo, NoTpdoIsSentOutsideOperational) {
    verifies<req::CO_PDO_027>();
    talk(*this, {
                    {"605#2B0018050A000000", {"585#6000180500000000"}},  // 1800h:5 event timer of TPDO1: 10 ms
                    {"605#2F01200111000000", {"585#6001200100000000"}},
                    {"080#", {}},
                    {"185#R2", {}},
                    {"285#R8", {}},
                });
    EXPECT_TRUE(pass(100).empty());
    EXPECT_EQ(send("000#0105"), (Frames{"185#1100"}));
    EXPECT_EQ(pass(10), (Frames{"10:185#1100"}));
    talk(*this, {
                    {"000#0205", {}},
                    {"080#", {}},
                    {"185#R2", {}},
                });
    EXPECT_TRUE(pass(100).empty());
}

TEST_F(Tpdo, EventBeforeTheNodeEntersOperationalIsNotSentLater) {
    verifies<req::CO_PDO_052>();
    silence_tpdo2();
    set_type("00");
    talk(*this, {
                    {"605#2F01200111000000", {"585#6001200100000000"}},
                    {"000#0105", {}},
                    {"080#", {}},
                    {"605#2F01200122000000", {"585#6001200100000000"}},
                    {"000#8005", {}},
                    {"000#0105", {}},
                    {"080#", {}},
                });
}

// -- Types 254 and 255 ------------------------------------------------------------------------------------------------

TEST_F(Tpdo, ChangeOfAMappedValueIsSentAtOnce) {
    verifies<req::CO_PDO_015, req::CO_PDO_042, req::CO_T_TRANSMISSION_TYPE>();
    for (const char* type : {"FE", "FF"}) {
        power_on();
        set_type(type);
        start();
        talk(*this, {
                        {"605#2F01200111000000", {"185#1100", "585#6001200100000000"}},
                        {"605#2F01200111000000", {"585#6001200100000000"}},  // the same value
                        {"605#2F01200222000000", {"185#1122", "585#6001200200000000"}},
                        {"605#2F01200333000000", {"585#6001200300000000"}},  // 2001h:3 is not mapped
                        // 2101h:1 is in TPDO2, whose type 1 waits for a SYNC
                        {"605#2B01210101000000", {"585#6001210100000000"}},
                        {"605#2F01200100000000", {"185#0022", "585#6001200100000000"}},
                        {"080#", {"285#0100000000000000"}},
                        {"605#2B01210100000000", {"585#6001210100000000"}},
                    });
    }
}

TEST_F(Tpdo, ChangeByTheLastSegmentOfADownloadIsSentAtOnce) {
    verifies<req::CO_PDO_015>();
    silence_tpdo2();
    send("000#0105");
    talk(*this, {
                    {"605#2101200101000000", {"585#6001200100000000"}},
                    {"605#0D66000000000000", {"185#6600", "585#2000000000000000"}},  // six unused bytes: 0 | 6 << 1 | 1
                });
}

TEST_F(Tpdo, ValuesThatChangeTogetherAreSentTogether) {
    verifies<req::CO_PDO_015, req::CO_PDO_041, req::CO_PDO_042>();
    // TPDO3 and RPDO3 (405h) both map 2200h and 2207h.
    map_tpdo3({"10000022", "20000722"});
    talk(*this, {
                    {"605#2302140105040080", {"585#6002140100000000"}},
                    {"605#2302160110000022", {"585#6002160100000000"}},
                    {"605#2302160220000722", {"585#6002160200000000"}},
                    {"605#2F02160002000000", {"585#6002160000000000"}},
                    {"605#2302140105040000", {"585#6002140100000000"}},
                    {"000#0105", {"185#0000", "385#070000000000"}},
                    {"405#050011223344", {"385#050011223344"}},
                    {"405#050011223344", {}},  // the same values
                    {"405#050011223345", {"385#050011223345"}},
                    // 101 is above the maximum of 2200h: the whole RPDO is refused, and no value changes
                    {"405#650011223344", {"085#0082110100000000"}},
                });
}

TEST_F(Tpdo, ValueChangedByTheDeviceIsSent) {
    verifies<req::CO_PDO_015>();
    start();
    device->objects().write(0x2001, 2, 0x77);
    device->node().process_value_changed(0x2001, 2, now);
    EXPECT_LE(device->next_deadline(), now);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"185#0077"}));
    device->node().process_value_changed(0x2001, 3, now);  // 2001h:3 is not mapped
    device->node().process_value_changed(0x2101, 1, now);  // TPDO2 is of type 1
    device->advance(now);
    EXPECT_TRUE(sent().empty());
    EXPECT_EQ(device->next_deadline(), never);
}

TEST_F(Tpdo, WriteOfTheUnchangedCobIdKeepsTheEventTimerRunning) {
    verifies<req::CO_PDO_025>();
    EXPECT_EQ(send("605#2B00180564000000"), (Frames{"585#6000180500000000"}));  // 1800h:5 event timer of TPDO1: 100 ms
    start();
    EXPECT_TRUE(pass(60).empty());
    // A write of the COB-ID that it already has does not restart the event timer.
    EXPECT_EQ(send("605#2300180185010000"), (Frames{"585#6000180100000000"}));
    EXPECT_EQ(pass(40), (Frames{"40:185#0000"}));
}

TEST_F(Tpdo, ChangeOfTheErrorRegisterIsSent) {
    verifies<req::CO_PDO_015>();
    map_tpdo3({"08000110"});  // maps 1001h
    talk(*this, {
                    {"000#0105", {"185#0000", "385#00"}},
                    {"205#11", {"085#1082110100000000", "385#11"}},  // RPDO1 is too short
                    {"205#22", {}},
                    {"205#1122", {"085#0000000100000000", "385#00"}},
                });
    device->node().set_overrun(true, now);
    EXPECT_EQ(sent().size(), 1U);  // only the emergency message of error 8110h is sent at once
    EXPECT_EQ(pass(1), (Frames{"0:385#11"}));
    device->node().set_overrun(false, now);
    EXPECT_EQ(sent().size(), 1U);
    EXPECT_EQ(pass(1), (Frames{"0:385#00"}));
}

/// The write that ends an error is followed at once by the SDO answer, the emergency message and the TPDO.
TEST_F(Tpdo, ChangeOfTheErrorRegisterByAnSdoWriteIsSentAtOnce) {
    verifies<req::CO_PDO_015>();
    map_tpdo3({"08000110"});       // maps 1001h
    send("605#2316100164001000");  // 1016h:1 consumer heartbeat time: node 10h, 100 ms
    send("605#2F29100101000000");  // 1029h:1 error behaviour: no change of state
    send("000#0105");
    send("710#05");
    EXPECT_EQ(pass(100), (Frames{"100:085#3081110100000000", "100:385#11"}));
    EXPECT_EQ(send("605#2316100100000000"), (Frames{"085#0000000100000000", "385#00", "585#6016100100000000"}));
}

// -- Parameters in operational ----------------------------------------------------------------------------------------

TEST_F(Tpdo, Bit31OfTheCobIdSwitchesATpdoOffAndOn) {
    verifies<req::CO_PDO_006, req::CO_PDO_025>();
    start();
    talk(*this, {
                    {"605#2300180185010080", {"585#6000180100000000"}},
                    {"605#2F01200111000000", {"585#6001200100000000"}},
                    {"185#R2", {}},
                    // 1800h:1 COB-ID of TPDO1 becomes 195h and valid: TPDO1 is sent
                    {"605#2300180195010000", {"195#1100", "585#6000180100000000"}},
                    {"605#2F01200122000000", {"195#2200", "585#6001200100000000"}},
                    {"605#2300180195010080", {"585#6000180100000000"}},
                    {"605#2F001802FD000000", {"585#6000180200000000"}},
                    {"605#2300180185010000", {"585#6000180100000000"}},
                    // 1800h:2 transmission type of TPDO1 changes from 253 to 255
                    {"605#2F001802FF000000", {"185#2200", "585#6000180200000000"}},
                });
}

TEST_F(Tpdo, TpdoWithoutMappedObjectsIsNotSent) {
    verifies<req::CO_PDO_053>();
    talk(*this, {
                    // 1802h:1 COB-ID of TPDO3: valid, although 1A02h:0 (number of mapped objects) is 0
                    {"605#2302180185030000", {"585#6002180100000000"}},
                    {"000#0105", {"185#0000"}},
                    {"385#R8", {}},
                });
}

TEST_F(Tpdo, TpdoBitsArePackedFromTheLeastSignificantOfTheFirstByte) {
    verifies<req::CO_PDO_028>();
    // Maps 2003h:1 and 2003h:2 (bits 0 and 1), 2101h:1 (bits 2 to 17), 2003h:3 (bit 18) and 2001h:3 (bits 19 to 26).
    map_tpdo3({"01010320", "01020320", "10010121", "01030320", "08030120"});
    send("605#2B01210134120000");  // 2101h:1 adds 1234h << 2 = 48D0h
    send("605#2F03200201000000");  // 2003h:2 is bit 1 of the PDO and adds 2h
    send("605#2F03200301000000");  // 2003h:3 is bit 18 of the PDO and adds 40000h
    send("605#2F012003A5000000");  // 2001h:3 adds A5h << 19 = 5280000h
    // the PDO is 2h + 48D0h + 40000h + 5280000h = 52C48D2h
    EXPECT_EQ(send("000#0105"), (Frames{"185#0000", "385#D2482C05"}));
    EXPECT_EQ(send("605#2F03200301000000"), (Frames{"585#6003200300000000"}));
    EXPECT_EQ(send("605#2F03200300000000"), (Frames{"385#D2482805", "585#6003200300000000"}));
}

TEST_F(Tpdo, TpdoOfNineBitsHasTwoBytes) {
    verifies<req::CO_PDO_028>();
    map_tpdo3({"08030120", "01010320"});  // maps 2001h:3 (8 bits) and 2003h:1 (1 bit)
    EXPECT_EQ(send("000#0105"), (Frames{"185#0000", "385#0000"}));
}

TEST_F(Tpdo, TpdoOf64BitsCanBeSent) {
    verifies<req::CO_PDO_028>();
    map_tpdo3({"40000622"});  // maps 2206h: UNSIGNED64
    send("605#2106220008000000");
    send("605#000123456789ABCD");
    send("605#1DEF000000000000");
    EXPECT_EQ(send("000#0105"), (Frames{"185#0000", "385#0123456789ABCDEF"}));
}

}  // namespace canproof::test
