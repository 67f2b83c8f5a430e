// SPDX-License-Identifier: Apache-2.0
// Tests how LSS configures a slave (CiA 305, 6.4): node-ID, bit rate, activation of the bit rate, and storing.
#include "generated/canopen/requirements.hpp"
#include "tests/conformance/lss_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

// CiA 305, 6.4.2
TEST_F(Lss, ConfigureNodeIdChecksTheBoundsOfItsRange) {
    verifies<req::CO_LSS_010, req::CO_LSS_071, req::CO_K_LSS_LOWEST_NODE_ID, req::CO_K_LSS_HIGHEST_NODE_ID,
             req::CO_E_LSS_ERROR>();
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

TEST_F(Lss, ConfigureNodeIdAccepts1To127And255AndNoOtherValue) {
    verifies<req::CO_LSS_010, req::CO_LSS_071, req::CO_K_LSS_LOWEST_NODE_ID, req::CO_K_LSS_HIGHEST_NODE_ID>();
    configure();
    for (int node = 0; node <= 255; ++node) {
        const bool fits = (node >= 1 && node <= 127) || node == 255;
        char request[] = "7E5#1100";
        std::snprintf(request, sizeof request, "7E5#11%02X", static_cast<unsigned>(node) & 0xFFU);
        EXPECT_EQ(send(request), (Frames{fits ? "7E4#110000" : "7E4#110100"})) << node;
    }
}

TEST_F(Lss, RefusedNodeIdKeepsThePendingNodeId) {
    verifies<req::CO_LSS_071>();
    configure();
    talk({{"7E5#110A000000000000", {"7E4#1100000000000000"}},
          {"7E5#1100000000000000", {"7E4#1101000000000000"}},
          {"7E5#11C8000000000000", {"7E4#1101000000000000"}},
          {"000#8205", {"70A#00"}}});
}

TEST_F(Lss, NewNodeIdIsPendingUntilResetCommunication) {
    verifies<req::CO_LSS_011>();
    configure();
    talk({{"7E5#110A000000000000", {"7E4#1100000000000000"}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}},  // inquiry: the active node-ID is still 5
          {"605#4000180100000000", {"585#4300180185010000"}},  // the COB-ID of TPDO1 is 180h + 5
          {"605#4014100000000000", {"585#4314100085000000"}},  // COB-ID EMCY is 80h + 5
          {"7E5#0400000000000000", {}},                        // a new node-ID alone causes no reset
          {"605#4014100000000000", {"585#4314100085000000"}},
          {"60A#4014100000000000", {}},
          {"000#820A", {}},  // the node does not have node-ID 0Ah yet, so it ignores this reset
          {"000#8205", {"70A#00"}},
          {"605#4014100000000000", {}},
          {"60A#4014100000000000", {"58A#431410008A000000"}},  // COB-ID EMCY is 80h + 10 now
          {"000#0105", {}}});
    EXPECT_EQ(state(), NmtState::pre_operational);
    send("000#010A");
    EXPECT_EQ(state(), NmtState::operational);
    EXPECT_EQ(device->node().node_id(), 10);
}

// CiA 305, 6.4.3, table 0: 1000, 800, 500, 250, 125, reserved, 50, 20 and 10 kbit/s
TEST_F(Lss, ConfigureBitTimingAcceptsTheBitRatesOfTable0) {
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
    verifies<req::CO_LSS_072, req::CO_T_LSS_BIT_RATE, req::CO_K_LSS_STANDARD_TABLE, req::CO_E_LSS_ERROR>();
    configure();
    // The first request sets 500 kbit/s. The refused requests after it do not change this bit rate.
    talk({{"7E5#1300020000000000", {"7E4#1300000000000000"}},
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

// AX130751, Table 22: 666 kbit/s where CiA has 800 kbit/s
TEST_F(Lss, LssUsesTheBitRateTableOfTheDeviceInsteadOfThatOfCia) {
    verifies<req::CO_LSS_012, req::CO_LSS_072>();
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
    talk({{"7E5#1500000000000000", {}}});  // reset communication has not changed the pending bit rate
    EXPECT_EQ(bit_rate(), 250000U);
}

// CiA 305, 6.4.4: the test sets a heartbeat every 30 ms, so that heartbeats show when the node sends again
TEST_F(Lss, NodeIsSilentForBothSwitchDelaysAndSwitchesTheBitRateBetweenThem) {
    verifies<req::CO_LSS_014, req::CO_LSS_073, req::CO_LSS_015>();
    talk({{"605#2B1710001E000000", {"585#6017100000000000"}},
          {"7E5#0401000000000000", {}},
          {"7E5#1300030000000000", {"7E4#1300000000000000"}}});
    EXPECT_EQ(pass(65), (Frames{"30:705#7F", "60:705#7F"}));
    talk({{"7E5#1564000000000000", {}}});  // activate bit timing with a switch delay of 100 ms; heartbeats would be due
                                           // 25, 55, … 205 ms later
    EXPECT_EQ(pass(99), Frames{});
    EXPECT_EQ(bit_rate(), 125000U);
    EXPECT_EQ(pass(1), Frames{});
    EXPECT_EQ(bit_rate(), 250000U);
    EXPECT_EQ(pass(99), Frames{});
    EXPECT_EQ(pass(41), (Frames{"6:705#7F", "36:705#7F"}));  // it is 199 ms now: the heartbeats at 205 ms and 235 ms
                                                             // are sent
}

TEST_F(Lss, SwitchDelayMayBe65535Milliseconds) {
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

TEST_F(Lss, FramesReceivedDuringTheSwitchDelaysHaveNoEffect) {
    verifies<req::CO_LSS_015, req::CO_LSS_074>();
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

TEST_F(Lss, NewBitRateIsActivatedAtOnceWhenTheSwitchDelayIsZero) {
    verifies<req::CO_LSS_014, req::CO_LSS_073, req::CO_LSS_015>();
    configure();
    talk({{"7E5#1300030000000000", {"7E4#1300000000000000"}},
          {"7E5#1500000000000000", {}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}}});
    EXPECT_EQ(bit_rate(), 250000U);
}

TEST_F(Lss, ActivateBitTimingWithoutANewBitRateHasItsSwitchDelaysToo) {
    verifies<req::CO_LSS_014, req::CO_LSS_015>();
    configure();
    talk({{"7E5#1505000000000000", {}}});
    pass(9);
    talk({{"7E5#5E00000000000000", {}}});
    pass(1);
    talk({{"7E5#5E00000000000000", {"7E4#5E05000000000000"}}});
    EXPECT_EQ(bit_rate(), 125000U);
}

TEST_F(Lss, WaitingFramesAreDroppedWhenANewBitRateIsActivated) {
    verifies<req::CO_LSS_015>();
    configure();
    for (const char* frame : {"7E5#1300030000000000", "7E5#1501000000000000"}) {
        // between these two frames, the program takes no frame from the transmit queue
        device->receive(host::parse_frame(frame, "test"), now);
    }
    EXPECT_EQ(sent(), Frames{});
    EXPECT_EQ(pass(2), Frames{});
}

TEST_F(Lss, ErrorDuringTheSwitchDelaysIsReportedAfterThem) {
    verifies<req::CO_LSS_015>();
    configure();
    talk({{"7E5#150A000000000000", {}}});
    device->node().set_overrun(true, now);
    EXPECT_EQ(sent(), Frames{});
    EXPECT_EQ(pass(19), Frames{});
    const Frames told = pass(1);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].substr(0, 12), "1:085#108111");  // error 8110h; 1001h (error register) is 11h
}

TEST_F(Lss, ErrorLateInTheSwitchDelaysIsReportedAtTheirEnd) {
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

TEST_F(Lss, NodeInStoppedReportsNoErrorAfterTheSwitchDelays) {
    verifies<req::CO_LSS_015, req::CO_EMCY_004>();
    configure();
    talk({{"000#0205", {}}, {"7E5#150A000000000000", {}}});
    EXPECT_EQ(pass(20), Frames{});
    device->node().set_overrun(true, now);
    EXPECT_EQ(sent(), Frames{});
    EXPECT_EQ(pass(100), Frames{});
    talk({{"000#8005", {"085#1081110100000000"}}});
}

TEST_F(Lss, SelfStartDuringTheSwitchDelaysSendsNothing) {
    verifies<req::CO_LSS_015>();
    configure();
    talk({{"7E5#150A000000000000", {}}});
    device->node().set_overrun(true, now);
    device->node().start_at(now + milliseconds(5));  // a self-start
    EXPECT_EQ(pass(19), Frames{});
    EXPECT_EQ(state(), NmtState::operational);
    const Frames told = pass(1);
    ASSERT_FALSE(told.empty());
    EXPECT_EQ(told[0].substr(0, 12), "1:085#108111");  // the overrun is reported, 8110h
}

// CiA 301, 7.2.8.2.2: node 31h has a consumer heartbeat time of 100 ms; no heartbeat is received during the switch
// delays
TEST_F(Lss, HeartbeatMissedDuringTheSwitchDelaysIsReportedAtTheirEnd) {
    verifies<req::CO_LSS_015, req::CO_LSS_074>();
    talk({{"605#2316100164003100", {"585#6016100100000000"}},
          {"731#05", {}},
          {"7E5#0401000000000000", {}},
          {"7E5#1596000000000000", {}},  // activate bit timing, with a switch delay of 150 ms
          {"731#05", {}}});              // this heartbeat comes during the switch delays and is not received
    EXPECT_EQ(pass(299), Frames{});
    const Frames told = pass(1);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].substr(0, 12), "1:085#308111");  // error 8130h; 1001h (error register) is 11h
}

TEST_F(Lss, EndOfBusOffDoesNotEndTheSwitchDelays) {
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

TEST_F(Lss, PowerOnEndsTheSwitchDelays) {
    verifies<req::CO_LSS_017, req::CO_LSS_004>();
    configure();
    talk({{"7E5#1300030000000000", {"7E4#1300000000000000"}}, {"7E5#1564000000000000", {}}});
    pass(50);
    device->power_on({5, 125000}, now);  // the device is switched off during the switch delays and on again
    EXPECT_EQ(sent(), (Frames{"705#00"}));
    EXPECT_EQ(pass(200), Frames{});
    EXPECT_EQ(bit_rate(), 125000U);
    talk({{"605#4000100000000000", {"585#4300100078563412"}}});
}

TEST_F(Lss, BusOffOutlastsTheSwitchDelays) {
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

TEST_F(Lss, SecondSwitchDelayCountsFromTheBitRateChangeEvenIfThatIsLate) {
    verifies<req::CO_LSS_015>();
    talk({{"605#2B17100003000000", {"585#6017100000000000"}},  // 1017h producer heartbeat time: 3 ms
          {"7E5#0401000000000000", {}},
          {"7E5#1300030000000000", {"7E4#1300000000000000"}},
          {"7E5#150A000000000000", {}}});
    now = now + milliseconds(14);  // 4 ms late
    device->advance(now);
    EXPECT_EQ(bit_rate(), 250000U);
    EXPECT_EQ(sent(), Frames{});
    EXPECT_EQ(pass(9), Frames{});
    EXPECT_FALSE(pass(4).empty());
}

TEST_F(Lss, NodeInBusOffSendsNothingAfterTheSwitchDelays) {
    verifies<req::CO_EMCY_017, req::CO_LSS_015>();
    talk({{"605#2B17100003000000", {"585#6017100000000000"}},  // 1017h producer heartbeat time: 3 ms
          {"7E5#0401000000000000", {}},
          {"7E5#150A000000000000", {}}});
    device->node().set_can_state(CanState::bus_off, now);
    EXPECT_EQ(pass(100), Frames{});
    device->node().set_can_state(CanState::error_active, now);
    for (const std::string& frame : sent()) {
        EXPECT_EQ(frame.substr(0, 4), "085#") << frame << " has waited for the end of bus-off";
    }
}

// CiA 305, 6.4.5
TEST_F(Lss, StoreConfigurationStoresTheNodeIdAndBitRateForTheNextStart) {
    verifies<req::CO_LSS_016, req::CO_LSS_017>();
    configure();
    talk({{"7E5#1120000000000000", {"7E4#1100000000000000"}},
          {"7E5#1300020000000000", {"7E4#1300000000000000"}},
          {"7E5#1700000000000000", {"7E4#1700000000000000"}}});
    const LssConfiguration kept = device->stored();
    EXPECT_EQ(kept.node_id, 32);
    EXPECT_EQ(kept.bit_rate, 500000U);
    EXPECT_EQ(bit_rate(), 125000U);  // the bit rate is stored, but not activated
    EXPECT_EQ(start(kept), (Frames{"720#00"}));
    EXPECT_EQ(bit_rate(), 500000U);
}

TEST_F(Lss, StoreConfigurationReportsThatItFailedOrIsNotSupported) {
    verifies<req::CO_LSS_075, req::CO_LSS_076, req::CO_LSS_017, req::CO_E_LSS_ERROR>();
    configure();
    talk({{"7E5#1120000000000000", {"7E4#1100000000000000"}}});
    device->answer_store_with(LssError::not_supported);
    talk({{"7E5#1700000000000000", {"7E4#1701000000000000"}}});
    device->answer_store_with(LssError::storage_failed);
    talk({{"7E5#1700000000000000", {"7E4#1702000000000000"}},
          {"000#8105", {"705#00"}}});  // reset node restores node-ID 5, because nothing was stored
}

TEST_F(Lss, ResetNodeStartsWithTheStoredConfiguration) {
    verifies<req::CO_LSS_017>();
    configure();
    talk({{"7E5#1120000000000000", {"7E4#1100000000000000"}},
          {"7E5#1300020000000000", {"7E4#1300000000000000"}},
          {"7E5#1700000000000000", {"7E4#1700000000000000"}},
          {"7E5#1121000000000000", {"7E4#1100000000000000"}},  // this node-ID is not stored
          {"7E5#1300030000000000", {"7E4#1300000000000000"}},
          {"000#8105", {"720#00"}}});
    EXPECT_EQ(bit_rate(), 500000U);
    configure();
    talk({{"7E5#1500000000000000", {}}});  // the pending bit rate is the stored one again: 500 kbit/s
    EXPECT_EQ(bit_rate(), 500000U);
}

TEST_F(Lss, UnstoredConfigurationIsLostAtResetNode) {
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

}  // namespace canproof::test
