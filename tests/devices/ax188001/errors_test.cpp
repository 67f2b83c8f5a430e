// SPDX-License-Identifier: Apache-2.0
// Emergency messages, 1001h (error register), 1003h (error list) and 1029h (error behaviour) of the AX188001 (manual,
// 3.2.2, 3.2.4, 3.2.13).
#include "generated/ax188001/requirements.hpp"
#include "generated/ax188001/tables.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax188001Errors : public TcsTest {
  protected:
    void SetUp() override {
        TcsTest::SetUp();
        for (const int sub : {1, 2}) {
            write(0x4030, sub, 2, 0);
            write(0x5051, sub, 2, 0);
        }
    }
    Frames run(float cpu, float supply) {
        inputs.cpu_temperature = cpu;
        inputs.supply = supply;
        set_inputs();
        return read_once();
    }
    void expect_state(NmtState state) { EXPECT_EQ(device->state(), state); }
};

}  // namespace

TEST_F(Ax188001Errors, EmcyOfEachChannelTemperatureAndSupplyErrorHasItsCodeAndDescription) {
    verifies<req::TCS_ERR_001, req::TCS_T5, req::TCS_E_EMCY_CODE, req::TCS_E_DESCRIPTION, req::CO_EMCY_009,
             req::CO_K_EMCY_ID>();
    heat(1, 130.0);
    EXPECT_EQ(read_once(), (Frames{"165:0FF#11F0010110000000"}));
    heat(1, 260.0);
    EXPECT_EQ(read_once(), (Frames{"165:0FF#11F0010140000000"}));
    heat(2, -30.0);
    EXPECT_EQ(read_once(), (Frames{"165:0FF#11F0010220000000"}));
    heat(2, 260.0);
    EXPECT_EQ(read_once(),
              (Frames{"165:0FF#11F0010210000000", "165:0FF#0000010000000000", "165:0FF#11F0010240000000"}));
    heat(1, -30.0);
    EXPECT_EQ(read_once(),
              (Frames{"165:0FF#0000010000000000", "165:0FF#11F0010120000000", "165:0FF#0000010000000000"}));
    cut(1);
    cut(2);
    EXPECT_EQ(settle(), (Frames{"1485:0FF#01F0010100000000", "1485:0FF#01F0010200000000"}));
    EXPECT_EQ(run(111.0F, 51.0F), (Frames{"165:0FF#0042010110000000", "165:0FF#0031010210000000"}));
    EXPECT_EQ(run(111.0F, 8.0F), (Frames{"165:0FF#0000010000000000", "165:0FF#0031010320000000"}));
}

TEST_F(Ax188001Errors, LimitFaultIsReportedOnceAtItsStartAndOnceAtItsEnd) {
    verifies<req::TCS_ERR_002, req::TCS_ERR_013>();
    heat(1, 130.0);
    EXPECT_EQ(read_once().size(), 1U);
    heat(1, 135.0);
    EXPECT_EQ(pass(5000), Frames{});
    heat(1, 20.0);
    EXPECT_EQ(pass(200).size(), 1U);
    EXPECT_EQ(pass(5000), Frames{});
}

TEST_F(Ax188001Errors, ErrorListShowsActiveErrorsLatestFirst) {
    verifies<req::TCS_ERR_003, req::TCS_ERR_014, req::TCS_ERR_015, req::TCS_ERR_016, req::TCS_OD_1003, req::TCS_ERR_006,
             req::TCS_OD_1001, req::CO_EMCY_007>();
    EXPECT_EQ(read(0x1003, 0).value, 0U);
    EXPECT_EQ(read(0x1001).value, 0U);
    heat(1, 130.0);
    read_once();
    EXPECT_EQ(read(0x1001).value, 1U);
    run(120.0F, 24.0F);
    heat(2, -30.0);
    read_once();
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x2002F011, 0x10014200, 0x1001F011}));
    EXPECT_EQ(read(0x1003, 4).value, 0U);
    run(20.0F, 24.0F);
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x2002F011, 0x1001F011}));
    EXPECT_EQ(read(0x1003, 3).value, 0U);
    send("000#827F");  // reset communication
    EXPECT_EQ(read(0x1003, 0).value, 2U);
    EXPECT_EQ(read(0x1001).value, 1U);
    heat(1, 20.0);
    heat(2, 20.0);
    read_once();
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{}));
    EXPECT_EQ(read(0x1001).value, 0U);
}

TEST_F(Ax188001Errors, TenthErrorRemovesTheOldestFromTheList) {
    verifies<req::TCS_ERR_004, req::TCS_ERR_017, req::TCS_OD_1003>();
    EXPECT_EQ(read(0x1003, 9).abort, 0U);
    EXPECT_EQ(read(0x1003, 10).abort, no_subindex);
    // The ten errors: two limit faults and an open circuit on each channel, the fault detections FD1 and FD2, an
    // overrun, and a lost heartbeat.
    for (const int channel : {1, 2}) {
        heat(channel, 260.0);
        read_once();
        cut(channel);
        settle();
    }
    EXPECT_EQ(listed().size(), 6U);
    run(120.0F, 60.0F);
    inputs.can_overrun = true;
    set_inputs();
    const auto nine = listed();
    ASSERT_EQ(nine.size(), 9U);
    EXPECT_EQ(nine.front(), 0x00008110U);
    EXPECT_EQ(nine.back(), 0x1001F011U);  // the high warning of channel 1
    write(0x1016, 1, 4, 0x00310064);
    send("731#05");
    pass(101);
    const auto after = listed();
    ASSERT_EQ(after.size(), 9U);
    EXPECT_EQ(after.front(), 0x80318130U);
    EXPECT_EQ(after.back(), 0x4001F011U);
    inputs.can_overrun = false;
    set_inputs();
    EXPECT_EQ(listed().size(), 8U);  // the error that the full list has dropped does not return to it
    EXPECT_EQ(listed().back(), 0x4001F011U);
}

TEST_F(Ax188001Errors, WritingZeroToTheErrorListClearsTheListButEndsNoError) {
    verifies<req::TCS_ERR_005, req::TCS_ERR_018, req::TCS_ERR_019, req::TCS_OD_1003>();
    heat(1, 130.0);
    read_once();
    send("000#017F");
    EXPECT_EQ(write(0x1003, 0, 1, 1), out_of_range);
    EXPECT_EQ(write(0x1003, 0, 1, 9), out_of_range);
    EXPECT_EQ(write(0x1003, 1, 4, 0), read_only);
    EXPECT_EQ(write(0x1003, 0, 1, 0), 0U);
    EXPECT_TRUE(listed().empty());
    EXPECT_EQ(read(0x1003, 1).value, 0U);
    EXPECT_EQ(read(0x1001).value, 1U);
    EXPECT_EQ(status(1), 0x02);
    expect_state(NmtState::operational);
    heat(1, 20.0);
    EXPECT_EQ(read_once().back(), "165:0FF#0000000000000000");
}

TEST_F(Ax188001Errors, LostHeartbeatIsReportedWithItsProducer) {
    verifies<req::TCS_ERR_007, req::TCS_OD_1016, req::TCS_T5, req::TCS_E_EMCY_CODE, req::TCS_E_DESCRIPTION>();
    EXPECT_EQ(write(0x1016, 1, 4, 0x00310064), 0U);  // 1016h:1 consumer heartbeat time: node 49, 100 ms
    EXPECT_EQ(write(0x1016, 4, 4, 0x003200C8), 0U);  // 1016h:4 consumer heartbeat time: node 50, 200 ms
    send("731#05");
    send("732#05");
    EXPECT_EQ(pass(250), (Frames{"100:0FF#3081013180000000", "200:0FF#3081013280000000"}));
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x80328130, 0x80318130}));
    EXPECT_EQ(send("731#05"), (Frames{"0FF#0000010000000000"}));
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x80328130}));
}

TEST_F(Ax188001Errors, LifeGuardingErrorIsListedAs10008130h) {
    verifies<req::TCS_ERR_020, req::TCS_OD_100C, req::TCS_OD_100D, req::TCS_T5, req::TCS_E_EMCY_CODE,
             req::TCS_E_DESCRIPTION>();
    EXPECT_EQ(write(0x100C, 0, 2, 100), 0U);
    EXPECT_EQ(write(0x100D, 0, 1, 3), 0U);
    EXPECT_EQ(send("77F#R"), (Frames{"77F#7F"}));
    EXPECT_EQ(pass(300), (Frames{"300:0FF#3081010010000000"}));
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x10008130}));
}

TEST_F(Ax188001Errors, OverdueRpdoIsACommunicationError) {
    verifies<req::TCS_ERR_008, req::TCS_OD_1400, req::TCS_OD_1029, req::TCS_ERR_010, req::TCS_T5,
             req::TCS_E_EMCY_CODE>();
    EXPECT_EQ(write(0x1400, 5, 2, 500), 0U);
    EXPECT_EQ(write(0x1400, 1, 4, 0x4000027F), 0U);
    send("000#017F");
    sent();
    pass(600);
    EXPECT_TRUE(listed().empty());  // the monitoring of an RPDO begins only when it was received once
    send("27F#00");
    const Frames frames = pass(500);
    ASSERT_FALSE(frames.empty());
    EXPECT_EQ(frames.back(), "500:0FF#0081010000000000");
    expect_state(NmtState::pre_operational);
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x00008100}));
}

TEST_F(Ax188001Errors, OverrunAndTheEndOfBusOffAreReportedButErrorPassiveIsNot) {
    verifies<req::TCS_ERR_009, req::TCS_ERR_021, req::CO_EMCY_010, req::TCS_S_CAN_STATE, req::TCS_S_CAN_OVERRUN,
             req::TCS_T5, req::TCS_E_EMCY_CODE>();
    inputs.can_overrun = true;
    EXPECT_EQ(set_inputs(), (Frames{"0FF#1081010000000000"}));
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x00008110}));
    inputs.can_overrun = false;
    EXPECT_EQ(set_inputs(), (Frames{"0FF#0000000000000000"}));
    for (const std::uint8_t state : {std::uint8_t{1}, std::uint8_t{2}}) {
        inputs.can_state = state;
        EXPECT_EQ(set_inputs(), Frames{});  // error warning and error passive have no error code in Table 5
        EXPECT_EQ(read(0x1001).value, 0U);
    }
    inputs.can_state = 3;
    EXPECT_EQ(set_inputs(), Frames{});
    inputs.can_state = 0;
    EXPECT_EQ(set_inputs(), (Frames{"0FF#0084000000000000"}));  // no error is active: the error register is 0
    EXPECT_TRUE(listed().empty());
    EXPECT_EQ(read(0x1001).value, 0U);
}

TEST_F(Ax188001Errors, EachErrorClassHasItsOwnReactionInErrorBehaviour1029h) {
    verifies<req::TCS_ERR_010, req::TCS_OD_1029, req::TCS_T_BEHAVIOUR, req::TCS_T_REACTION>();
    struct Case {
        int sub;
        std::uint32_t value;
        NmtState then;
    };
    for (const Case& one :
         {Case{1, 0, NmtState::pre_operational}, Case{1, 1, NmtState::operational}, Case{1, 2, NmtState::stopped},
          Case{2, 0, NmtState::pre_operational}, Case{2, 1, NmtState::operational}, Case{2, 2, NmtState::stopped},
          Case{3, 0, NmtState::pre_operational}, Case{3, 1, NmtState::operational}, Case{3, 2, NmtState::stopped}}) {
        inputs = ax188001::Inputs{};
        set_inputs();
        send("000#817F");
        for (int sub = 1; sub <= 3; ++sub) {
            write(0x1029, sub, 1, sub == one.sub ? one.value : 1);
        }
        write(0x4030, 1, 2, 0);
        write(0x5051, 1, 2, 0);
        write(0x1016, 1, 4, 0x00310064);
        send("731#05");
        send("000#017F");
        if (one.sub == 2) {
            heat(1, 130.0);
            pass(90);
        } else if (one.sub == 3) {
            inputs.cpu_temperature = 120.0F;
            set_inputs();
            pass(90);
        }
        if (one.sub != 1) {
            send("731#05");
            pass(90);
        } else {
            pass(110);
        }
        expect_state(one.then);
    }
}

TEST_F(Ax188001Errors, ErrorClassesAreTheSubIndicesOfErrorBehaviour1029h) {
    verifies<req::TCS_T_REACTION>();
    namespace table = generated::ax188001::error_reaction;
    EXPECT_EQ(table::find(table::Errors::communication)->subindex, 1);
    EXPECT_EQ(table::find(table::Errors::tc_input)->subindex, 2);
    EXPECT_EQ(table::find(table::Errors::fault_detection)->subindex, 3);
}

TEST_F(Ax188001Errors, ErrorReactionsAsShippedFollowTheManual) {
    verifies<req::TCS_ERR_012, req::TCS_OD_1029, req::TCS_T_BEHAVIOUR>();
    EXPECT_EQ(read(0x1029, 0).value, 3U);
    EXPECT_EQ(read(0x1029, 1).value, 0U);
    EXPECT_EQ(read(0x1029, 2).value, 1U);
    EXPECT_EQ(read(0x1029, 3).value, 0U);
    for (int sub = 1; sub <= 3; ++sub) {
        EXPECT_NE(write(0x1029, sub, 1, 3), 0U);
        EXPECT_EQ(write(0x1029, sub, 1, 2), 0U);
    }
}

TEST_F(Ax188001Errors, EmcyIsSentBeforeTheNodeStops) {
    verifies<req::TCS_ERR_010>();
    write(0x1029, 2, 1, 2);
    send("000#017F");
    heat(1, 130.0);
    const Frames frames = pass(165);
    ASSERT_FALSE(frames.empty());
    EXPECT_EQ(frames.back(), "165:0FF#11F0010110000000");
    expect_state(NmtState::stopped);
    heat(1, 20.0);
    read_once();
    expect_state(NmtState::stopped);  // the end of the fault does not start the node again
}

TEST_F(Ax188001Errors, EachLostHeartbeatLeadsToPreOperationalAlsoWhileAnotherLasts) {
    verifies<req::TCS_ERR_010>();
    for (int slot = 1; slot <= 4; ++slot) {
        write(0x1016, slot, 4, 0x00300064U + (static_cast<std::uint32_t>(slot) << 16U));  // monitors nodes 31h to 34h
    }
    for (const char* heard_once : {"731#05", "732#05", "733#05", "734#05"}) {
        send("000#017F");  // the master starts the node although other producers are silent
        send(heard_once);
        pass(99);
        expect_state(NmtState::operational);
        pass(1);
        expect_state(NmtState::pre_operational);  // 1029h:1 (error behaviour) is 0 as shipped
    }
}

TEST_F(Ax188001Errors, MasterMayStartANodeWhoseErrorLasts) {
    verifies<req::TCS_ERR_010>();
    write(0x1029, 2, 1, 0);
    send("000#017F");
    heat(1, 130.0);
    read_once();
    expect_state(NmtState::pre_operational);
    send("000#017F");
    pass(10 * period_ms);
    expect_state(NmtState::operational);
}

TEST_F(Ax188001Errors, StoppedNodeStaysStoppedAtALimitFault) {
    verifies<req::TCS_ERR_010>();
    write(0x1029, 2, 1, 0);
    send("000#027F");
    heat(1, 130.0);
    read_once();
    expect_state(NmtState::stopped);
}

TEST_F(Ax188001Errors, DamagedStoredParametersAreReportedAndTheDefaultsApply) {
    verifies<req::TCS_ERR_011, req::TCS_T5, req::TCS_E_EMCY_CODE, req::TCS_ERR_022>();
    write(0x4010, 1, 2, 500);
    EXPECT_EQ(write(0x1010, 1, 4, 0x65766173), 0U);
    memory.bytes()[40] ^= 0xFF;
    EXPECT_EQ(power_on(), (Frames{"77F#00", "0FF#0063010000000000"}));
    EXPECT_EQ(read(0x4010, 1).word(), 1250);
    EXPECT_EQ(pass(60000), Frames{});
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x00006300}));
    EXPECT_EQ(read(0x1001).value, 1U);
}

TEST_F(Ax188001Errors, ErrorsActiveAtBootUpAreReportedAfterTheBootUpMessage) {
    verifies<req::TCS_ERR_002, req::TCS_LIM_015>();
    write(0x1010, 1, 4, 0x65766173);  // stores the parameters, with all delays set to 0
    heat(1, 130.0);
    EXPECT_EQ(power_on(), (Frames{"77F#00", "0FF#11F0010110000000"}));
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x1001F011}));
}

TEST_F(Ax188001Errors, ErrorWhoseDelayEndsWithinALateCallOfAdvanceIsReported) {
    verifies<req::TCS_ERR_002>();
    write(0x4030, 1, 2, 50);
    heat(1, 130.0);
    // the device performs five readings in one call; the first of them starts the delay
    now = now + milliseconds(5 * period_ms);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"0FF#11F0010110000000"}));
}

TEST_F(Ax188001Errors, LateCallOfAdvanceReportsAnErrorBeforeALaterReadingEndsIt) {
    verifies<req::TCS_ERR_002, req::TCS_ERR_013, req::TCS_FD_004>();
    write(0x5051, 2, 2, 100);
    run(20.0F, 55.0F);  // 55 V is read at 165 ms and reported after a delay of 100 ms, at 265 ms
    inputs.supply = 24.0F;
    set_inputs();
    now = now + milliseconds(period_ms);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"0FF#0031010210000000", "0FF#0000000000000000"}));
}

/// During bus-off the boot-up message is lost. The errors found at boot-up are not lost: 60 V exceeds the 50 V of
/// 5041h:2 (FD Set Threshold).
TEST(Ax188001BusOff, FaultFoundDuringBusOffIsReportedAfterBusOff) {
    verifies<req::TCS_ERR_002>();
    TcsBench bench;
    bench.power_on();
    EXPECT_EQ(bench.write(0x5051, 2, 2, 0), 0U);
    EXPECT_EQ(bench.write(0x1010, 1, 4, 0x65766173), 0U);
    bench.inputs.can_state = 3;
    bench.inputs.supply = 60.0F;
    EXPECT_EQ(bench.power_on(), Frames{});
    EXPECT_EQ(bench.pass(500), Frames{});
    bench.inputs.can_state = 0;
    EXPECT_EQ(bench.set_inputs(), (Frames{"0FF#0031010210000000", "0FF#0084010000000000"}));
}

}  // namespace canproof::test
