// SPDX-License-Identifier: Apache-2.0
// Tests receive PDOs and their mapping (CiA 301, 7.2.2, 7.5.2.35, 7.5.2.36; CAN-CBX-AO412, 7.6, 7.7) on node 3.
#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Pdo : public CbxTest {
  protected:
    void SetUp() override {
        CbxTest::SetUp();
        send("000#0103");
    }
    std::string output(int number) {
        return send("603#4011640" + std::to_string(number) + "00000000").at(0).substr(12, 4);
    }
    std::vector<std::string> outputs() { return {output(1), output(2), output(3), output(4)}; }
    void disable_rpdo2() { write("603#2301140103030080"); }
    void enable_rpdo2() { write("603#2301140103030000"); }
};

}  // namespace

TEST_F(Pdo, Rpdo2SetsTheFourOutputsAtOnce) {
    verifies<req::CO_PDO_001, req::AO4_PDO_001, req::AO4_AOUT_005>();
    EXPECT_TRUE(send("303#0100020003000400").empty());
    EXPECT_EQ(output(1), "0100");
    EXPECT_EQ(output(2), "0200");
    EXPECT_EQ(output(3), "0300");
    EXPECT_EQ(output(4), "0400");
}

TEST_F(Pdo, RpdoOfType254IsAppliedAtOnce) {
    verifies<req::CO_PDO_001, req::CO_T_TRANSMISSION_TYPE>();
    write("603#2F011402FE000000");
    send("303#0100020003000400");
    EXPECT_EQ(output(1), "0100");
}

TEST_F(Pdo, SynchronousRpdosWaitForTheSyncAndUseTheLastValues) {
    verifies<req::CO_PDO_002, req::CO_T_TRANSMISSION_TYPE>();
    for (const char* type : {"00", "01", "F0"}) {
        write(std::string{"603#2F011402"} + type + "000000");
        send("303#1111000000000000");
        send("303#2222000000000000");
        EXPECT_NE(output(1), "2222") << type;
        send("080#");
        EXPECT_EQ(output(1), "2222") << type;
        send("303#0000000000000000");
        send("080#");
        EXPECT_EQ(output(1), "0000") << type;
    }
}

TEST_F(Pdo, PreOperationalAppliesNoRpdoAndDropsWaitingRpdos) {
    verifies<req::CO_PDO_003, req::CO_PDO_036>();
    send("000#8003");
    send("303#0100000000000000");
    EXPECT_EQ(output(1), "0000");
    send("000#0103");
    write("603#2F01140201000000");
    send("303#0100000000000000");
    send("000#8003");
    send("000#0103");
    send("080#");
    EXPECT_EQ(output(1), "0000");
}

TEST_F(Pdo, TooShortRpdoChangesNothingAndALongerRpdoSetsTheMappedObjects) {
    verifies<req::CO_PDO_004, req::CO_PDO_037>();
    send("303#1111222233334444");
    for (const char* short_frame : {"303#", "303#0100", "303#01000200030004"}) {
        send(short_frame);
        EXPECT_EQ(outputs(), (std::vector<std::string>{"1111", "2222", "3333", "4444"})) << short_frame;
    }
    disable_rpdo2();
    write("603#2F01160000000000");
    write("603#2F01160001000000");  // maps only the first entry, 6411h:1
    enable_rpdo2();
    send("303#34");
    EXPECT_EQ(outputs(), (std::vector<std::string>{"1111", "2222", "3333", "4444"}));
    send("303#3412FFFFFFFF");
    EXPECT_EQ(outputs(), (std::vector<std::string>{"3412", "2222", "3333", "4444"}));
    send("303#7856");
    EXPECT_EQ(outputs(), (std::vector<std::string>{"7856", "2222", "3333", "4444"}));
}

TEST_F(Pdo, Bit31OfTheCobIdSwitchesTheRpdoOff) {
    verifies<req::CO_PDO_006>();
    disable_rpdo2();
    send("303#0100000000000000");
    EXPECT_EQ(output(1), "0000");
    enable_rpdo2();
    send("303#0100000000000000");
    EXPECT_EQ(output(1), "0100");
}

TEST_F(Pdo, RpdoIdentifierChangesOnlyWhileNotValidAndMayNotBeRestricted) {
    verifies<req::CO_PDO_007, req::CO_PDO_054, req::CO_PDO_055, req::CO_T_RESTRICTED_COB_ID>();
    EXPECT_EQ(send("603#2301140104030000"), (Frames{"583#8001140122000008"}));
    EXPECT_EQ(send("603#2301140103030020"), (Frames{"583#8001140130000906"}));  // refused: 1401h:1 COB-ID with bit 29
    EXPECT_EQ(send("603#2301140103130000"), (Frames{"583#8001140130000906"}));  // refused: 1401h:1 COB-ID with bit 12
    disable_rpdo2();
    write("603#2301140133020000");
    send("233#0100000000000000");
    EXPECT_EQ(output(1), "0100");
    // CiA 301, 7.3.5: 0, 001h-07Fh, 101h-180h, 581h-5FFh, 601h-67Fh, 6E0h-6FFh, 701h-7FFh are restricted
    for (const char* id :
         {"0000", "0100", "7F00", "0101", "8001", "8105", "FF05", "0106", "7F06", "E006", "FF06", "0107", "FF07"}) {
        write("603#2301140133020080");
        EXPECT_EQ(send(std::string{"603#23011401"} + id + "0000"), (Frames{"583#8001140130000906"})) << id;
    }
    // the identifiers next to those ranges are allowed
    for (const char* id : {"8000", "0001", "8101", "8005", "0006", "8006", "DF06", "0007"}) {
        write("603#2301140133020080");
        write(std::string{"603#23011401"} + id + "0000");
        write(std::string{"603#23011401"} + id + "0080");
    }
}

TEST_F(Pdo, ReservedTransmissionTypesAreRefused) {
    verifies<req::CO_PDO_008, req::CO_T_TRANSMISSION_TYPE>();
    for (const char* type : {"F1", "FB", "FC", "FD"}) {
        EXPECT_EQ(send(std::string{"603#2F011402"} + type + "000000"), (Frames{"583#8001140230000906"})) << type;
    }
    EXPECT_EQ(send("603#4001140200000000"), (Frames{"583#4F011402FF000000"}));
}

TEST_F(Pdo, RemappingIsAcceptedInThePrescribedOrderOnly) {
    verifies<req::CO_PDO_009, req::CO_PDO_056>();
    EXPECT_EQ(send("603#2F01160000000000"), (Frames{"583#8001160022000008"}));  // refused: RPDO2 is still valid
    disable_rpdo2();
    EXPECT_EQ(send("603#2301160110021164"), (Frames{"583#8001160122000008"}));  // refused: the count 1601h:0 is still 4
    write("603#2F01160000000000");
    write("603#2301160110041164");  // maps 6411h:4
    write("603#2301160210031164");  // maps 6411h:3
    write("603#2F01160002000000");
    enable_rpdo2();
    send("303#44443333");
    EXPECT_EQ(output(4), "4444");
    EXPECT_EQ(output(3), "3333");
}

TEST_F(Pdo, MappingEntriesMustBeMappable) {
    verifies<req::CO_PDO_010>();
    disable_rpdo2();
    write("603#2F01160000000000");
    EXPECT_EQ(send("603#2301160110013412"), (Frames{"583#8001160100000206"}));  // 1234h is absent
    EXPECT_EQ(send("603#2301160110051164"), (Frames{"583#8001160111000906"}));  // 6411h:5 is absent
    // 1017h (producer heartbeat time) is not mappable
    EXPECT_EQ(send("603#2301160110001710"), (Frames{"583#8001160141000406"}));
    EXPECT_EQ(send("603#2301160108011164"), (Frames{"583#8001160141000406"}));  // refused: 8 of the 16 bits of 6411h:1
}

TEST_F(Pdo, MappingHoldsAtMost64BitsAndNoEmptyEntry) {
    verifies<req::CO_PDO_011, req::CO_PDO_064>();
    disable_rpdo2();
    write("603#2F01160000000000");
    for (const char* entry : {"01", "02", "03"}) {
        write(std::string{"603#230116"} + entry + "20000700");  // maps the dummy UNSIGNED32
    }
    EXPECT_EQ(send("603#2F01160003000000"), (Frames{"583#8001160042000406"}));  // refused: 96 bits in total
    write("603#2F01160002000000");
    write("603#2F01160000000000");
    write("603#2301160200000000");                                              // an empty entry …
    EXPECT_EQ(send("603#2F01160002000000"), (Frames{"583#8001160041000406"}));  // … cannot be counted
}

TEST_F(Pdo, DummyEntriesSkipTheirBits) {
    verifies<req::CO_PDO_012>();
    disable_rpdo2();
    write("603#2F01160000000000");
    write("603#2301160108000500");  // maps the dummy UNSIGNED8
    write("603#2301160210011164");
    write("603#2F01160002000000");
    enable_rpdo2();
    send("303#AA3412");
    EXPECT_EQ(output(1), "3412");
    disable_rpdo2();
    write("603#2F01160000000000");
    EXPECT_EQ(send("603#2301160110000500"), (Frames{"583#8001160141000406"}));  // UNSIGNED8 has 8 bits, not 16
}

TEST_F(Pdo, Rpdo3SetsNoOutputByDefault) {
    verifies<req::AO4_PDO_002>();
    EXPECT_EQ(send("603#4002160000000000"), (Frames{"583#4F02160004000000"}));
    for (const char* sub : {"01", "02", "03", "04"}) {  // each mapping entry is 00030010h: 16 bits of the dummy 0003h
                                                        // (INTEGER16)
        EXPECT_EQ(send(std::string{"603#400216"} + sub + "00000000"),
                  (Frames{std::string{"583#430216"} + sub + "10000300"}));
    }
    send("303#1111222233334444");
    EXPECT_EQ(send("403#5555666677778888"), Frames{});
    EXPECT_EQ(outputs(), (std::vector<std::string>{"1111", "2222", "3333", "4444"}));
}

TEST_F(Pdo, Rpdo3IsValidByDefault) {
    verifies<req::AO4_PDO_002>();
    EXPECT_EQ(send("603#4002140100000000"), (Frames{"583#4302140103040000"}));  // 1402h:1 COB-ID: 400h + 3, valid
}

TEST_F(Pdo, ThereIsNoRpdo1) {
    verifies<req::AO4_PDO_003>();
    EXPECT_EQ(send("603#4000140100000000"), (Frames{"583#8000140100000206"}));
    EXPECT_EQ(send("603#4000160100000000"), (Frames{"583#8000160100000206"}));
    send("203#1111222233334444");
    EXPECT_EQ(output(1), "0000");
}

TEST_F(Pdo, RemoteFrameOnRpdo2ReadsTheOutputs) {
    verifies<req::AO4_PDO_004>();
    send("303#B33E4DC100000400");
    EXPECT_EQ(send("303#R8"), (Frames{"303#B33E4DC100000400"}));
    disable_rpdo2();
    EXPECT_TRUE(send("303#R8").empty());
    write("603#2301140103030040");  // bit 30: no RTR
    EXPECT_TRUE(send("303#R8").empty());
    enable_rpdo2();
    EXPECT_EQ(send("303#R8"), (Frames{"303#B33E4DC100000400"}));
    for (const char* state : {"000#8003", "000#0203"}) {  // pre-operational, stopped
        send(state);
        EXPECT_TRUE(send("303#R8").empty()) << state;
    }
    send("000#0103");
    EXPECT_EQ(send("303#R8"), (Frames{"303#B33E4DC100000400"}));
}

TEST_F(Pdo, RemoteFrameOnRpdo3IsNotAnswered) {
    verifies<req::AO4_PDO_005>();
    EXPECT_TRUE(send("403#R8").empty());
}

TEST_F(Pdo, RemoteFrameReadsTheCommandedValueDuringAnError) {
    verifies<req::AO4_PDO_004>();
    send("303#B33E4DC100000400");
    inputs.internal_fault = true;
    set_inputs();
    EXPECT_EQ(volts(1), 0.0F);
    EXPECT_EQ(send("303#R8"), (Frames{"303#B33E4DC100000400"}));
}

}  // namespace canproof::test
