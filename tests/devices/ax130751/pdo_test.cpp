// SPDX-License-Identifier: Apache-2.0
// PDOs of the AX130751 with default parameters and after changes (manual, 3.2.14, 3.2.15). Node 127: RPDOs on 27Fh,
// 37Fh, 47Fh and 57Fh, TPDOs on 1FFh, 2FFh, 3FFh and 4FFh.
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Ax130751Pdo = Ax130751Test;

constexpr std::int64_t no_rtr = 0x40000000;

}  // namespace

TEST_F(Ax130751Pdo, Rpdo1SetsBothProcessValuesAndTheRelay) {
    verifies<req::AOR_PDO_001, req::AOR_OD_1400, req::AOR_OD_1600, req::AOR_OD_7300, req::AOR_OD_6220>();
    start();
    send("27F#E80318FC01");  // 7300h:1 = 1000, 7300h:2 = -1000, the relay ON
    EXPECT_EQ(read(0x7300, 1), 1000U);
    EXPECT_EQ(read(0x7300, 2), 0xFC18U);
    EXPECT_EQ(read(0x6220, 3), 1U);
    EXPECT_EQ(read(0x6220, 1), 0U);
    send("27F#0000000000");
    EXPECT_EQ(read(0x7300, 1), 0U);
    EXPECT_EQ(read(0x6220, 3), 0U);
}

TEST_F(Ax130751Pdo, Rpdo4SetsTheDigitalOutputs) {
    verifies<req::AOR_PDO_002, req::AOR_OD_1403, req::AOR_OD_1603, req::AOR_OD_6220>();
    start();
    send("57F#0001");
    EXPECT_EQ(read(0x6220, 1), 0U);
    EXPECT_EQ(read(0x6220, 2), 1U);
    send("57F#0100");
    EXPECT_EQ(read(0x6220, 1), 1U);
    EXPECT_EQ(read(0x6220, 2), 0U);
    EXPECT_EQ(read(0x6220, 3), 0U);
}

TEST_F(Ax130751Pdo, Rpdo1SetsNothingInPreOperationalAndInStopped) {
    verifies<req::AOR_PDO_001>();
    send("27F#E80318FC01");
    EXPECT_EQ(read(0x7300, 1), 0U);
    EXPECT_EQ(read(0x7300, 2), 0U);
    EXPECT_EQ(read(0x6220, 3), 0U);
    start();
    send("000#027F");
    send("27F#E80318FC01");
    start();
    EXPECT_EQ(read(0x7300, 1), 0U) << "received in stopped";
    EXPECT_EQ(read(0x7300, 2), 0U);
    EXPECT_EQ(read(0x6220, 3), 0U);
}

TEST_F(Ax130751Pdo, Rpdo2And3SetNothingUntilTheyAreMadeValid) {
    verifies<req::AOR_PDO_003, req::AOR_PDO_010, req::AOR_OD_1401, req::AOR_OD_1402, req::AOR_OD_1601, req::AOR_OD_1602,
             req::AOR_OD_2500>();
    start();
    send("37F#010002000300");
    send("47F#040005000600");
    for (int number = 1; number <= 6; ++number) {
        EXPECT_EQ(read(0x2500, number), 0U) << number;
    }
    EXPECT_EQ(write(0x1401, 1, no_rtr + 0x37F, 4), "");
    EXPECT_EQ(write(0x1402, 1, no_rtr + 0x47F, 4), "");
    send("37F#010002000300");
    send("47F#040005000600");
    for (int number = 1; number <= 6; ++number) {
        EXPECT_EQ(read(0x2500, number), static_cast<std::uint64_t>(number));
    }
}

TEST_F(Ax130751Pdo, Tpdo1IsSentEveryTenthOfASecond) {
    verifies<req::AOR_PDO_004, req::AOR_OD_1800, req::AOR_OD_1A00, req::AOR_OD_2370>();
    EXPECT_EQ(pass(300), Frames{});  // no TPDO is sent in pre-operational
    EXPECT_EQ(start(), (Frames{"1FF#00000000"}));
    EXPECT_EQ(pass(350), (Frames{"100:1FF#00000000", "200:1FF#00000000", "300:1FF#00000000"}));
    send("000#807F");
    EXPECT_EQ(pass(300), Frames{});
}

TEST_F(Ax130751Pdo, Tpdo1CarriesTheFeedbackOfBothOutputs) {
    verifies<req::AOR_PDO_004, req::AOR_OD_1A00, req::AOR_OD_2370>();
    EXPECT_EQ(write(0x2330, 1, 0, 2), "");  // output 1 has no ramps
    EXPECT_EQ(write(0x2330, 2, 0, 2), "");
    start();
    send("27F#E803D00700");  // 1000 mV and 2000 mV
    EXPECT_EQ(pass(100).back(), "100:1FF#E803D007");
}

TEST_F(Ax130751Pdo, Tpdo2To4AreInvalidByDefaultAndAreNotSentWithATimer) {
    verifies<req::AOR_PDO_005>();
    EXPECT_EQ(write(0x1800, 5, 0, 2), "");  // the event timer of TPDO1 is off
    for (int number = 1; number <= 3; ++number) {
        const auto index = static_cast<std::uint16_t>(0x1800 + number);
        const std::uint64_t cob_id = read(index, 1);
        EXPECT_EQ(cob_id >> 31U, 1U) << "bit 31: not valid, " << number;
        EXPECT_EQ(cob_id & 0x7FFU, static_cast<std::uint64_t>(0x180 + 0x100 * number + 127));
        EXPECT_EQ(write(index, 5, 50, 2), "");
    }
    start();
    EXPECT_EQ(pass(200), Frames{});
}

TEST_F(Ax130751Pdo, Tpdo2And4AreSentOnceValidWithATimerButTheEmptyTpdo3IsNot) {
    verifies<req::AOR_PDO_005, req::AOR_PDO_011, req::AOR_PDO_012, req::AOR_OD_1801, req::AOR_OD_1802, req::AOR_OD_1803,
             req::AOR_OD_1A01, req::AOR_OD_1A02, req::AOR_OD_1A03, req::AOR_OD_7330, req::AOR_OD_5020, req::AOR_OD_5030,
             req::AOR_PDO_013>();
    inputs.supply = 24.0F;
    inputs.cpu_temperature = 35.0F;
    set_inputs();
    EXPECT_EQ(write(0x1800, 5, 0, 2), "");  // the event timer of TPDO1 is off
    start();
    EXPECT_EQ(pass(200), Frames{});
    send("27F#E803D00700");
    for (int number = 1; number <= 3; ++number) {
        const auto index = static_cast<std::uint16_t>(0x1800 + number);
        EXPECT_EQ(write(index, 5, 50, 2), "");
        EXPECT_EQ(write(index, 1, no_rtr + 0x1FF + 0x100 * number, 4), "");
    }
    // TPDO2 carries 1000 and 2000, TPDO4 carries 24.0 (41C00000h) and 35.0 (420C0000h). TPDO3 maps nothing and is not
    // sent.
    const Frames frames = pass(60);
    ASSERT_GE(frames.size(), 2U);
    EXPECT_EQ(frames[frames.size() - 2], "50:2FF#E803D007");
    EXPECT_EQ(frames[frames.size() - 1], "50:4FF#0000C04100000C42");
    for (const auto& frame : frames) {
        EXPECT_EQ(frame.find(":3FF#"), std::string::npos) << frame;
    }
}

TEST_F(Ax130751Pdo, ChangeOfAMappedValueSendsNoTpdoWhoseEventTimerIs0) {
    verifies<req::AOR_PDO_006>();
    EXPECT_EQ(write(0x1800, 5, 0, 2), "");
    EXPECT_EQ(write(0x1801, 1, no_rtr + 0x2FF, 4), "");  // valid, but its event timer is 0
    EXPECT_EQ(write(0x2330, 1, 0, 2), "");
    EXPECT_EQ(start(), Frames{});
    EXPECT_EQ(send("27F#E803D00700"), Frames{});
    EXPECT_EQ(pass(500), Frames{});
    EXPECT_EQ(read(0x7330, 1), 1000U);  // 7330h:1, a mapped value, has changed
}

TEST_F(Ax130751Pdo, TransmissionTypesAreFixedAndSyncTriggersNoPdo) {
    verifies<req::AOR_PDO_007, req::AOR_OD_1400, req::AOR_OD_1800>();
    for (const int index : {0x1400, 0x1401, 0x1402, 0x1403}) {
        EXPECT_EQ(read(static_cast<std::uint16_t>(index), 2), 255U);
        EXPECT_EQ(write(static_cast<std::uint16_t>(index), 2, 1, 1), "06010002");
    }
    for (const int index : {0x1800, 0x1801, 0x1802, 0x1803}) {
        EXPECT_EQ(read(static_cast<std::uint16_t>(index), 2), 254U);
        EXPECT_EQ(write(static_cast<std::uint16_t>(index), 2, 1, 1), "06010002");
    }
    EXPECT_EQ(refusal(0x1005, 0), "06020000");
    EXPECT_EQ(write(0x1800, 5, 0, 2), "");
    start();
    pass(10);
    for (const int index : {0x1401, 0x1402, 0x1403}) {
        const int number = index - 0x1400;
        EXPECT_EQ(write(static_cast<std::uint16_t>(index), 1, 0x4000027F + (0x100 * number), 4), "");
    }
    send("27F#D204000000");
    send("37F#070000000000");
    send("47F#080000000000");
    send("57F#0100");
    EXPECT_EQ(read(0x7300, 1), 1234U) << "RPDO1 takes effect without a SYNC";
    EXPECT_EQ(read(0x2500, 1), 7U) << "RPDO2";
    EXPECT_EQ(read(0x2500, 4), 8U) << "RPDO3";
    EXPECT_EQ(read(0x6220, 1), 1U) << "RPDO4";
    EXPECT_EQ(send("080#"), Frames{});
    EXPECT_EQ(pass(50), Frames{});
}

TEST_F(Ax130751Pdo, Tpdo1DoesNotAnswerRemoteFramesAsShipped) {
    verifies<req::AOR_OD_1800>();
    EXPECT_EQ(write(0x1800, 5, 0, 2), "");
    start();
    EXPECT_EQ(send("1FF#R"), Frames{});
    EXPECT_EQ(pass(20), Frames{});
    EXPECT_EQ(write(0x1800, 1, 0xC00001FF, 4), "");
    EXPECT_EQ(write(0x1800, 1, 0x000001FF, 4), "");  // 1800h:1 COB-ID of TPDO1: RTR allowed
    // 1800h:2 (transmission type of TPDO1) is 254 by default: without an inhibit time the answer to the RTR comes at
    // once. It carries the present feedback values, which are 0.
    EXPECT_EQ(send("1FF#R"), Frames{"1FF#00000000"});
}

// Section 3.2.14: to remap a PDO, a client makes it invalid, disables its mapping, changes it, enables it, and makes
// the PDO valid.
TEST_F(Ax130751Pdo, PdoIsRemappedInFiveSteps) {
    verifies<req::AOR_PDO_008, req::AOR_OD_1600, req::AOR_OD_1A02>();
    EXPECT_EQ(write(0x1600, 0, 0, 1), "08000022");  // RPDO1 still exists
    EXPECT_EQ(write(0x1600, 1, 0x25000110, 4), "08000022");
    EXPECT_EQ(write(0x1400, 1, 0xC000027F, 4), "");
    EXPECT_EQ(write(0x1600, 1, 0x25000110, 4), "08000022");  // 1600h:0 (number of mapped objects) of RPDO1 is not 0 yet
    EXPECT_EQ(write(0x1600, 0, 0, 1), "");
    EXPECT_EQ(write(0x1600, 1, 0x25000110, 4), "");
    EXPECT_EQ(write(0x1600, 0, 1, 1), "");
    EXPECT_EQ(write(0x1400, 1, 0x4000027F, 4), "");
    start();
    send("27F#2A00");
    EXPECT_EQ(read(0x2500, 1), 42U);

    EXPECT_EQ(write(0x1A02, 1, 0x40300110, 4), "");  // accepted, because TPDO3 is not valid and its mapping is disabled
    EXPECT_EQ(write(0x1A02, 0, 1, 1), "");
    EXPECT_EQ(write(0x1802, 5, 20, 2), "");
    EXPECT_EQ(write(0x1800, 5, 0, 2), "");
    EXPECT_EQ(write(0x1802, 1, 0x400003FF, 4), "");
    EXPECT_EQ(write(0x1A02, 0, 0, 1), "08000022");
    EXPECT_EQ(pass(25).back(), "20:3FF#0000");
}

TEST_F(Ax130751Pdo, OnlyMappableObjectsCanBeMapped) {
    verifies<req::AOR_PDO_008, req::AOR_OD_2370, req::AOR_OD_7330, req::AOR_OD_2223, req::AOR_OD_2250>();
    EXPECT_EQ(write(0x1601, 0, 0, 1), "");
    EXPECT_EQ(write(0x1601, 1, 0x22230110, 4), "");          // accepted: 2223h:1 (DO Blink Rate)
    EXPECT_EQ(write(0x1601, 1, 0x22500110, 4), "");          // accepted: 2250h:1 (Relay Blink Rate)
    EXPECT_EQ(write(0x1601, 1, 0x23700110, 4), "06040041");  // 2370h:1 (AO Feedback Field Value) is read-only
    EXPECT_EQ(write(0x1601, 1, 0x23300110, 4), "06040041");  // 2330h:1 (AO Ramp Up) is a parameter
    EXPECT_EQ(write(0x1601, 1, 0x25000108, 4), "06040041");  // 2500h:1 has 16 bits, not 8
    EXPECT_EQ(write(0x1601, 1, 0x25000710, 4), "06090011");
    EXPECT_EQ(write(0x1601, 1, 0x25010010, 4), "06020000");
    EXPECT_EQ(write(0x1A01, 0, 0, 1), "");
    EXPECT_EQ(write(0x1A01, 1, 0x33100108, 4), "");  // accepted: 3310h:1 (Logic Block Selected Table)
    EXPECT_EQ(write(0x1A01, 2, 0x31080010, 4), "");  // accepted: 3108h (LT10 Output Y-Axis PV)
    EXPECT_EQ(write(0x1A01, 1, 0x53100108, 4), "06020000");
}

// Section 3.2.14: a time-out of an RPDO is a network fault; 1029h:1 (error behaviour) determines the state.
TEST_F(Ax130751Pdo, OverdueRpdoIsACommunicationFault) {
    verifies<req::AOR_PDO_009, req::AOR_ERR_006, req::AOR_DIAG_010, req::AOR_T23, req::AOR_OD_1029>();
    EXPECT_EQ(write(0x1800, 5, 0, 2), "");
    EXPECT_EQ(write(0x1029, 1, 0, 1), "");
    EXPECT_EQ(write(0x1029, 4, 1, 1), "");  // 1029h:4 (error behaviour) is not used, despite section 3.2.14
    EXPECT_EQ(write(0x1400, 5, 200, 2), "");
    start();
    EXPECT_EQ(pass(1000), Frames{});  // an RPDO that was never received is not monitored
    send("27F#0000000000");
    EXPECT_EQ(pass(199), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:0FF#0081010000000000"}));
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_EQ(read(0x1003, 0), 1U);
    EXPECT_EQ(read(0x1003, 1), 0x00008100U);
    EXPECT_EQ(read(0x1001, 0), 1U);
    start();
    const Frames cured = send("27F#0000000000");
    ASSERT_FALSE(cured.empty());
    EXPECT_EQ(cured[0], "0FF#0000000000000000");
    EXPECT_EQ(read(0x1003, 0), 0U);
}

TEST_F(Ax130751Pdo, TooShortRpdoChangesNothingAndIsReported) {
    verifies<req::AOR_ERR_008, req::AOR_T_NODE_ERRORS, req::AOR_ERR_019>();
    EXPECT_EQ(write(0x1800, 5, 0, 2), "");
    start();
    EXPECT_EQ(send("27F#E8030000"), (Frames{"0FF#1082010000000000"}));  // error 8210h
    EXPECT_EQ(read(0x7300, 1), 0U);
    EXPECT_EQ(read(0x1003, 1), 0x00008210U);
    EXPECT_EQ(send("27F#E803000000"), (Frames{"0FF#0000000000000000"}));
    EXPECT_EQ(read(0x7300, 1), 1000U);
    EXPECT_EQ(read(0x1003, 0), 0U);
}

// Section 1.2: any value of 6220h except 0 means ON.
TEST_F(Ax130751Pdo, AnyNonZeroWriteState6220hMeansOn) {
    verifies<req::AOR_SRC_010, req::AOR_OD_6220, req::AOR_SRC_002, req::AOR_SRC_015>();
    EXPECT_EQ(write(0x6310, 1, 1020, 2), "");
    start();
    for (const int state : {1, 2, 0x80, 0xFF}) {
        SCOPED_TRACE(state);
        send(fmt::format("27F#E8030000{:02X}", state));  // RPDO1: 7300h:1, 7300h:2 (AO Output Process Value), 6220h:3
        send(fmt::format("57F#{:02X}00", state));        // RPDO4: 6220h:1 (DO Write State 1 Output Line), 6220h:2
        pass(2);
        EXPECT_EQ(read(0x7300, 1), 1000U) << "the whole RPDO is taken";
        EXPECT_TRUE(device->outputs().relay_nc);
        EXPECT_TRUE(device->outputs().out_on[0]);
        EXPECT_EQ(read(0x7330, 1), 1U) << "a logic state";
        EXPECT_EQ(read(0x6220, 1), static_cast<std::uint64_t>(state)) << "as it was written";
        send("27F#0000000000");
        send("57F#0000");
        pass(2);
        EXPECT_TRUE(device->outputs().relay_no);
        EXPECT_FALSE(device->outputs().out_on[0]);
        EXPECT_EQ(write(0x6220, 3, state, 1), "") << "by SDO alike";
        EXPECT_EQ(write(0x6220, 1, state, 1), "");
        pass(1);
        EXPECT_TRUE(device->outputs().relay_nc);
        EXPECT_TRUE(device->outputs().out_on[0]);
        EXPECT_EQ(write(0x6220, 3, 0, 1), "");
        EXPECT_EQ(write(0x6220, 1, 0, 1), "");
    }
}

TEST_F(Ax130751Pdo, ValueOutsideItsLimitsDiscardsTheWholeRpdo) {
    verifies<req::AOR_OD_2223, req::AOR_ERR_015>();
    EXPECT_EQ(write(0x1401, 1, 0xC000037F, 4), "");
    EXPECT_EQ(write(0x1601, 0, 0, 1), "");
    EXPECT_EQ(write(0x1601, 1, 0x73000110, 4), "");
    EXPECT_EQ(write(0x1601, 2, 0x22230110, 4), "");  // 2223h:1 takes 0 to 60,000
    EXPECT_EQ(write(0x1601, 0, 2, 1), "");
    EXPECT_EQ(write(0x1401, 1, no_rtr + 0x37F, 4), "");
    start();
    send("37F#E80361EA");  // 60,001 is above the maximum of 2223h (DO Blink Rate): the RPDO is refused
    EXPECT_EQ(read(0x7300, 1), 0U);
    EXPECT_EQ(read(0x2223, 1), 500U);
    send("37F#E80360EA");
    EXPECT_EQ(read(0x7300, 1), 1000U);
}

TEST_F(Ax130751Pdo, RpdoWithARefusedValueIsReportedAs8200h) {
    verifies<req::AOR_ERR_015, req::AOR_T_NODE_ERRORS, req::CO_PDO_034, req::AOR_ERR_020>();
    EXPECT_EQ(write(0x1800, 5, 0, 2), "");
    EXPECT_EQ(write(0x1401, 1, 0x8000037F, 4), "");
    EXPECT_EQ(write(0x1601, 0, 0, 1), "");
    EXPECT_EQ(write(0x1601, 1, 0x22230110, 4), "");  // 2223h:1 (DO Blink Rate 1 Output Line), 0 to 60000
    EXPECT_EQ(write(0x1601, 0, 1, 1), "");
    EXPECT_EQ(write(0x1401, 1, 0x0000037F, 4), "");
    start();
    EXPECT_EQ(send("37F#60EA"), Frames{});                          // 60,000 is accepted
    EXPECT_EQ(send("37F#61EA"), (Frames{"0FF#0082010000000000"}));  // 60,001 is refused: 8200h
    EXPECT_EQ(read(0x2223, 1), 60000U);
    EXPECT_EQ(read(0x1003, 1), 0x00008200U);
    EXPECT_EQ(send("37F#0000"), (Frames{"0FF#0000000000000000"}));
    EXPECT_EQ(read(0x2223, 1), 0U);
    EXPECT_EQ(read(0x1003, 0), 0U);
}

TEST_F(Ax130751Pdo, EmcyWaitsWhileTheQueueIsFullWithoutDelayingTheOutputs) {
    verifies<req::CO_EMCY_022>();
    EXPECT_EQ(write(0x1800, 5, 0, 2), "");
    EXPECT_EQ(write(0x2330, 1, 0, 2), "");
    start();
    for (std::size_t i = 0; i < TransmitQueue::capacity; ++i) {
        queue.push(host::parse_frame("001#", "other traffic"));
    }
    device->receive(host::parse_frame("27F#E803000000", "1000: 1 V"), now);
    device->receive(host::parse_frame("27F#00", "too short: 8210h"), now);
    now = now + milliseconds(25);
    device->advance(now);
    EXPECT_FLOAT_EQ(device->outputs().out_voltage[0], 1.0F);
    queue = TransmitQueue{};
    EXPECT_EQ(pass(1), (Frames{"1:0FF#1082010000000000"}));
}

}  // namespace canproof::test
