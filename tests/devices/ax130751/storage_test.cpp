// SPDX-License-Identifier: Apache-2.0
// Tests how the AX130751 stores parameters: 1010h (store parameters), 1011h (restore defaults), node-ID and bit rate,
// self-start, identity (manual, 3.1, 3.2.7, 3.2.8, 3.2.11, 3.2.12, 3.4.86 to 3.4.88).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751Storage : public Ax130751Test {
  protected:
    /// Sets the node-ID by LSS as in section 3.1.2: switches to configuration, configures the node-ID, stores it,
    /// switches to waiting.
    Frames give_node_id(unsigned wanted) {
        send("7E5#0401");
        EXPECT_EQ(send(fmt::format("7E5#11{:02X}", wanted)), (Frames{"7E4#110000"}));
        EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170000"}));
        const Frames frames = send("7E5#0400");
        node = wanted;
        return frames;
    }
    void silence_tpdo1() { EXPECT_EQ(write(0x1800, 5, 0, 2), ""); }
};

}  // namespace

// AX130751, 3.1
TEST_F(Ax130751Storage, DeviceShipsAsNode127At125kbit) {
    verifies<req::AOR_NODE_001, req::AOR_K_NODE_ID, req::AOR_K_BIT_RATE>();
    EXPECT_EQ(power_on(), (Frames{"77F#00"}));
    EXPECT_EQ(device->node_id(), 127);
    EXPECT_EQ(device->bit_rate(), 125000U);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
}

TEST_F(Ax130751Storage, WriteToOutputType6310hChangesNoNodeId) {
    verifies<req::AOR_LSS_003, req::AOR_NODE_002>();
    EXPECT_EQ(write(0x6310, 1, 20, 2), "");  // 6310h:1 is the type of output 1
    EXPECT_EQ(power_on(), (Frames{"77F#00"}));
    EXPECT_EQ(read(0x5B51, 0), 127U);
}

// AX130751, 3.1.2
TEST_F(Ax130751Storage, NodeIdSetByLssIsKeptAfterPowerOn) {
    verifies<req::AOR_LSS_001, req::AOR_LSS_003, req::AOR_NODE_003, req::AOR_OD_5B51>();
    start();
    send("000#807F");
    EXPECT_EQ(give_node_id(0x20), (Frames{"720#00"}));
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_EQ(read(0x5B51, 0), 0x20U);
    EXPECT_EQ(power_on(), (Frames{"720#00"}));
    EXPECT_EQ(read(0x5B51, 0), 0x20U);
    EXPECT_EQ(read(0x1400, 1), 0x40000220U);
}

TEST_F(Ax130751Storage, LeavingLssConfigurationSendsBootUpEvenWhenNothingChanged) {
    verifies<req::AOR_LSS_001>();
    send("7E5#0401");
    EXPECT_EQ(send("7E5#0400"), (Frames{"77F#00"}));
    EXPECT_EQ(send("7E5#0400"), Frames{});  // the device was in LSS waiting already
}

// Table 22: the bit rate for each index of the LSS service configure bit timing
TEST_F(Ax130751Storage, LssAcceptsTheBitRatesOfTable22) {
    verifies<req::AOR_T22, req::AOR_LSS_003, req::AOR_NODE_003, req::AOR_OD_5B50>();
    const std::vector<std::pair<int, std::uint32_t>> rates{{0, 1000000}, {1, 666667}, {2, 500000}, {3, 250000},
                                                           {4, 125000},  {6, 50000},  {7, 20000},  {8, 10000}};
    for (const auto& [index, rate] : rates) {
        send("7E5#0401");
        EXPECT_EQ(send(fmt::format("7E5#1300{:02X}", index)), (Frames{"7E4#130000"})) << index;
        send("7E5#150A00");  // both switch delays are 10 ms
        pass(25);
        EXPECT_EQ(device->bit_rate(), rate) << index;
        EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170000"})) << index;
        send("7E5#0400");
        EXPECT_EQ(read(0x5B50, 0), static_cast<std::uint64_t>(index));
        power_on();
        EXPECT_EQ(device->bit_rate(), rate) << index;
        EXPECT_EQ(read(0x5B50, 0), static_cast<std::uint64_t>(index));
    }
    send("7E5#0401");
    EXPECT_EQ(send("7E5#130005"), (Frames{"7E4#130100"}));  // index 5 is reserved
    EXPECT_EQ(send("7E5#130009"), (Frames{"7E4#130100"}));
    EXPECT_EQ(send("7E5#130104"), (Frames{"7E4#130100"}));  // table selector 1 does not exist
}

// The capture in section 3.1.3: node 80 changes from 125 to 250 kbit/s, with delays of 5000 ms = 1388h.
TEST_F(Ax130751Storage, LssSessionOfSection3_1_3ChangesTheBitRateWithTheCapturedFrames) {
    verifies<req::AOR_LSS_001, req::AOR_LSS_003, req::AOR_T22>();
    give_node_id(80);
    EXPECT_EQ(send("7E5#0401"), Frames{});
    EXPECT_EQ(send("7E5#130003"), (Frames{"7E4#130000"}));
    EXPECT_EQ(send("7E5#158813"), Frames{});
    EXPECT_EQ(pass(4999), Frames{});
    EXPECT_EQ(device->bit_rate(), 125000U);
    EXPECT_EQ(pass(1), Frames{});
    EXPECT_EQ(device->bit_rate(), 250000U);
    pass(5000);
    EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170000"}));
    EXPECT_EQ(send("7E5#0400"), (Frames{"750#00"}));
}

// AX130751, 3.2.14, 3.2.15
TEST_F(Ax130751Storage, CobIdsAtTheirDefaultFollowANewNodeId) {
    verifies<req::AOR_LSS_002, req::AOR_LSS_004, req::AOR_OD_1400, req::AOR_OD_1401, req::AOR_OD_1402, req::AOR_OD_1403,
             req::AOR_OD_1800, req::AOR_OD_1801, req::AOR_OD_1802, req::AOR_OD_1803>();
    // RPDO2 gets another identifier than its default, everything is stored, then the node-ID changes.
    EXPECT_EQ(write(0x1401, 1, 0x80000345, 4), "");
    store();
    give_node_id(0x20);
    const std::vector<std::pair<std::uint16_t, std::uint64_t>> expected{
        {0x1400, 0x40000220}, {0x1401, 0x80000345}, {0x1402, 0xC0000420}, {0x1403, 0x40000520},
        {0x1800, 0x400001A0}, {0x1801, 0xC00002A0}, {0x1802, 0xC00003A0}, {0x1803, 0xC00004A0}};
    for (const auto& [index, cob_id] : expected) {
        EXPECT_EQ(read(index, 1), cob_id) << std::hex << index;
    }
    // The node saves another parameter group (1010h:4) under its new node-ID. The stored COB-IDs still follow the
    // node-ID, also when it changes again.
    EXPECT_EQ(write(0x5032, 0, 99, 1), "");
    store(4);
    power_on();
    for (const auto& [index, cob_id] : expected) {
        EXPECT_EQ(read(index, 1), cob_id) << std::hex << index;
    }
    give_node_id(0x21);
    EXPECT_EQ(read(0x1400, 1), 0x40000221U);
    EXPECT_EQ(read(0x1401, 1), 0x80000345U);
    EXPECT_EQ(read(0x1803, 1), 0xC00004A1U);
    EXPECT_EQ(read(0x5032, 0), 99U);
    EXPECT_EQ(write(0x1402, 1, 0x80000346, 4), "");
    give_node_id(0x22);
    EXPECT_EQ(read(0x1402, 1), 0xC0000422U) << "a COB-ID that is not stored is lost";
    EXPECT_EQ(read(0x1401, 1), 0x80000345U);
}

// Sources: sections 3.4.87 and 3.4.88, and the sentence in bold in section 3.2.7.
TEST_F(Ax130751Storage, NodeIdAndBitRateSetBySdoAreLostUnlessStoreParameters1010hSavesThem) {
    verifies<req::AOR_NODE_002, req::AOR_NODE_006, req::AOR_NODE_007, req::AOR_NODE_003, req::AOR_OD_5B50,
             req::AOR_OD_5B51>();
    const auto set = [this] {
        EXPECT_EQ(write(0x5B51, 0, 0x30, 1), "");
        EXPECT_EQ(write(0x5B50, 0, 2, 1), "");
        EXPECT_EQ(read(0x5B51, 0), 0x30U);
        EXPECT_EQ(read(0x5B50, 0), 2U);
        EXPECT_EQ(device->node_id(), 127);
        EXPECT_EQ(device->bit_rate(), 125000U);
        EXPECT_EQ(read(0x1400, 1), 0x4000027FU);
    };
    set();
    EXPECT_EQ(power_on(), (Frames{"77F#00"}));
    EXPECT_EQ(device->bit_rate(), 125000U);
    EXPECT_EQ(read(0x5B51, 0), 127U);
    EXPECT_EQ(read(0x5B50, 0), 4U);
    set();
    EXPECT_EQ(send("000#817F"), (Frames{"77F#00"})) << "a reset of the node loads what is stored";
    EXPECT_EQ(read(0x5B51, 0), 127U);
    set();
    for (const int other_group : {2, 3}) {
        store(other_group);
        EXPECT_EQ(power_on(), (Frames{"77F#00"})) << other_group;
        set();
    }
    EXPECT_EQ(store(4), (Frames{"5FF#6010100400000000"}));
    EXPECT_EQ(device->node_id(), 127) << "until the next power-on";
    EXPECT_EQ(device->bit_rate(), 125000U);
    EXPECT_EQ(power_on(), (Frames{"730#00"}));
    EXPECT_EQ(device->bit_rate(), 500000U);
    node = 0x30;
    EXPECT_EQ(read(0x5B51, 0), 0x30U);
    EXPECT_EQ(read(0x5B50, 0), 2U);
    EXPECT_EQ(read(0x1400, 1), 0x40000230U);
    EXPECT_EQ(write(0x5B51, 0, 0x31, 1), "");
    store(1);
    EXPECT_EQ(power_on(), (Frames{"731#00"}));
    node = 0x31;
    EXPECT_EQ(write(0x5B51, 0, 0, 1), "06090032");
    EXPECT_EQ(write(0x5B51, 0, 128, 1), "06090031");
    EXPECT_EQ(write(0x5B50, 0, 5, 1), "06090030");
}

TEST_F(Ax130751Storage, LssStoreKeepsTheNodeIdThatStoreParameters1010hHasSaved) {
    verifies<req::AOR_NODE_005, req::AOR_NODE_011, req::AOR_OD_5B50, req::AOR_OD_5B51>();
    EXPECT_EQ(write(0x5B51, 0, 0x30, 1), "");
    store();
    send("7E5#0401");
    EXPECT_EQ(send("7E5#130003"), (Frames{"7E4#130000"}));  // index 3: 250 kbit/s
    EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170000"}));
    EXPECT_EQ(send("7E5#0400"), (Frames{"77F#00"})) << "the node-ID by SDO waits for power-on";
    EXPECT_EQ(read(0x5B51, 0), 0x30U);
    EXPECT_EQ(read(0x5B50, 0), 3U);
    EXPECT_EQ(power_on(), (Frames{"730#00"}));
    EXPECT_EQ(device->bit_rate(), 250000U);
    node = 0x30;
    EXPECT_EQ(write(0x5B50, 0, 2, 1), "");  // 5B50h (Change Baud Rate) = 2: 500 kbit/s
    store();
    give_node_id(0x31);
    EXPECT_EQ(read(0x5B51, 0), 0x31U);
    EXPECT_EQ(read(0x5B50, 0), 2U);
    EXPECT_EQ(power_on(), (Frames{"731#00"}));
    EXPECT_EQ(device->bit_rate(), 500000U);
    EXPECT_EQ(write(0x5B51, 0, 0x32, 1), "");
    store();
    give_node_id(0x33);
    EXPECT_EQ(read(0x5B51, 0), 0x33U) << "what LSS has set itself it stores";
    EXPECT_EQ(write(0x5B51, 0, 0x34, 1), "");
    store();
    send("7E5#0401");
    EXPECT_EQ(send("7E5#130003"), (Frames{"7E4#130000"}));
    EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170000"}));
    send("7E5#0400");
    EXPECT_EQ(read(0x5B51, 0), 0x34U) << "LSS has stored 33h before, and not set it since";
    give_node_id(0x31);
    EXPECT_EQ(read(0x5B51, 0), 0x31U) << "set by LSS, though the power-on found it";
}

TEST_F(Ax130751Storage, LssStoreDoesNotStoreABitRateWrittenBySdo) {
    verifies<req::AOR_NODE_009, req::AOR_NODE_012, req::AOR_NODE_011, req::AOR_NODE_007, req::AOR_OD_5B50,
             req::AOR_OD_5B51>();
    EXPECT_EQ(write(0x5B50, 0, 2, 1), "");  // 500 kbit/s, not stored
    give_node_id(0x31);
    EXPECT_EQ(read(0x5B50, 0), 2U) << "LSS does not replace it either";
    EXPECT_EQ(read(0x5B51, 0), 0x31U);
    EXPECT_EQ(power_on(), (Frames{"731#00"}));
    EXPECT_EQ(device->bit_rate(), 125000U);
    EXPECT_EQ(write(0x5B51, 0, 0x32, 1), "");
    give_node_id(0x33);
    EXPECT_EQ(read(0x5B51, 0), 0x33U) << "set by LSS after SDO wrote it";
    store();
    EXPECT_EQ(power_on(), (Frames{"733#00"}));
}

TEST_F(Ax130751Storage, RestoreKeepsNodeIdAndBitRate) {
    verifies<req::AOR_NODE_004, req::AOR_OD_5B50, req::AOR_OD_5B51>();
    give_node_id(0x20);
    EXPECT_EQ(write(0x5B50, 0, 3, 1), "");
    store();
    for (const int group : {1, 2, 3, 4}) {
        restore(group);
        EXPECT_EQ(power_on(), (Frames{"720#00"})) << group;
        EXPECT_EQ(device->bit_rate(), 250000U) << group;
    }
}

// AX130751, 3.2.7
TEST_F(Ax130751Storage, SaveWorksInEveryStateThatServesSdo) {
    verifies<req::AOR_STORE_001, req::AOR_STORE_002, req::AOR_STORE_003, req::AOR_OD_1010, req::AOR_OD_1011,
             req::AOR_STORE_007>();
    silence_tpdo1();
    for (int sub = 1; sub <= 4; ++sub) {
        EXPECT_EQ(read(0x1010, sub), 1U);
        EXPECT_EQ(read(0x1011, sub), 1U);
        EXPECT_EQ(write(0x1010, sub, 0x65766174, 4), "08000020");
        EXPECT_EQ(write(0x1011, sub, 0x65766173, 4), "08000020");  // `save` is not the signature of 1011h
    }
    EXPECT_EQ(write(0x5032, 0, 90, 1), "");
    power_on();
    EXPECT_EQ(read(0x5032, 0), 85U);  // the value was not stored, so it is lost
    EXPECT_EQ(write(0x5032, 0, 90, 1), "");
    EXPECT_EQ(store(), (Frames{"5FF#6010100100000000"}));
    power_on();
    EXPECT_EQ(read(0x5032, 0), 90U);
    silence_tpdo1();
    start();
    EXPECT_EQ(write(0x5032, 0, 91, 1), "");
    EXPECT_EQ(store(), (Frames{"5FF#6010100100000000"}));
    power_on();
    EXPECT_EQ(read(0x5032, 0), 91U);
}

TEST_F(Ax130751Storage, CommandsReceivedOverCanAreNotStored) {
    verifies<req::AOR_STORE_004, req::AOR_STORE_008, req::AOR_OD_6220, req::AOR_OD_7300, req::AOR_OD_2500>();
    for (int sub = 1; sub <= 3; ++sub) {
        EXPECT_EQ(write(0x6220, sub, 1, 1), "");
    }
    EXPECT_EQ(write(0x7300, 1, 1234, 2), "");
    EXPECT_EQ(write(0x2500, 6, 77, 2), "");
    EXPECT_EQ(write(0x2260, 1, 0, 1), "");
    store();
    power_on();
    for (int sub = 1; sub <= 3; ++sub) {
        EXPECT_EQ(read(0x6220, sub), 0U);
    }
    EXPECT_EQ(read(0x7300, 1), 0U);
    EXPECT_EQ(read(0x2500, 6), 0U);
    EXPECT_EQ(read(0x2260, 1), 0U);  // 2260h:1 is a parameter: it has kept its stored value 0
}

// AX130751, 3.2.8
TEST_F(Ax130751Storage, RestoredDefaultsApplyFromTheNextReset) {
    verifies<req::AOR_STORE_005, req::AOR_STORE_006, req::AOR_OD_1011>();
    EXPECT_EQ(write(0x5032, 0, 90, 1), "");
    EXPECT_EQ(write(0x6340, 2, 0, 1), "");
    store();
    EXPECT_EQ(restore(4), (Frames{"5FF#6011100400000000"}));
    EXPECT_EQ(read(0x5032, 0), 90U);
    EXPECT_EQ(send("000#817F"), (Frames{"77F#00"}));
    EXPECT_EQ(read(0x5032, 0), 85U);
    EXPECT_EQ(read(0x6340, 2), 0U);  // 6340h:2 is in another group than 5032h, so it keeps its stored value (default:
                                     // 1)
}

// AX130751, 3.4.86
TEST_F(Ax130751Storage, DeviceStartsItselfWhenStartInOperationalMode5555hIsSetAndStored) {
    verifies<req::AOR_START_001, req::AOR_START_005, req::AOR_START_002, req::AOR_OD_5555>();
    silence_tpdo1();
    EXPECT_EQ(write(0x5555, 0, 1, 1), "");
    EXPECT_EQ(pass(1000), Frames{});
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    store();
    EXPECT_EQ(power_on().at(0), "77F#00");
    pass(1);
    EXPECT_EQ(device->state(), NmtState::operational);
    send("000#807F");
    EXPECT_EQ(device->state(), NmtState::pre_operational);  // the NMT command stops the self-started node
    pass(1000);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_EQ(write(0x5555, 0, 0, 1), "");
    store();
    power_on();
    pass(1000);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
}

// AX130751, 3.2.11, 3.2.12
TEST_F(Ax130751Storage, IdentityAndSoftwareDateComeFromTheFactoryDataOfTheUnit) {
    verifies<req::AOR_ID_001, req::AOR_ID_002, req::AOR_OD_1018, req::AOR_OD_1020>();
    EXPECT_EQ(read(0x1018, 1), 0x55U);
    EXPECT_EQ(read(0x1018, 2), 0xAA130751U);
    EXPECT_EQ(read(0x1018, 3), 0x00010000U);
    EXPECT_EQ(read(0x1018, 4), 1U);
    EXPECT_EQ(read(0x1020, 1), 0x28072023U);  // 28 July 2023
    EXPECT_EQ(read(0x1020, 2), 0U);
    factory.revision = 0x00010203;
    factory.serial_number = 4711;
    power_on();
    EXPECT_EQ(read(0x1018, 3), 0x00010203U);
    EXPECT_EQ(read(0x1018, 4), 4711U);
    EXPECT_EQ(read(0x1018, 2), 0xAA130751U);
    EXPECT_EQ(read(0x1020, 1), 0x28072023U);
    factory.made_on = 0x01022024;
    factory.made_at = 0x00001234;
    power_on();
    restore();
    for (const char* reset : {"", "000#827F", "000#817F"}) {
        SCOPED_TRACE(reset);
        if (reset[0] != 0) {
            send(reset);
        }
        EXPECT_EQ(read(0x1018, 3), 0x00010203U);
        EXPECT_EQ(read(0x1018, 4), 4711U);
        EXPECT_EQ(read(0x1020, 1), 0x01022024U);
        EXPECT_EQ(read(0x1020, 2), 0x00001234U);
    }
}

TEST_F(Ax130751Storage, StoreParameters1010hIsRefusedWhenTheMemoryOfNodeIdAndBitRateFails) {
    verifies<req::AOR_NODE_008, req::AOR_NODE_003, req::AOR_OD_5B51, req::AOR_NODE_010>();
    EXPECT_EQ(write(0x5032, 0, 90, 1), "");
    const std::size_t before = memory.written();
    store();
    const std::size_t of_a_save = memory.written() - before;
    // The power fails after the parameters and `more` of the 20 bytes of node-ID and bit rate are written.
    for (const std::size_t more : {0U, 1U, 19U}) {
        SCOPED_TRACE(more);
        EXPECT_EQ(write(0x5B51, 0, 0x30, 1), "");
        EXPECT_EQ(write(0x5032, 0, 91 + static_cast<int>(more), 1), "");
        memory.cut_power_after(of_a_save + more);
        EXPECT_EQ(write(0x1010, 1, 0x65766173, 4), "06060000");
        memory.restore_power();
        EXPECT_EQ(power_on(), (Frames{"77F#00"}));
        EXPECT_EQ(read(0x5B51, 0), 127U);
        EXPECT_EQ(read(0x5032, 0), 91U + more) << "stored before the memory failed";
    }
    EXPECT_EQ(write(0x5B51, 0, 0x30, 1), "");
    EXPECT_EQ(store(), (Frames{"5FF#6010100100000000"}));
    EXPECT_EQ(power_on(), (Frames{"730#00"}));
}

TEST_F(Ax130751Storage, LssStoreIsRefusedWhenTheMemoryFails) {
    verifies<req::AOR_NODE_003, req::AOR_LSS_003, req::AOR_OD_5B51>();
    memory.cut_power_after(0);
    EXPECT_EQ(write(0x1010, 4, 0x65766173, 4), "06060000");
    send("7E5#0401");
    EXPECT_EQ(send("7E5#1120"), (Frames{"7E4#110000"}));
    EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170200"}));  // error 2: the storage medium failed
    EXPECT_EQ(send("7E5#0400"), (Frames{"720#00"}));
    node = 0x20;
    EXPECT_EQ(read(0x5B51, 0), 127U) << "what holds after the next power-on";
    node = 127;
    memory.restore_power();
    EXPECT_EQ(power_on(), (Frames{"77F#00"}));
    EXPECT_EQ(read(0x5B51, 0), 127U);
    EXPECT_EQ(read(0x5B50, 0), 4U);
}

}  // namespace canproof::test
