// SPDX-License-Identifier: Apache-2.0
// Tests the SYNC consumer and producer (CiA 301, 7.2.5; CAN-CBX-AO412, 7.9.5, 7.9.6, 7.9.19), node 3.
#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class SyncService : public CbxTest {
  protected:
    void make_rpdo2_synchronous() {
        write("603#2F01140201000000");
        send("000#0103");
    }
    std::string output1() { return send("603#4011640100000000").at(0).substr(12, 4); }
};

}  // namespace

TEST_F(SyncService, SyncHasNoDataWithoutACounterAndOneByteWithACounter) {
    verifies<req::CO_SYNC_001>();
    make_rpdo2_synchronous();
    send("303#1100000000000000");
    send("080#");
    EXPECT_EQ(output1(), "1100");
    write("603#2F1910000A000000");  // 1019h synchronous counter overflow value: 10
    send("303#2200000000000000");
    send("080#01");
    EXPECT_EQ(output1(), "2200");
}

TEST_F(SyncService, OnlyADataFrameOfElevenBitsIsASync) {
    verifies<req::CO_SYNC_001>();
    make_rpdo2_synchronous();
    send("303#1100000000000000");
    for (const char* frame : {"00000080#", "080#R0", "00000080#R0"}) {
        EXPECT_TRUE(send(frame).empty()) << frame;
        EXPECT_EQ(output1(), "0000") << frame;
    }
    send("080#");
    EXPECT_EQ(output1(), "1100");
}

TEST_F(SyncService, SyncIsReceivedOnTheIdentifierInSyncCobId1005h) {
    verifies<req::CO_SYNC_001>();
    write("603#2305100090000000");
    make_rpdo2_synchronous();
    send("303#1100000000000000");
    send("080#");
    EXPECT_EQ(output1(), "0000");
    send("090#");
    EXPECT_EQ(output1(), "1100");
}

TEST_F(SyncService, SyncOfWrongLengthIsAnErrorUntilAValidSyncArrives) {
    verifies<req::CO_SYNC_002, req::CO_SYNC_009>();
    make_rpdo2_synchronous();
    send("303#1100000000000000");
    EXPECT_EQ(send("080#01"), (Frames{"083#4082110100000000"}));
    EXPECT_EQ(output1(), "0000");
    EXPECT_TRUE(send("080#01").empty());
    EXPECT_EQ(send("080#"), (Frames{"083#0000000100000000"}));
    EXPECT_EQ(output1(), "1100");
}

TEST_F(SyncService, StoppedNodeDoesNotCheckTheSyncLength) {
    verifies<req::CO_T_SERVICES, req::CO_SYNC_002>();
    send("000#0203");
    EXPECT_TRUE(send("080#01").empty());
    EXPECT_TRUE(send("000#8003").empty());
    EXPECT_EQ(send("080#01"), (Frames{"083#4082110100000000"}));
}

TEST_F(SyncService, SyncIsProducedEachPeriod) {
    verifies<req::CO_SYNC_003, req::CO_SYNC_011>();
    write("603#2306100088130000");  // 1006h communication cycle period: 5000 us
    EXPECT_TRUE(pass(20).empty());  // bit 30 of 1005h (COB-ID SYNC) is clear: the node produces no SYNC
    write("603#2305100080000040");
    EXPECT_EQ(pass(11), (Frames{"5:080#", "10:080#"}));
    send("000#0203");
    EXPECT_TRUE(pass(20).empty());
    send("000#0103");
    EXPECT_EQ(pass(5), (Frames{"5:080#"}));
    write("603#2306100000000000");
    EXPECT_TRUE(pass(20).empty());
}

TEST_F(SyncService, MissedSyncsAreNotSentLater) {
    verifies<req::CO_SYNC_003>();
    write("603#2306100088130000");  // 1006h communication cycle period: 5000 us
    write("603#2305100080000040");
    now = now + milliseconds(17);  // the SYNCs due at 5, 10 and 15 ms were missed
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"080#"}));
    EXPECT_EQ(pass(6), (Frames{"5:080#"}));
}

TEST_F(SyncService, SyncLateByLessThanAPeriodDoesNotDelayTheNextOnes) {
    verifies<req::CO_SYNC_003>();
    write("603#2306100088130000");  // 1006h communication cycle period: 5000 us
    write("603#2305100080000040");
    now = now + milliseconds(7);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"080#"}));
    EXPECT_EQ(pass(8), (Frames{"3:080#", "8:080#"}));  // at 10 and 15 ms
}

TEST_F(SyncService, SyncProducerContinuesWhenTheNodeIsStarted) {
    verifies<req::CO_SYNC_003>();
    write("603#2306100088130000");  // 1006h communication cycle period: 5000 us
    write("603#2305100080000040");
    EXPECT_TRUE(pass(3).empty());
    send("000#0103");
    EXPECT_EQ(pass(2), (Frames{"2:080#"}));
}

TEST_F(SyncService, ResetEndsSyncProductionThatWasNotStored) {
    verifies<req::CO_SYNC_003, req::CO_NMT_005, req::CO_NMT_006>();
    for (const char* reset : {"000#8103", "000#8203"}) {
        write("603#2306100088130000");  // 1006h communication cycle period: 5000 us
        write("603#2305100080000040");
        EXPECT_EQ(pass(5), (Frames{"5:080#"}));
        EXPECT_EQ(send(reset), (Frames{"703#00"}));
        EXPECT_TRUE(pass(10).empty()) << reset;
    }
}

TEST_F(SyncService, SyncIsNotProducedWithoutAPeriod) {
    verifies<req::CO_SYNC_003>();
    write("603#2305100080000040");  // 1005h: SYNC producer, but 1006h (period) is 0
    EXPECT_TRUE(pass(20).empty());
    write("603#2306100088130000");
    EXPECT_EQ(pass(5), (Frames{"5:080#"}));
}

TEST_F(SyncService, SyncCounterRunsFromOneToItsOverflow) {
    verifies<req::CO_SYNC_004>();
    write("603#2F19100003000000");
    write("603#23061000E8030000");  // 1006h communication cycle period: 1 ms
    write("603#2305100080000040");
    EXPECT_EQ(pass(5), (Frames{"1:080#01", "2:080#02", "3:080#03", "4:080#01", "5:080#02"}));
}

TEST_F(SyncService, SyncCounterMayOverflowAt2AndAt240) {
    verifies<req::CO_SYNC_004>();
    write("603#2F19100002000000");
    write("603#23061000E8030000");  // 1006h communication cycle period: 1 ms
    write("603#2305100080000040");
    EXPECT_EQ(pass(3), (Frames{"1:080#01", "2:080#02", "3:080#01"}));
    write("603#2305100080000000");
    write("603#2306100000000000");
    write("603#2F191000F0000000");
    write("603#23061000E8030000");
    write("603#2305100080000040");
    const Frames sent = pass(241);
    ASSERT_EQ(sent.size(), 241U);
    EXPECT_EQ(sent[0], "1:080#01");
    EXPECT_EQ(sent[239], "240:080#F0");
    EXPECT_EQ(sent[240], "241:080#01");
}

TEST_F(SyncService, SyncCounterRestartsAtOneWhenAStoppedNodeContinues) {
    verifies<req::CO_SYNC_004>();
    write("603#2F1910000A000000");
    write("603#23061000E8030000");  // 1006h communication cycle period: 1 ms
    write("603#2305100080000040");
    EXPECT_EQ(pass(2), (Frames{"1:080#01", "2:080#02"}));
    send("000#0203");
    EXPECT_TRUE(pass(5).empty());
    send("000#8003");
    EXPECT_EQ(pass(2), (Frames{"1:080#01", "2:080#02"}));
}

TEST_F(SyncService, SyncProducerAppliesItsOwnRpdosAtTheSyncThatItSends) {
    verifies<req::CO_SYNC_005>();
    make_rpdo2_synchronous();
    write("603#2306100010270000");
    write("603#2305100080000040");
    send("303#1100000000000000");
    EXPECT_EQ(output1(), "0000");
    pass(10);
    EXPECT_EQ(output1(), "1100");
}

TEST_F(SyncService, SyncCounterAndIdentifierAreLockedWhileInUse) {
    verifies<req::CO_SYNC_006, req::CO_SYNC_007, req::CO_SYNC_010>();
    write("603#2306100010270000");
    EXPECT_EQ(send("603#2F1910000A000000"), (Frames{"583#8019100022000008"}));
    EXPECT_EQ(send("603#2F19100000000000"), (Frames{"583#8019100022000008"})) << "not even the value that it has";
    EXPECT_EQ(send("603#2F19100001000000"), (Frames{"583#8019100030000906"})) << "1 is reserved in any case";
    EXPECT_EQ(send("603#2F191000F1000000"), (Frames{"583#8019100030000906"})) << "241 is reserved in any case";
    write("603#2305100080000040");
    EXPECT_EQ(send("603#2305100090000040"), (Frames{"583#8005100022000008"}));
    write("603#2305100080000040");
    write("603#2306100000000000");
    write("603#2F1910000A000000");
    EXPECT_EQ(send("603#2305100090000040"), (Frames{"583#8005100022000008"})) << "bit 30 counts, not the period";
    EXPECT_EQ(send("603#2305100090000000"), (Frames{"583#8005100022000008"})) << "another identifier and no bit 30";
    write("603#2305100080000000");
    write("603#2305100090000040");
}

TEST_F(SyncService, SyncIdentifierMustBeUnrestrictedAndOfElevenBits) {
    verifies<req::CO_SYNC_010, req::CO_SYNC_008, req::AO4_OD_1005>();
    // 1005h COB-ID SYNC: identifier 0, which is that of NMT
    EXPECT_EQ(send("603#2305100000000000"), (Frames{"583#8005100030000906"}));
    EXPECT_EQ(send("603#2305100080000020"), (Frames{"583#8005100030000906"}));  // 1005h COB-ID SYNC with bit 29
    EXPECT_EQ(send("603#2305100080080000"), (Frames{"583#8005100030000906"}));  // 1005h COB-ID SYNC with bit 11
    // The identifiers are the first and the last of each range that CiA 301, 7.3.5 reserves. Each is written without
    // flags, with bit 30 (produce SYNC) and with bit 31.
    for (const char* id : {"7F00", "0101", "8001", "8105", "FF05", "0106", "7F06", "E006", "FF06", "0107", "FF07"}) {
        for (const char* flags : {"0000", "0040", "0080"}) {
            EXPECT_EQ(send(std::string{"603#23051000"} + id + flags), (Frames{"583#8005100030000906"})) << id << flags;
        }
    }
}

TEST_F(SyncService, Bit31OfTheSyncCobIdIsStoredAndHasNoEffect) {
    verifies<req::CO_SYNC_012>();
    write("603#2305100080000080");
    EXPECT_EQ(send("603#4005100000000000"), (Frames{"583#4305100080000080"}));
    make_rpdo2_synchronous();
    send("303#1100000000000000");
    send("080#");
    EXPECT_EQ(output1(), "1100");
}

TEST_F(SyncService, ReservedSyncCounterOverflowValuesAreRefused) {
    verifies<req::CO_SYNC_007, req::CO_SYNC_013, req::AO4_OD_1019>();
    for (const char* value : {"01", "F1", "FF"}) {
        EXPECT_EQ(send(std::string{"603#2F191000"} + value + "000000"), (Frames{"583#8019100030000906"})) << value;
    }
    write("603#2F19100002000000");
    write("603#2F191000F0000000");
    write("603#2F19100000000000");
}

}  // namespace canproof::test
