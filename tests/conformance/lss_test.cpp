// LSS as CiA 305 asks it of a slave: the conformance slave, node 5, with vendor-ID 0000005Fh, product code AA020301h,
// revision 00010002h and serial number 20261121h. Requests are 7E5#…, answers 7E4#….
#include "generated/canopen/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/exchange.hpp"
#include "tests/support/lss_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Lss : public testing::Test, public LssBench {
  protected:
    void configure() { send("7E5#0401000000000000"); }
    void talk(const std::vector<Exchange>& table) { test::talk(static_cast<LssBench&>(*this), table); }
};

/// Four frames of the slave's own address.
const std::vector<Exchange> own_address{{"7E5#405F000000000000", {}},
                                        {"7E5#41010302AA000000", {}},
                                        {"7E5#4202000100000000", {}},
                                        {"7E5#4321112620000000", {"7E4#4400000000000000"}}};

}  // namespace

// -- states -----------------------------------------------------------------------------------------------------------

// 6.3.2
TEST_F(Lss, SwitchStateGlobalLeadsToConfigurationAndBack) {
    verifies<req::CO_LSS_001, req::CO_E_LSS_STATE, req::CO_E_LSS_COMMAND, req::CO_K_LSS_REQUEST_ID,
             req::CO_K_LSS_RESPONSE_ID>();
    talk({{"7E5#5E00000000000000", {}},  // waiting at first: no inquiry
          {"7E5#0401000000000000", {}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}},
          {"7E5#0401000000000000", {}},  // again: nothing changes
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}},
          {"7E5#0402000000000000", {}},  // no such mode
          {"7E5#04FF000000000000", {}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}},
          {"7E5#0400000000000000", {}},
          {"7E5#5E00000000000000", {}},
          {"7E5#0402000000000000", {}},
          {"7E5#0481000000000000", {}},
          {"7E5#5E00000000000000", {}}});
}

// 6.3.3
TEST_F(Lss, SwitchStateSelectiveNeedsAllFourNumbers) {
    verifies<req::CO_LSS_002, req::CO_E_LSS_ANSWER, req::CO_E_LSS_COMMAND>();
    talk(own_address);
    talk({{"7E5#5E00000000000000", {"7E4#5E05000000000000"}},
          {"7E5#0400000000000000", {}},
          {"7E5#5E00000000000000", {}}});
}

TEST_F(Lss, AWrongNumberOfSwitchStateSelectiveSelectsNobody) {
    verifies<req::CO_LSS_003>();
    const std::vector<std::vector<Exchange>> others{{{"7E5#4060000000000000", {}},  // another vendor
                                                     {"7E5#41010302AA000000", {}},
                                                     {"7E5#4202000100000000", {}},
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#405F000000000000", {}},
                                                     {"7E5#41010302AB000000", {}},  // another product
                                                     {"7E5#4202000100000000", {}},
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#405F000000000000", {}},
                                                     {"7E5#41010302AA000000", {}},
                                                     {"7E5#4203000100000000", {}},  // another revision
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#405F000000000000", {}},
                                                     {"7E5#41010302AA000000", {}},
                                                     {"7E5#4202000100000000", {}},
                                                     {"7E5#4320112620000000", {}}},  // another unit
                                                    {{"7E5#41010302AA000000", {}},   // no vendor
                                                     {"7E5#4202000100000000", {}},
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#405F000000000000", {}},  // one left out
                                                     {"7E5#41010302AA000000", {}},
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#405F000000000000", {}},  // two the wrong way round
                                                     {"7E5#4202000100000000", {}},
                                                     {"7E5#41010302AA000000", {}},
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#405F000000000000", {}},
                                                     {"7E5#41010302AA000000", {}},
                                                     {"7E5#41010302AA000000", {}},  // twice
                                                     {"7E5#4202000100000000", {}},
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#4321112620000000", {}}}};  // the last alone
    for (const auto& conversation : others) {
        talk(conversation);
        EXPECT_FALSE(is_configuring());
    }
}

TEST_F(Lss, AVendorIdBeginsSwitchStateSelectiveAnew) {
    verifies<req::CO_LSS_003>();
    talk({{"7E5#405F000000000000", {}},
          {"7E5#41010302AA000000", {}},
          {"7E5#405F000000000000", {}},
          {"7E5#41010302AA000000", {}},
          {"7E5#4202000100000000", {}},
          {"7E5#4321112620000000", {"7E4#4400000000000000"}}});
    talk({{"7E5#0400000000000000", {}}, {"7E5#4060000000000000", {}}});  // another slave first …
    talk(own_address);                                                   // … then this one
}

TEST_F(Lss, OtherServicesDoNotDisturbSwitchStateSelective) {
    verifies<req::CO_LSS_003>();
    talk({{"7E5#405F000000000000", {}},
          {"7E5#4C00000000000000", {}},
          {"7E5#41010302AA000000", {}},
          {"7E5#465F000000000000", {}},
          {"7E5#0401000000000000", {}},
          {"7E5#0400000000000000", {}},
          {"7E5#4202000100000000", {}},
          {"605#4000100000000000", {"585#4300100078563412"}},
          {"7E5#4321112620000000", {"7E4#4400000000000000"}}});
}

// 6.3: NMT resets are resets of LSS as well
TEST_F(Lss, ResetsEndConfigurationAndBegunSequences) {
    verifies<req::CO_LSS_004>();
    for (const char* reset : {"000#8105", "000#8205"}) {
        configure();
        talk({{reset, {"705#00"}}, {"7E5#5E00000000000000", {}}});
        talk({{"7E5#405F000000000000", {}},
              {"7E5#41010302AA000000", {}},
              {reset, {"705#00"}},
              {"7E5#4202000100000000", {}},
              {"7E5#4321112620000000", {}}});
        talk({{"7E5#465F000000000000", {}},
              {"7E5#47010302AA000000", {}},
              {"7E5#4802000100000000", {}},
              {reset, {"705#00"}},
              {"7E5#4902000100000000", {}},
              {"7E5#4A21112620000000", {}},
              {"7E5#4B21112620000000", {}}});
    }
    configure();
    EXPECT_EQ(start({5, 125000}), (Frames{"705#00"}));
    EXPECT_FALSE(is_configuring());
}

// CO-T-LSS, cell by cell: which service works in LSS waiting, in LSS configuration, and there in NMT operational
TEST_F(Lss, EachServiceWorksInItsStates) {
    verifies<req::CO_LSS_005, req::CO_LSS_006, req::CO_T_LSS>();
    struct Row {
        const char* request;
        Frames waiting;
        Frames configuration;
        Frames operational;
    };
    const Frames identified{"7E4#4F00000000000000"};
    const std::vector<Row> rows{{"7E5#1107000000000000", {}, {"7E4#1100000000000000"}, {}},
                                {"7E5#1300030000000000", {}, {"7E4#1300000000000000"}, {}},
                                {"7E5#1700000000000000", {}, {"7E4#1700000000000000"}, {}},
                                {"7E5#5A00000000000000", {}, {"7E4#5A5F000000000000"}, {"7E4#5A5F000000000000"}},
                                {"7E5#5B00000000000000", {}, {"7E4#5B010302AA000000"}, {"7E4#5B010302AA000000"}},
                                {"7E5#5C00000000000000", {}, {"7E4#5C02000100000000"}, {"7E4#5C02000100000000"}},
                                {"7E5#5D00000000000000", {}, {"7E4#5D21112620000000"}, {"7E4#5D21112620000000"}},
                                {"7E5#5E00000000000000", {}, {"7E4#5E05000000000000"}, {"7E4#5E05000000000000"}},
                                {"7E5#465F000000000000", {}, {}, {}},
                                {"7E5#47010302AA000000", {}, {}, {}},
                                {"7E5#4802000100000000", {}, {}, {}},
                                {"7E5#4902000100000000", {}, {}, {}},
                                {"7E5#4A21112620000000", {}, {}, {}},
                                {"7E5#4B21112620000000", identified, identified, identified},
                                {"7E5#405F000000000000", {}, {}, {}},
                                {"7E5#41010302AA000000", {}, {}, {}},
                                {"7E5#4202000100000000", {}, {}, {}},
                                {"7E5#4321112620000000", {"7E4#4400000000000000"}, {}, {}}};
    for (const Row& row : rows) {
        EXPECT_EQ(send(row.request), row.waiting) << "LSS waiting: " << row.request;
    }
    for (const Row& row : rows) {
        EXPECT_EQ(send(row.request), row.configuration) << "LSS configuration: " << row.request;
    }
    send("000#0105");
    for (const Row& row : rows) {
        EXPECT_EQ(send(row.request), row.operational) << "operational: " << row.request;
    }
    // Selection in configuration leaves nothing behind for the time after it.
    send("7E5#0400");
    EXPECT_TRUE(send("7E5#4321112620000000").empty());
}

TEST_F(Lss, SelectiveFramesInConfigurationAreNotCounted) {
    verifies<req::CO_LSS_005, req::CO_T_LSS>();
    // Each of the four in turn is sent while the slave is configured, and so is missing.
    for (std::size_t early = 0; early < own_address.size(); ++early) {
        for (std::size_t i = 0; i < own_address.size(); ++i) {
            send(i == early ? "7E5#0401" : "7E5#0400");
            EXPECT_TRUE(send(own_address[i].request).empty()) << early << ", frame " << i;
        }
        send("7E5#0400");
        EXPECT_FALSE(is_configuring()) << early;
    }
}

// CiA 301, 7.3.2.3
TEST_F(Lss, LssWorksInStopped) {
    verifies<req::CO_LSS_006>();
    talk({{"000#0205", {}},
          {"7E5#0401000000000000", {}},
          {"7E5#1109000000000000", {"7E4#1100000000000000"}},
          {"7E5#1300020000000000", {"7E4#1300000000000000"}},
          {"7E5#1700000000000000", {"7E4#1700000000000000"}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}},
          {"7E5#1500000000000000", {}},
          {"7E5#0400000000000000", {}}});
    EXPECT_EQ(bit_rate(), 500000U);
    EXPECT_EQ(state(), NmtState::stopped);
}

TEST_F(Lss, NothingIsConfiguredInOperational) {
    verifies<req::CO_LSS_006>();
    talk({{"7E5#0401000000000000", {}},
          {"7E5#1300020000000000", {"7E4#1300000000000000"}},
          {"000#0105", {"185#0000"}},
          {"7E5#1107000000000000", {}},
          {"7E5#1300030000000000", {}},
          {"7E5#1500000000000000", {}},
          {"7E5#1700000000000000", {}}});
    EXPECT_EQ(bit_rate(), 125000U);
    EXPECT_EQ(device->stored().node_id, 5);
    // What was refused there is not done later either.
    talk({{"000#8005", {}}, {"7E5#1500000000000000", {}}, {"000#8205", {"705#00"}}});
    EXPECT_EQ(bit_rate(), 500000U);
}

TEST_F(Lss, SwitchStateIsFollowedInOperational) {
    verifies<req::CO_LSS_006, req::CO_LSS_001>();
    send("000#0105");
    talk({{"7E5#0401000000000000", {}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}},
          {"7E5#0400000000000000", {}},
          {"7E5#5E00000000000000", {}}});
    talk(own_address);
    EXPECT_EQ(state(), NmtState::operational);
}

// -- configuration ----------------------------------------------------------------------------------------------------

// 6.4.2
TEST_F(Lss, ConfigureNodeIdTakes1To127And255) {
    verifies<req::CO_LSS_010, req::CO_K_LSS_LOWEST_NODE_ID, req::CO_K_LSS_HIGHEST_NODE_ID, req::CO_E_LSS_ERROR>();
    configure();
    talk({{"7E5#1101000000000000", {"7E4#1100000000000000"}},
          {"7E5#1102000000000000", {"7E4#1100000000000000"}},
          {"7E5#1150000000000000", {"7E4#1100000000000000"}},
          {"7E5#117E000000000000", {"7E4#1100000000000000"}},
          {"7E5#117F000000000000", {"7E4#1100000000000000"}},
          {"7E5#11FF000000000000", {"7E4#1100000000000000"}},
          {"7E5#1100000000000000", {"7E4#1101000000000000"}},
          {"7E5#1180000000000000", {"7E4#1101000000000000"}},
          {"7E5#1181000000000000", {"7E4#1101000000000000"}},
          {"7E5#11FE000000000000", {"7E4#1101000000000000"}}});
}

TEST_F(Lss, EveryNodeIdIsAnsweredRightly) {
    verifies<req::CO_LSS_010, req::CO_K_LSS_LOWEST_NODE_ID, req::CO_K_LSS_HIGHEST_NODE_ID>();
    configure();
    for (int node = 0; node <= 255; ++node) {
        const bool fits = (node >= 1 && node <= 127) || node == 255;
        char request[] = "7E5#1100";
        std::snprintf(request, sizeof request, "7E5#11%02X", static_cast<unsigned>(node) & 0xFFU);
        EXPECT_EQ(send(request), (Frames{fits ? "7E4#110000" : "7E4#110100"})) << node;
    }
}

TEST_F(Lss, ARefusedNodeIdLeavesThePendingOne) {
    verifies<req::CO_LSS_010>();
    configure();
    talk({{"7E5#110A000000000000", {"7E4#1100000000000000"}},
          {"7E5#1100000000000000", {"7E4#1101000000000000"}},
          {"7E5#11C8000000000000", {"7E4#1101000000000000"}},
          {"000#8205", {"70A#00"}}});
}

TEST_F(Lss, ANewNodeIdIsPendingUntilResetCommunication) {
    verifies<req::CO_LSS_011>();
    configure();
    talk({{"7E5#110A000000000000", {"7E4#1100000000000000"}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}},  // the active one
          {"605#4000180100000000", {"585#4300180185010000"}},  // TPDO1 180h + 5
          {"605#4014100000000000", {"585#4314100085000000"}},  // COB-ID EMCY 80h + 5
          {"7E5#0400000000000000", {}},                        // no reset by itself
          {"605#4014100000000000", {"585#4314100085000000"}},
          {"60A#4014100000000000", {}},
          {"000#820A", {}},  // not yet its node-ID
          {"000#8205", {"70A#00"}},
          {"605#4014100000000000", {}},
          {"60A#4014100000000000", {"58A#431410008A000000"}},  // COB-ID EMCY 80h + 10
          {"000#0105", {}}});
    EXPECT_EQ(state(), NmtState::pre_operational);
    send("000#010A");
    EXPECT_EQ(state(), NmtState::operational);
    EXPECT_EQ(device->node().node_id(), 10);
}

// 6.4.3, table 0: 1000, 800, 500, 250, 125, reserved, 50, 20 and 10 kbit/s
TEST_F(Lss, ConfigureBitTimingTakesTheBitRatesOfTable0) {
    verifies<req::CO_LSS_012, req::CO_T_LSS_BIT_RATE, req::CO_K_LSS_STANDARD_TABLE, req::CO_E_LSS_ERROR>();
    configure();
    const std::vector<std::pair<Exchange, std::uint32_t>> rows{
        {{"7E5#1300000000000000", {"7E4#1300000000000000"}}, 1000000},
        {{"7E5#1300010000000000", {"7E4#1300000000000000"}}, 800000},
        {{"7E5#1300020000000000", {"7E4#1300000000000000"}}, 500000},
        {{"7E5#1300030000000000", {"7E4#1300000000000000"}}, 250000},
        {{"7E5#1300040000000000", {"7E4#1300000000000000"}}, 125000},
        {{"7E5#1300060000000000", {"7E4#1300000000000000"}}, 50000},
        {{"7E5#1300070000000000", {"7E4#1300000000000000"}}, 20000},
        {{"7E5#1300080000000000", {"7E4#1300000000000000"}}, 10000}};
    for (const auto& [exchange, rate] : rows) {
        talk({exchange, {"7E5#1500000000000000", {}}});
        EXPECT_EQ(bit_rate(), rate) << exchange.request;
    }
}

TEST_F(Lss, ConfigureBitTimingRefusesReservedIndicesAndOtherTables) {
    verifies<req::CO_LSS_012, req::CO_T_LSS_BIT_RATE, req::CO_K_LSS_STANDARD_TABLE, req::CO_E_LSS_ERROR>();
    configure();
    talk({{"7E5#1300020000000000", {"7E4#1300000000000000"}},  // 500 kbit/s, to be kept
          {"7E5#1300050000000000", {"7E4#1301000000000000"}},
          {"7E5#1300090000000000", {"7E4#1301000000000000"}},
          {"7E5#13000A0000000000", {"7E4#1301000000000000"}},
          {"7E5#1300FF0000000000", {"7E4#1301000000000000"}},
          {"7E5#1301030000000000", {"7E4#1301000000000000"}},
          {"7E5#1380030000000000", {"7E4#1301000000000000"}},
          {"7E5#13FF030000000000", {"7E4#1301000000000000"}},
          {"7E5#1500000000000000", {}}});
    EXPECT_EQ(bit_rate(), 500000U);
}

// AX130751, Table 22: 666 kbit/s where CiA has 800
TEST_F(Lss, ADevicesOwnTableDecidesTheBitRate) {
    verifies<req::CO_LSS_012>();
    resets_itself = true;
    start({5, 125000});
    configure();
    talk({{"7E5#130001", {"7E4#130000"}}, {"7E5#150000", {}}, {"7E5#130005", {"7E4#130100"}}});
    EXPECT_EQ(bit_rate(), 666667U);
}

TEST_F(Lss, OnlyActivateBitTimingChangesTheBitRate) {
    verifies<req::CO_LSS_013>();
    configure();
    talk({{"7E5#1300030000000000", {"7E4#1300000000000000"}},
          {"7E5#1700000000000000", {"7E4#1700000000000000"}},
          {"7E5#0400000000000000", {}},
          {"000#8205", {"705#00"}}});
    EXPECT_EQ(pass(1000), Frames{});
    EXPECT_EQ(bit_rate(), 125000U);
    configure();
    talk({{"7E5#1500000000000000", {}}});  // still pending after reset communication
    EXPECT_EQ(bit_rate(), 250000U);
}

// 6.4.4; heartbeats each 30 ms show whether the node may speak
TEST_F(Lss, ActivateBitTimingIsSilentForBothDelaysAndSwitchesBetweenThem) {
    verifies<req::CO_LSS_014, req::CO_LSS_015>();
    talk({{"605#2B1710001E000000", {"585#6017100000000000"}},
          {"7E5#0401000000000000", {}},
          {"7E5#1300030000000000", {"7E4#1300000000000000"}}});
    EXPECT_EQ(pass(65), (Frames{"30:705#7F", "60:705#7F"}));
    talk({{"7E5#1564000000000000", {}}});  // 100 ms; heartbeats are due at 25, 55, 85, 115, 145, 175, 205
    EXPECT_EQ(pass(99), Frames{});
    EXPECT_EQ(bit_rate(), 125000U);
    EXPECT_EQ(pass(1), Frames{});
    EXPECT_EQ(bit_rate(), 250000U);
    EXPECT_EQ(pass(99), Frames{});
    EXPECT_EQ(pass(41), (Frames{"6:705#7F", "36:705#7F"}));  // from 199: 205 and 235
}

TEST_F(Lss, TheSwitchDelayIsSixteenBitsOfMilliseconds) {
    verifies<req::CO_LSS_014>();
    configure();
    talk({{"7E5#1300030000000000", {"7E4#1300000000000000"}}, {"7E5#15FFFF0000000000", {}}});
    pass(65534);
    EXPECT_EQ(bit_rate(), 125000U);
    pass(1);
    EXPECT_EQ(bit_rate(), 250000U);
    pass(65534);
    talk({{"7E5#5E00000000000000", {}}});
    pass(1);
    talk({{"7E5#5E00000000000000", {"7E4#5E05000000000000"}}});
}

TEST_F(Lss, ReceivedFramesHaveNoEffectDuringTheDelays) {
    verifies<req::CO_LSS_015>();
    configure();
    talk({{"7E5#1300030000000000", {"7E4#1300000000000000"}}, {"7E5#150A000000000000", {}}});
    for (int period = 0; period < 2; ++period) {
        talk({{"605#4000100000000000", {}},
              {"605#2B1710001E000000", {}},
              {"000#0105", {}},
              {"000#8105", {}},
              {"705#R", {}},
              {"7E5#1107000000000000", {}},
              {"7E5#0400000000000000", {}},
              {"7E5#5E00000000000000", {}}});
        EXPECT_EQ(pass(10), Frames{});
    }
    EXPECT_EQ(state(), NmtState::pre_operational);
    talk({{"7E5#5E00000000000000", {"7E4#5E05000000000000"}},
          {"605#4017100000000000", {"585#4B17100000000000"}},
          {"000#8205", {"705#00"}}});
    EXPECT_EQ(bit_rate(), 250000U);
}

TEST_F(Lss, AnActivationWithoutDelayIsDoneAtOnce) {
    verifies<req::CO_LSS_014, req::CO_LSS_015>();
    configure();
    talk({{"7E5#1300030000000000", {"7E4#1300000000000000"}},
          {"7E5#1500000000000000", {}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}}});
    EXPECT_EQ(bit_rate(), 250000U);
}

TEST_F(Lss, AnActivationWithoutANewBitRateIsSilentAllTheSame) {
    verifies<req::CO_LSS_014, req::CO_LSS_015>();
    configure();
    talk({{"7E5#1505000000000000", {}}});
    pass(9);
    talk({{"7E5#5E00000000000000", {}}});
    pass(1);
    talk({{"7E5#5E00000000000000", {"7E4#5E05000000000000"}}});
    EXPECT_EQ(bit_rate(), 125000U);
}

TEST_F(Lss, WhatWaitsToBeSentIsDroppedAtActivation) {
    verifies<req::CO_LSS_015>();
    configure();
    for (const char* frame : {"7E5#1300030000000000", "7E5#1501000000000000"}) {
        device->receive(host::parse_frame(frame, "test"), now);  // the driver sends nothing meanwhile
    }
    EXPECT_EQ(sent(), Frames{});
    EXPECT_EQ(pass(2), Frames{});
}

TEST_F(Lss, AnErrorDuringTheDelaysIsToldAfterThem) {
    verifies<req::CO_LSS_015>();
    configure();
    talk({{"7E5#150A000000000000", {}}});
    device->node().set_overrun(true, now);
    EXPECT_EQ(sent(), Frames{});
    EXPECT_EQ(pass(19), Frames{});
    const Frames told = pass(1);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].substr(0, 12), "1:085#108111");  // 8110h, register 11h
}

TEST_F(Lss, AnErrorAtTheEndOfTheDelaysIsToldWithTheirEnd) {
    verifies<req::CO_LSS_015, req::CO_EMCY_001>();
    configure();
    talk({{"7E5#150A000000000000", {}}});
    EXPECT_EQ(pass(19), Frames{});
    now = now + microseconds(500);
    device->node().set_overrun(true, now);
    EXPECT_EQ(sent(), Frames{});
    now = now + microseconds(500);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"085#1081110100000000"}));
}

TEST_F(Lss, TheEndOfTheDelaysTellsNoErrorInStopped) {
    verifies<req::CO_LSS_015, req::CO_EMCY_004>();
    configure();
    talk({{"000#0205", {}}, {"7E5#150A000000000000", {}}});
    EXPECT_EQ(pass(20), Frames{});
    device->node().set_overrun(true, now);
    EXPECT_EQ(sent(), Frames{});
    EXPECT_EQ(pass(100), Frames{});
    talk({{"000#8005", {"085#1081110100000000"}}});
}

TEST_F(Lss, AStartDuringTheDelaysBreaksNoSilence) {
    verifies<req::CO_LSS_015>();
    configure();
    talk({{"7E5#150A000000000000", {}}});
    device->node().set_overrun(true, now);
    device->node().start_at(now + milliseconds(5));  // a self-start
    EXPECT_EQ(pass(19), Frames{});
    EXPECT_EQ(state(), NmtState::operational);
    const Frames told = pass(1);
    ASSERT_FALSE(told.empty());
    EXPECT_EQ(told[0].substr(0, 12), "1:085#108111");  // and the error is not forgotten
}

// CiA 301, 7.2.8.2.2: node 31h, 100 ms, falls silent while the bit rate is switched
TEST_F(Lss, HeartbeatsAreMonitoredDuringTheDelays) {
    verifies<req::CO_LSS_015>();
    talk({{"605#2316100164003100", {"585#6016100100000000"}},
          {"731#05", {}},
          {"7E5#0401000000000000", {}},
          {"7E5#1596000000000000", {}},  // 150 ms
          {"731#05", {}}});              // not heard any more
    EXPECT_EQ(pass(299), Frames{});
    const Frames told = pass(1);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].substr(0, 12), "1:085#308111");  // 8130h, register 11h
}

TEST_F(Lss, TheEndOfBusOffDoesNotEndTheSilence) {
    verifies<req::CO_LSS_015>();
    talk({{"605#2B17100003000000", {"585#6017100000000000"}}, {"7E5#0401000000000000", {}}});
    talk({{"7E5#150A000000000000", {}}});
    device->node().set_can_state(CanState::bus_off, now);
    pass(5);
    device->node().set_can_state(CanState::error_active, now);
    EXPECT_EQ(sent(), Frames{});
    EXPECT_EQ(pass(14), Frames{});
    EXPECT_FALSE(pass(10).empty());
}

TEST_F(Lss, PowerOnEndsTheSilence) {
    verifies<req::CO_LSS_017, req::CO_LSS_004>();
    configure();
    talk({{"7E5#1300030000000000", {"7E4#1300000000000000"}}, {"7E5#1564000000000000", {}}});
    pass(50);
    device->power_on({5, 125000}, now);  // the same device, off and on again
    EXPECT_EQ(sent(), (Frames{"705#00"}));
    EXPECT_EQ(pass(200), Frames{});
    EXPECT_EQ(bit_rate(), 125000U);
    talk({{"605#4000100000000000", {"585#4300100078563412"}}});
}

TEST_F(Lss, BusOffOutlastsTheSilence) {
    verifies<req::CO_LSS_015>();
    configure();
    talk({{"7E5#150A000000000000", {}}});
    device->node().set_can_state(CanState::bus_off, now);
    EXPECT_EQ(pass(100), Frames{});
    talk({{"7E5#5E00000000000000", {}}});
    device->node().set_can_state(CanState::error_active, now);
    sent();
    talk({{"7E5#5E00000000000000", {"7E4#5E05000000000000"}}});
}

// 6.4.5
TEST_F(Lss, StoreConfigurationKeepsNodeIdAndBitRate) {
    verifies<req::CO_LSS_016, req::CO_LSS_017>();
    configure();
    talk({{"7E5#1120000000000000", {"7E4#1100000000000000"}},
          {"7E5#1300020000000000", {"7E4#1300000000000000"}},
          {"7E5#1700000000000000", {"7E4#1700000000000000"}}});
    const LssConfiguration kept = device->stored();
    EXPECT_EQ(kept.node_id, 32);
    EXPECT_EQ(kept.bit_rate, 500000U);
    EXPECT_EQ(bit_rate(), 125000U);  // stored, not activated
    EXPECT_EQ(start(kept), (Frames{"720#00"}));
    EXPECT_EQ(bit_rate(), 500000U);
}

TEST_F(Lss, StoreConfigurationSaysWhenItFails) {
    verifies<req::CO_LSS_016, req::CO_LSS_017, req::CO_E_LSS_ERROR>();
    configure();
    talk({{"7E5#1120000000000000", {"7E4#1100000000000000"}}});
    device->answer_store_with(LssError::not_supported);
    talk({{"7E5#1700000000000000", {"7E4#1701000000000000"}}});
    device->answer_store_with(LssError::storage_failed);
    talk({{"7E5#1700000000000000", {"7E4#1702000000000000"}},
          {"000#8105", {"705#00"}}});  // reset node: nothing was stored
}

TEST_F(Lss, ResetNodeStartsWithWhatIsStored) {
    verifies<req::CO_LSS_017>();
    configure();
    talk({{"7E5#1120000000000000", {"7E4#1100000000000000"}},
          {"7E5#1300020000000000", {"7E4#1300000000000000"}},
          {"7E5#1700000000000000", {"7E4#1700000000000000"}},
          {"7E5#1121000000000000", {"7E4#1100000000000000"}},  // not stored any more
          {"7E5#1300030000000000", {"7E4#1300000000000000"}},
          {"000#8105", {"720#00"}}});
    EXPECT_EQ(bit_rate(), 500000U);
    configure();
    talk({{"7E5#1500000000000000", {}}});  // the pending bit rate is the stored one again
    EXPECT_EQ(bit_rate(), 500000U);
}

TEST_F(Lss, WhatIsNotStoredIsLostAtResetNode) {
    verifies<req::CO_LSS_017>();
    configure();
    talk({{"7E5#1120000000000000", {"7E4#1100000000000000"}},
          {"7E5#1300020000000000", {"7E4#1300000000000000"}},
          {"7E5#1500000000000000", {}},
          {"000#8205", {"720#00"}}});
    EXPECT_EQ(bit_rate(), 500000U);
    talk({{"000#8120", {"705#00"}}});
    EXPECT_EQ(bit_rate(), 125000U);
}

// -- the Axiomatic manuals --------------------------------------------------------------------------------------------

namespace {

/// A device that ships as AX130751 3.1 and its siblings say.
class AxLss : public Lss {
  protected:
    AxLss() {
        resets_itself = true;
        start({80, 125000});
    }
};

}  // namespace

// The screen capture, frames 95 to 102, with its times; AX130751 3.1.3, AX188001 3.1.1.2, AX060805 4.1.1.2
TEST_F(AxLss, TheCapturedSessionTo250KbitPerSecond) {
    verifies<req::CO_LSS_019, req::CO_LSS_018, req::CO_LSS_061>();
    EXPECT_EQ(send("7E5#0401"), Frames{});                  // 95, 11:42:45.248
    EXPECT_EQ(pass(9220), Frames{});                        //
    EXPECT_EQ(send("7E5#130003"), (Frames{"7E4#130000"}));  // 96 and 97, 11:42:54.468
    EXPECT_EQ(pass(4219), Frames{});                        //
    EXPECT_EQ(send("7E5#158813"), Frames{});                // 98, 11:42:58.687: 1388h = 5000 ms
    EXPECT_EQ(pass(4999), Frames{});
    EXPECT_EQ(bit_rate(), 125000U);
    EXPECT_EQ(pass(1), Frames{});
    EXPECT_EQ(bit_rate(), 250000U);
    EXPECT_EQ(pass(12892), Frames{});                   // 17.892 s after frame 98
    EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170000"}));  // 99 and 100, 11:43:16.579
    EXPECT_EQ(pass(6438), Frames{});                    //
    EXPECT_EQ(send("7E5#0400"), (Frames{"750#00"}));    // 101 and 102, 11:43:23.017
    EXPECT_EQ(state(), NmtState::pre_operational);
    EXPECT_EQ(device->stored().node_id, 80);
    EXPECT_EQ(device->stored().bit_rate, 250000U);
}

// AX130751 3.1.2, AX188001 3.1.1.1, AX060805 4.1.1.1
TEST_F(AxLss, TheManualsStepsForTheNodeId) {
    verifies<req::CO_LSS_018, req::CO_LSS_061, req::CO_LSS_016>();
    start({127, 125000});  // as shipped
    talk({{"7E5#0401", {}},
          {"7E5#1150", {"7E4#110000"}},
          {"7E5#17", {"7E4#170000"}},
          {"7E5#0400", {"750#00"}},
          {"67F#4000100000000000", {}},
          {"650#4000100000000000", {"5D0#4300100078563412"}}});
    EXPECT_EQ(start(device->stored()), (Frames{"750#00"}));
}

TEST_F(AxLss, LeavingConfigurationResetsEvenWhenNothingWasConfigured) {
    verifies<req::CO_LSS_018>();
    send("000#0150");
    talk({{"7E5#0401", {}}, {"7E5#0400", {"750#00"}}});
    EXPECT_EQ(state(), NmtState::pre_operational);
    talk(own_address);
    talk({{"7E5#0400000000000000", {"750#00"}}});
}

TEST_F(AxLss, TheResetIsOneOfCommunicationOnly) {
    verifies<req::CO_LSS_018>();
    talk({{"650#2B17100064000000", {"5D0#6017100000000000"}},  // 1017h = 100 ms
          {"650#2F002001AA000000", {"5D0#6000200100000000"}},
          {"7E5#0401", {}},
          {"7E5#0400", {"750#00"}},
          {"650#4017100000000000", {"5D0#4B17100000000000"}},
          {"650#4000200100000000", {"5D0#4F002001AA000000"}}});
}

TEST_F(AxLss, ASwitchToWaitingInWaitingResetsNothing) {
    verifies<req::CO_LSS_018>();
    send("000#0150");
    talk({{"7E5#0400", {}}, {"7E5#0402", {}}});
    EXPECT_EQ(state(), NmtState::operational);
}

TEST_F(Lss, ADeviceThatDoesNotDeclareItIsNotReset) {
    verifies<req::CO_LSS_018>();
    configure();
    talk({{"7E5#1107000000000000", {"7E4#1100000000000000"}}, {"7E5#0400000000000000", {}}});
    EXPECT_EQ(device->node().node_id(), 5);
}

// -- a node without a node-ID -----------------------------------------------------------------------------------------

namespace {

class Unconfigured : public Lss {
  protected:
    Unconfigured() : first_frames{start({255, 125000})} {}
    Frames first_frames;
};

}  // namespace

TEST_F(Unconfigured, WhatTheControllerWentThroughBeforeTheNodeBootsIsNotTold) {
    verifies<req::CO_LSS_030, req::CO_LSS_031>();
    device->node().set_can_state(CanState::bus_off, now);
    device->node().set_can_state(CanState::error_active, now);
    EXPECT_EQ(sent(), Frames{});
    EXPECT_EQ(device->communication_errors(), 0);
    talk({{"7E5#0401", {}}, {"7E5#1105", {"7E4#110000"}}, {"7E5#0400", {"705#00"}}});
    EXPECT_EQ(pass(100), Frames{});
}

TEST_F(Unconfigured, AControllerThatIsPassiveWhenTheNodeBootsIsAnError) {
    verifies<req::CO_LSS_031, req::CO_EMCY_001>();
    device->node().set_can_state(CanState::error_passive, now);
    EXPECT_EQ(sent(), Frames{});
    talk({{"7E5#0401", {}},
          {"7E5#1105", {"7E4#110000"}},
          {"7E5#0400", {"705#00", "085#2081110100000000"}},  // 8120h
          {"605#4001100000000000", {"585#4F01100011000000"}}});
    device->node().set_can_state(CanState::error_active, now);
    EXPECT_EQ(sent(), (Frames{"085#0000000100000000"}));
}

TEST_F(Unconfigured, NothingButLssIsServed) {
    verifies<req::CO_LSS_030, req::CO_K_LSS_UNCONFIGURED>();
    EXPECT_EQ(first_frames, Frames{});
    EXPECT_EQ(pass(5000), Frames{});
    talk({{"000#0100", {}},
          {"000#8100", {}},
          {"000#8200", {}},
          {"000#01FF", {}},
          {"605#4000100000000000", {}},
          {"6FF#4000100000000000", {}},
          {"7FF#R", {}},
          {"700#R", {}},
          {"080#", {}}});
    EXPECT_EQ(state(), NmtState::initialising);
    device->node().set_overrun(true, now);
    EXPECT_EQ(sent(), Frames{});
    talk({{"7E5#4C00000000000000", {"7E4#5000000000000000"}}});
    EXPECT_EQ(device->next_deadline(), never);
}

TEST_F(Unconfigured, ANodeIdIsTakenAtTheSwitchToWaiting) {
    verifies<req::CO_LSS_031, req::CO_LSS_041>();
    talk({{"7E5#0401000000000000", {}},
          {"7E5#5E00000000000000", {"7E4#5EFF000000000000"}},
          {"7E5#1120000000000000", {"7E4#1100000000000000"}},
          {"7E5#5E00000000000000", {"7E4#5EFF000000000000"}},  // pending
          {"620#4000100000000000", {}},
          {"7E5#0400000000000000", {"720#00"}},
          {"620#4000100000000000", {"5A0#4300100078563412"}},
          {"000#0120", {"1A0#0000"}}});
    EXPECT_EQ(state(), NmtState::operational);
}

TEST_F(Unconfigured, LeavingConfigurationWithoutANodeIdChangesNothing) {
    verifies<req::CO_LSS_030, req::CO_LSS_031>();
    talk({{"7E5#0401000000000000", {}},
          {"7E5#0400000000000000", {}},
          {"7E5#0401000000000000", {}},
          {"7E5#1120000000000000", {"7E4#1100000000000000"}},
          {"7E5#11FF000000000000", {"7E4#1100000000000000"}},  // taken back
          {"7E5#0400000000000000", {}}});
    EXPECT_EQ(pass(5000), Frames{});
    EXPECT_EQ(state(), NmtState::initialising);
}

TEST_F(Unconfigured, ADeviceThatResetsItselfStaysSilentWithoutANodeId) {
    verifies<req::CO_LSS_018, req::CO_LSS_030>();
    resets_itself = true;
    start({255, 125000});
    talk({{"7E5#0401", {}}, {"7E5#0400", {}}, {"7E5#4C", {"7E4#50"}}});
    talk({{"7E5#0401", {}}, {"7E5#1107", {"7E4#110000"}}, {"7E5#0400", {"707#00"}}});
}

TEST_F(Lss, ANodeIdCanBeTakenAway) {
    verifies<req::CO_LSS_010, req::CO_LSS_030>();
    talk({{"605#2B1710000A000000", {"585#6017100000000000"}},  // heartbeat each 10 ms
          {"7E5#0401000000000000", {}},
          {"7E5#11FF000000000000", {"7E4#1100000000000000"}},
          {"7E5#0400000000000000", {}}});
    EXPECT_EQ(pass(10), (Frames{"10:705#7F"}));
    talk({{"000#8205", {}}});
    EXPECT_EQ(pass(1000), Frames{});
    EXPECT_EQ(state(), NmtState::initialising);
    talk({{"7E5#4C00000000000000", {"7E4#5000000000000000"}},
          {"7E5#0401000000000000", {}},
          {"7E5#1106000000000000", {"7E4#1100000000000000"}},
          {"7E5#0400000000000000", {"706#00"}}});
}

TEST_F(Unconfigured, TheBitRateCanBeChangedWithoutANodeId) {
    verifies<req::CO_LSS_030, req::CO_LSS_014>();
    talk({{"7E5#0401000000000000", {}},
          {"7E5#1300000000000000", {"7E4#1300000000000000"}},
          {"7E5#1505000000000000", {}}});
    EXPECT_EQ(pass(5), Frames{});
    EXPECT_EQ(bit_rate(), 1000000U);
    talk({{"7E5#5E00000000000000", {}}});
    pass(5);
    talk({{"7E5#5E00000000000000", {"7E4#5EFF000000000000"}}});
}

// -- inquiry and identification ---------------------------------------------------------------------------------------

// 6.5
TEST_F(Lss, InquiriesTellTheAddressAndTheNodeId) {
    verifies<req::CO_LSS_040, req::CO_LSS_041, req::CO_E_LSS_COMMAND>();
    configure();
    talk({{"7E5#5A00000000000000", {"7E4#5A5F000000000000"}},
          {"7E5#5B00000000000000", {"7E4#5B010302AA000000"}},
          {"7E5#5C00000000000000", {"7E4#5C02000100000000"}},
          {"7E5#5D00000000000000", {"7E4#5D21112620000000"}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}}});
}

// 6.6.2: revision and serial number are ranges, their bounds included
TEST_F(Lss, IdentifyRemoteSlaveFindsTheSlaveInItsRanges) {
    verifies<req::CO_LSS_042, req::CO_E_LSS_ANSWER>();
    talk({{"7E5#465F000000000000", {}},
          {"7E5#47010302AA000000", {}},
          {"7E5#4802000100000000", {}},  // both bounds its own
          {"7E5#4902000100000000", {}},
          {"7E5#4A21112620000000", {}},
          {"7E5#4B21112620000000", {"7E4#4F00000000000000"}}});
    talk({{"7E5#465F000000000000", {}},
          {"7E5#47010302AA000000", {}},
          {"7E5#4800000000000000", {}},  // all there are
          {"7E5#49FFFFFFFF000000", {}},
          {"7E5#4A00000000000000", {}},
          {"7E5#4BFFFFFFFF000000", {"7E4#4F00000000000000"}}});
    EXPECT_FALSE(is_configuring());  // identified, not selected
}

TEST_F(Lss, IdentifyRemoteSlavePassesOverOtherSlaves) {
    verifies<req::CO_LSS_043>();
    const std::vector<Exchange> fitting{{"7E5#465F000000000000", {}}, {"7E5#47010302AA000000", {}},
                                        {"7E5#4801000100000000", {}}, {"7E5#4903000100000000", {}},
                                        {"7E5#4A20112620000000", {}}, {"7E5#4B22112620000000", {}}};
    const std::vector<std::pair<std::size_t, const char*>> misfits{
        {0, "7E5#465E000000000000"},   // another vendor
        {1, "7E5#4702030200000000"},   // another product
        {1, "7E5#47FFFFFFFF000000"},   // which need not be a lower number
        {2, "7E5#4803000100000000"},   // revisions from 00010003h
        {3, "7E5#4901000100000000"},   // revisions to 00010001h
        {4, "7E5#4A22112620000000"},   // serial numbers from 20261122h
        {5, "7E5#4B20112620000000"}};  // serial numbers to 20261120h
    for (const auto& [at, request] : misfits) {
        std::vector<Exchange> conversation = fitting;
        conversation[at].request = request;
        talk(conversation);
    }
    for (std::size_t missing = 0; missing < fitting.size(); ++missing) {
        std::vector<Exchange> conversation = fitting;
        conversation.erase(conversation.begin() + static_cast<std::ptrdiff_t>(missing));
        talk(conversation);
    }
    std::vector<Exchange> twisted = fitting;
    std::swap(twisted[2], twisted[3]);
    talk(twisted);
    std::vector<Exchange> whole = fitting;
    whole[5].answers = {"7E4#4F00000000000000"};
    talk(whole);
    talk({{"7E5#4B22112620000000", {}}});  // the last frame alone is none
}

TEST_F(Lss, IdentifyRemoteSlaveBeginsAnewWithAVendorId) {
    verifies<req::CO_LSS_043>();
    talk({{"7E5#465F000000000000", {}},
          {"7E5#47010302AA000000", {}},
          {"7E5#4802000100000000", {}},
          {"7E5#465F000000000000", {}},
          {"7E5#47010302AA000000", {}},
          {"7E5#4802000100000000", {}},
          {"7E5#4902000100000000", {}},
          {"7E5#4A21112620000000", {}},
          {"7E5#4B21112620000000", {"7E4#4F00000000000000"}}});
}

// 6.6.4
TEST_F(Lss, IdentifyNonConfiguredIsForSlavesWithoutANodeId) {
    verifies<req::CO_LSS_044, req::CO_E_LSS_ANSWER>();
    talk({{"7E5#4C00000000000000", {}},
          {"7E5#0401000000000000", {}},
          {"7E5#4C00000000000000", {}},
          {"7E5#11FF000000000000", {"7E4#1100000000000000"}},
          {"7E5#4C00000000000000", {}}});  // its active node-ID is 5 still
}

TEST_F(Unconfigured, IdentifyNonConfiguredIsAnsweredInBothStates) {
    verifies<req::CO_LSS_044, req::CO_E_LSS_ANSWER>();
    talk({{"7E5#4C00000000000000", {"7E4#5000000000000000"}},
          {"7E5#0401000000000000", {}},
          {"7E5#4C00000000000000", {"7E4#5000000000000000"}},
          {"7E5#1107000000000000", {"7E4#1100000000000000"}},
          {"7E5#4C00000000000000", {}},  // one is pending
          {"7E5#0400000000000000", {"707#00"}},
          {"7E5#4C00000000000000", {}}});
}

// -- Fastscan, 6.7: 51h, number (32 bit), bit check, which of the four (0 to 3), which is next
// --------------------------

TEST_F(Unconfigured, FastscanLeadsThroughTheFourNumbers) {
    verifies<req::CO_LSS_050, req::CO_LSS_051, req::CO_LSS_052, req::CO_LSS_053, req::CO_LSS_054, req::CO_E_LSS_NUMBER,
             req::CO_K_LSS_RESTART, req::CO_K_LSS_HIGHEST_BIT>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#5100000000800000", yes},  // who is there?
          {"7E5#51000000001F0000", yes},  // vendor-ID, bit 31 is 0
          {"7E5#51000000801F0000", {}},   // it is not 1
          {"7E5#5100000000070000", yes},  // bits 31 to 7 are 0 (5Fh = 0101 1111b)
          {"7E5#5100000000060000", {}},   // bit 6 is not
          {"7E5#5140000000060000", yes},
          {"7E5#5140000000050000", yes},
          {"7E5#5140000000040000", {}},
          {"7E5#515E000000010000", yes},
          {"7E5#515E000000000000", {}},   // the last bit is 1
          {"7E5#515F000000000000", yes},  // all bits, but the scan stays here
          {"7E5#51010302AA000101", {}},   // not asked for yet
          {"7E5#515F000000000001", yes},  // confirmed, product code next
          {"7E5#515F000000000001", {}},   // the vendor-ID is done with
          {"7E5#51000000001F0101", {}},   // AA020301h: bit 31 is 1
          {"7E5#51000000801F0101", yes},
          {"7E5#51010302AA000102", yes},
          {"7E5#5102000100000203", yes}});
    EXPECT_FALSE(is_configuring());
    talk({{"7E5#5121112620000300", yes}});
    EXPECT_TRUE(is_configuring());
    talk({{"7E5#1107000000000000", {"7E4#1100000000000000"}}, {"7E5#0400000000000000", {"707#00"}}});
}

TEST_F(Unconfigured, FastscanFindsTheAddressBitByBit) {
    verifies<req::CO_LSS_052, req::CO_LSS_053, req::CO_LSS_054, req::CO_E_LSS_NUMBER, req::CO_K_LSS_RESTART,
             req::CO_K_LSS_HIGHEST_BIT>();
    const auto ask = [this](std::uint32_t number, unsigned bit_check, unsigned which, unsigned next) {
        char request[32];
        std::snprintf(request, sizeof request, "7E5#51%02X%02X%02X%02X%02X%02X%02X",
                      static_cast<unsigned>(number & 0xFFU), static_cast<unsigned>((number >> 8U) & 0xFFU),
                      static_cast<unsigned>((number >> 16U) & 0xFFU), static_cast<unsigned>(number >> 24U), bit_check,
                      which, next);
        return !send(request).empty();
    };
    ASSERT_TRUE(ask(0, 128, 0, 0));
    std::vector<std::uint32_t> found;
    for (unsigned which = 0; which < 4; ++which) {
        std::uint32_t number = 0;
        for (unsigned bit = 32; bit-- > 0;) {
            number |= ask(number, bit, which, which) ? 0U : 1U << bit;
        }
        EXPECT_FALSE(is_configuring());
        ASSERT_TRUE(ask(number, 0, which, (which + 1) % 4));
        found.push_back(number);
    }
    EXPECT_TRUE(is_configuring());
    EXPECT_EQ(found, (std::vector<std::uint32_t>{0x5F, 0xAA020301, 0x00010002, 0x20261121}));
}

TEST_F(Unconfigured, FastscanIsNeverCompleteBeforeAllFourAreConfirmed) {
    verifies<req::CO_LSS_054, req::CO_LSS_053>();
    const Frames yes{"7E4#4F00000000000000"};
    const std::vector<std::vector<Exchange>> shortcuts{
        {{"7E5#515F000000000003", yes}, {"7E5#5121112620000300", yes}},  // vendor, then serial number
        {{"7E5#515F000000000001", yes}, {"7E5#51010302AA000100", yes}},  // back from the product code
        {{"7E5#515F000000000002", yes}, {"7E5#5102000100000203", yes}, {"7E5#5121112620000300", yes}},
        {{"7E5#515F000000000001", yes}, {"7E5#51010302AA000103", yes}, {"7E5#5121112620000300", yes}},
        {{"7E5#515F000000000001", yes},
         {"7E5#51010302AA000102", yes},
         {"7E5#5102000100000203", yes},
         {"7E5#5121112620000303", yes}},  // the last is not left: nothing is confirmed
        {{"7E5#515F000000000001", yes},
         {"7E5#51010302AA000102", yes},
         {"7E5#5102000100000203", yes},
         {"7E5#5120112620010300", yes}},  // not all bits
        {{"7E5#515F000000000001", yes},
         {"7E5#51010302AA000102", yes},
         {"7E5#5102000100000203", yes},
         {"7E5#5122112620000300", {}}},  // another unit
        {{"7E5#515F000000000001", yes},
         {"7E5#5100000080010103", {}},  // a mismatch moves nothing …
         {"7E5#5121112620000300", {}},
         {"7E5#51000000801F0103", yes},  // … nor does a match of some bits
         {"7E5#5121112620000300", {}}}};
    for (const auto& conversation : shortcuts) {
        talk({{"7E5#5100000000800000", yes}});
        talk(conversation);
        EXPECT_FALSE(is_configuring());
    }
}

TEST_F(Unconfigured, AMasterMayLeadThroughTheNumbersInAnyOrder) {
    verifies<req::CO_LSS_053, req::CO_LSS_054>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#5100000000800000", yes},
          {"7E5#515F000000000003", yes},
          {"7E5#5121112620000301", yes},
          {"7E5#51010302AA000102", yes}});
    EXPECT_FALSE(is_configuring());
    talk({{"7E5#5102000100000200", yes}});
    EXPECT_TRUE(is_configuring());
}

TEST_F(Unconfigured, FastscanBeginsWithTheVendorIdAndBitCheck128BeginsAnew) {
    verifies<req::CO_LSS_051>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#51010302AA000102", {}},  // power-on: the vendor-ID is asked for
          {"7E5#515F000000000001", yes},
          {"7E5#51010302AA000102", yes},
          {"7E5#5102000100000203", yes},
          {"7E5#51FFFFFFFF800203", yes},  // whatever else it says
          {"7E5#5121112620000300", {}},   // the scan is at the vendor-ID
          {"7E5#515F000000000003", yes},
          {"7E5#5121112620000300", yes}});
    EXPECT_FALSE(is_configuring());  // product code and revision are forgotten
}

TEST_F(Unconfigured, AFastscanBeginsAnewAfterAResetAndAfterACompleteOne) {
    verifies<req::CO_LSS_004, req::CO_LSS_054>();
    const Frames yes{"7E4#4F00000000000000"};
    const std::vector<Exchange> three{
        {"7E5#515F000000000001", yes}, {"7E5#51010302AA000102", yes}, {"7E5#5102000100000203", yes}};
    talk(three);
    start({255, 125000});
    talk({{"7E5#5121112620000300", {}}, {"7E5#515F000000000003", yes}, {"7E5#5121112620000300", yes}});
    EXPECT_FALSE(is_configuring());
    talk({{"7E5#5100000000800000", yes}});
    talk(three);
    talk({{"7E5#5121112620000300", yes}, {"7E5#0400000000000000", {}}});
    talk({{"7E5#515F000000000003", yes}, {"7E5#5121112620000300", yes}});  // of the next scan
    EXPECT_FALSE(is_configuring());
}

TEST_F(Unconfigured, AFastscanThatAResetInterruptsBeginsAnew) {
    verifies<req::CO_LSS_004>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#515F000000000001", yes},
          {"7E5#51010302AA000102", yes},
          {"7E5#5102000100000203", yes},
          {"7E5#0401000000000000", {}},
          {"7E5#1105000000000000", {"7E4#1100000000000000"}},
          {"7E5#0400000000000000", {"705#00"}},
          {"7E5#0401000000000000", {}},
          {"7E5#11FF000000000000", {"7E4#1100000000000000"}},
          {"000#8205", {}},
          {"7E5#5121112620000300", {}},
          {"7E5#515F000000000003", yes},
          {"7E5#5121112620000300", yes}});
    EXPECT_FALSE(is_configuring());
}

TEST_F(Unconfigured, AFastscanGoesOnAfterAVisitToLssConfiguration) {
    verifies<req::CO_LSS_054>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#515F000000000001", yes},
          {"7E5#0401000000000000", {}},
          {"7E5#0400000000000000", {}},  // no node-ID was given: nothing is reset
          {"7E5#515F000000000001", {}},  // the product code is asked for
          {"7E5#51010302AA000102", yes}});
}

TEST_F(Unconfigured, FastscanIgnoresWhatDoesNotExist) {
    verifies<req::CO_LSS_055, req::CO_K_LSS_RESTART, req::CO_K_LSS_HIGHEST_BIT>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#5100000000800000", yes},
          {"7E5#515F0000001F0000", yes},
          {"7E5#515F000000200000", {}},  // bit check 32
          {"7E5#515F0000007F0000", {}},  // 127
          {"7E5#515F000000810000", {}},  // 129
          {"7E5#515F000000FF0000", {}},
          {"7E5#515F000000000400", {}},  // a fifth number
          {"7E5#515F00000000FF00", {}},
          {"7E5#515F000000000004", {}},  // a fifth number next
          {"7E5#515F0000000000FF", {}},
          {"7E5#515F0000001F0004", {}},
          {"7E5#515F000000010000", yes},
          {"7E5#515F000000000001", yes}});
}

TEST_F(Lss, FastscanIsForSlavesWithoutANodeId) {
    verifies<req::CO_LSS_050>();
    talk({{"7E5#5100000000800000", {}},
          {"7E5#515F000000000000", {}},
          {"7E5#0401000000000000", {}},
          {"7E5#11FF000000000000", {"7E4#1100000000000000"}},
          {"7E5#0400000000000000", {}},
          {"7E5#5100000000800000", {}}});  // its active node-ID is 5 still
}

TEST_F(Unconfigured, FastscanNeedsLssWaitingAndNoPendingNodeId) {
    verifies<req::CO_LSS_050, req::CO_T_LSS>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#5100000000800000", yes},
          {"7E5#0401000000000000", {}},
          {"7E5#5100000000800000", {}},
          {"7E5#0400000000000000", {}},
          {"7E5#5100000000800000", yes}});
}

// -- frames -----------------------------------------------------------------------------------------------------------

// Each service with one byte too few, with just enough, with seven and with eight bytes.
TEST_F(Lss, AFrameNeedsTheBytesOfItsServiceAndIsAnsweredInKind) {
    verifies<req::CO_LSS_060, req::CO_LSS_061, req::CO_T_LSS>();
    configure();
    talk({{"7E5#", {}},
          {"7E5#11", {}},
          {"7E5#1107", {"7E4#110000"}},
          {"7E5#110799AABBCCDD", {"7E4#110000"}},
          {"7E5#110799AABBCCDDEE", {"7E4#1100000000000000"}},
          {"7E5#1100", {"7E4#110100"}},
          {"7E5#13", {}},
          {"7E5#1300", {}},
          {"7E5#130003", {"7E4#130000"}},
          {"7E5#13000399", {"7E4#130000"}},
          {"7E5#130003AABBCCDDEE", {"7E4#1300000000000000"}},
          {"7E5#17", {"7E4#170000"}},
          {"7E5#17AABB", {"7E4#170000"}},
          {"7E5#17AABBCCDDEEFF00", {"7E4#1700000000000000"}},
          {"7E5#5A", {"7E4#5A5F000000"}},
          {"7E5#5B", {"7E4#5B010302AA"}},
          {"7E5#5C", {"7E4#5C02000100"}},
          {"7E5#5D", {"7E4#5D21112620"}},
          {"7E5#5E", {"7E4#5E05"}},
          {"7E5#5EFFFFFFFFFFFF", {"7E4#5E05"}},
          {"7E5#5EFFFFFFFFFFFFFF", {"7E4#5E05000000000000"}},
          {"7E5#15", {}},
          {"7E5#1500", {}}});  // too short: no silence follows
    EXPECT_EQ(bit_rate(), 125000U);
    talk({{"7E5#5E", {"7E4#5E05"}}, {"7E5#04", {}}, {"7E5#5E", {"7E4#5E05"}}, {"7E5#150000", {}}});
    EXPECT_EQ(bit_rate(), 250000U);
    talk({{"7E5#0400", {}}, {"7E5#5E", {}}, {"7E5#04", {}}, {"7E5#5E", {}}, {"7E5#0401FFFFFFFFFFFF", {}}});
    EXPECT_TRUE(is_configuring());
}

TEST_F(Lss, ShortFramesOfASequenceAreNotCounted) {
    verifies<req::CO_LSS_060, req::CO_LSS_061, req::CO_T_LSS>();
    talk(
        {{"7E5#405F0000", {}},           {"7E5#41010302AA", {}}, {"7E5#4202000100", {}}, {"7E5#4321112620", {}},
         {"7E5#405F000000", {}},         {"7E5#41010302", {}},  // ignored: the sequence goes on
         {"7E5#41010302AA", {}},         {"7E5#42020001", {}},   {"7E5#4202000100", {}}, {"7E5#43211126", {}},
         {"7E5#4321112620", {"7E4#44"}}, {"7E5#465F000000", {}}, {"7E5#47010302", {}},   {"7E5#47010302AA", {}},
         {"7E5#48020001", {}},           {"7E5#4802000100", {}}, {"7E5#49020001", {}},   {"7E5#4902000100", {}},
         {"7E5#4A211126", {}},           {"7E5#4A21112620", {}}, {"7E5#4B211126", {}},   {"7E5#4B21112620", {"7E4#4F"}},
         {"7E5#465F0000", {}},           {"7E5#47010302AA", {}}, {"7E5#4802000100", {}}, {"7E5#4902000100", {}},
         {"7E5#4A21112620", {}},         {"7E5#4B21112620", {}}});
}

TEST_F(Unconfigured, AFastscanRequestHasEightBytes) {
    verifies<req::CO_LSS_060, req::CO_LSS_061, req::CO_T_LSS>();
    talk({{"7E5#51000000008000", {}},
          {"7E5#5100000000800000", {"7E4#4F00000000000000"}},
          {"7E5#4C", {"7E4#50"}},
          {"7E5#4C00000000000000", {"7E4#5000000000000000"}}});
}

TEST_F(Lss, OtherFramesAreNoRequests) {
    verifies<req::CO_LSS_062, req::CO_K_LSS_REQUEST_ID>();
    talk({{"7E5#R", {}},
          {"7E5#R8", {}},
          {"000007E5#0401000000000000", {}},
          {"7E4#0401000000000000", {}},
          {"7E6#0401000000000000", {}}});
    EXPECT_FALSE(is_configuring());
    configure();
    for (int specifier = 0; specifier <= 255; ++specifier) {
        const bool known = specifier == 0x04 || specifier == 0x11 || specifier == 0x13 || specifier == 0x15 ||
                           specifier == 0x17 || (specifier >= 0x40 && specifier <= 0x43) ||
                           (specifier >= 0x46 && specifier <= 0x4C) || specifier == 0x51 ||
                           (specifier >= 0x5A && specifier <= 0x5E);
        char request[32];
        std::snprintf(request, sizeof request, "7E5#%02X01000000000000", static_cast<unsigned>(specifier) & 0xFFU);
        if (!known) {
            EXPECT_TRUE(send(request).empty()) << request;
            EXPECT_TRUE(is_configuring()) << request;
        }
    }
}

// CBX-AO412, 7.5: no LSS among its identifiers
TEST_F(CbxTest, ADeviceWithoutLssIgnoresItsMaster) {
    verifies<req::CO_LSS_064>();
    for (const char* frame : {"7E5#0401000000000000", "7E5#5E00000000000000", "7E5#110A000000000000",
                              "7E5#1300030000000000", "7E5#1700000000000000", "7E5#1564000000000000",
                              "7E5#0400000000000000", "7E5#4C00000000000000", "7E5#5100000000800000"}) {
        EXPECT_EQ(send(frame), Frames{}) << frame;
    }
    EXPECT_EQ(send("000#8203"), (Frames{"703#00"}));
}

}  // namespace canproof::test
