// SPDX-License-Identifier: Apache-2.0
// Errors of the AX060805 (manual, 4.2.2, 4.2.4, 4.2.13, Tables 5 and 22), node 127: emergency messages on 0FFh.
#include <algorithm>
#include <cmath>

#include "generated/ax060805/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_errors.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using List = std::vector<std::uint32_t>;

}  // namespace

TEST_F(Ax060805Errors, AccelerometerFaultIsReportedAsErrorCodeFF00h) {
    verifies<req::INC_ERR_006, req::INC_ERR_007, req::INC_ERR_001, req::INC_T22, req::INC_OD_1001, req::INC_OD_1003,
             req::INC_S_ACCELEROMETER_FAULT, req::INC_ERR_020, req::CO_EMCY_009, req::CO_K_EMCY_ID>();
    EXPECT_EQ(fail_accelerometer(), (Frames{"5:0FF#00FF010000000000"}));
    EXPECT_EQ(read(0x1001), 1U);
    EXPECT_EQ(listed(), (List{0x0000FF00}));
    EXPECT_EQ(fail_accelerometer(), (Frames{}));
    EXPECT_EQ(fail_accelerometer(false), (Frames{"5:0FF#0000000000000000"}));
    EXPECT_EQ(read(0x1001), 0U);
    EXPECT_EQ(listed(), (List{}));
}

TEST_F(Ax060805Errors, NanOrOutOfRangeAccelerationIsAnAccelerometerFault) {
    verifies<req::INC_ERR_006, req::INC_K_SENSOR_RANGE, req::INC_S_ACCELERATION_X, req::INC_S_ACCELERATION_Y,
             req::INC_S_ACCELERATION_Z>();
    struct Row {
        float x, y, z;
        std::uint32_t merit;
    };
    const std::vector<Row> rows{{NAN, 0.0F, -1.0F, 2},     {0.0F, NAN, -1.0F, 2},      {0.0F, 0.0F, NAN, 2},
                                {16.001F, 0.0F, -1.0F, 2}, {0.0F, -16.1F, 0.0F, 2},    {0.0F, 0.0F, 17.0F, 2},
                                {INFINITY, 0.0F, 0.0F, 2}, {0.0F, 0.0F, -INFINITY, 2}, {16.0F, -16.0F, 16.0F, 0}};
    for (const auto& row : rows) {
        inputs.acceleration_x = row.x;
        inputs.acceleration_y = row.y;
        inputs.acceleration_z = row.z;
        set_inputs();
        pass(5);
        EXPECT_EQ(read(0x4020), row.merit) << row.x << " " << row.y << " " << row.z;
        EXPECT_EQ(listed(), row.merit == 2 ? (List{0x0000FF00}) : (List{}));
    }
}

TEST_F(Ax060805Errors, SensorTemperatureOutsideMinus40To125DegreesIsReportedAsErrorCode4200h) {
    verifies<req::INC_ERR_005, req::INC_FOM_001, req::INC_T5, req::INC_T22, req::INC_K_TEMPERATURE_LOW,
             req::INC_K_TEMPERATURE_HIGH, req::INC_S_SENSOR_TEMPERATURE, req::INC_OD_4020, req::INC_ERR_020>();
    EXPECT_EQ(read(0x4020), 0U);
    EXPECT_EQ(heat(125.0F), (Frames{}));
    EXPECT_EQ(heat(125.1F), (Frames{"5:0FF#0042010000000000"}));
    EXPECT_EQ(read(0x4020), 1U);
    EXPECT_EQ(listed(), (List{0x00004200}));
    EXPECT_EQ(heat(-40.0F), (Frames{"5:0FF#0000000000000000"}));
    EXPECT_EQ(read(0x4020), 0U);
    EXPECT_EQ(heat(-40.1F), (Frames{"5:0FF#0042010000000000"}));
    EXPECT_EQ(read(0x4020), 1U);
    EXPECT_EQ(heat(NAN), (Frames{}));
    EXPECT_EQ(read(0x4020), 1U);
    EXPECT_EQ(heat(20.0F), (Frames{"5:0FF#0000000000000000"}));
}

TEST_F(Ax060805Errors, MostSevereConditionDeterminesTheFigureOfMerit) {
    verifies<req::INC_FOM_001, req::INC_T5, req::INC_OD_4020>();
    heat(130.0F);
    fail_accelerometer();
    EXPECT_EQ(read(0x4020), 2U);
    fail_accelerometer(false);
    EXPECT_EQ(read(0x4020), 1U);
    feel(0.0, 0.0, 0.0);
    pass(100);  // the output of the input filter falls from 1 g to nearly 0 in this time
    pass(400);
    EXPECT_EQ(read(0x4020), 1U);
    fail_accelerometer();  // temperature error, missing gravity and sensor fault at the same time
    EXPECT_EQ(read(0x4020), 2U);
    fail_accelerometer(false);
    EXPECT_EQ(read(0x4020), 1U);
    heat(30.0F);
    EXPECT_EQ(read(0x4020), 1U);
    fail_accelerometer();
    EXPECT_EQ(read(0x4020), 2U);
    feel(0.0, 0.0, -1.0);
    fail_accelerometer(false);
    EXPECT_EQ(read(0x4020), 0U);
}

TEST_F(Ax060805Errors, FailedSensorFreezesAnglesAndAccelerations) {
    verifies<req::INC_FV_007>();
    turn(30.0, 0.0);
    pass(1000);
    fail_accelerometer();
    turn(-60.0, 10.0);
    pass(1000);
    EXPECT_EQ(angles(), (std::vector<int>{30, 0, 30}));
    acceleration_digits(1000);
    EXPECT_EQ(accelerations(), (std::vector<int>{500, 0, -866}));
    fail_accelerometer(false);
    EXPECT_EQ(pitch(), -60);
}

TEST_F(Ax060805Errors, ResetWithAFailedSensorGivesTheSameValuesAsPowerOn) {
    verifies<req::INC_FV_007, req::CO_NMT_005>();
    turn(30.0, 0.0);
    pass(1000);
    fail_accelerometer();
    send("000#8100");
    EXPECT_EQ(angles(), (std::vector<int>{0, 0, 0}));  // no valid sample was taken since the reset
    EXPECT_EQ(accelerations(), (std::vector<int>{0, 0, 0}));
    power_on();
    EXPECT_EQ(angles(), (std::vector<int>{0, 0, 0}));
}

TEST_F(Ax060805Errors, SensorErrorsChangeTheNmtStateByErrorBehaviour1029hSub2) {
    verifies<req::INC_ERR_011, req::INC_OD_1029>();
    const auto state_after = [this](std::uint32_t reaction, bool by_heat) {
        send("000#8000");
        write(0x1029, 1, 1, 1);
        write(0x1029, 2, reaction, 1);
        send("000#0100");
        if (by_heat) {
            heat(126.0F);
        } else {
            fail_accelerometer();
        }
        const NmtState state = device->state();
        heat(25.0F);
        fail_accelerometer(false);
        return state;
    };
    for (const bool by_heat : {false, true}) {
        EXPECT_EQ(state_after(0, by_heat), NmtState::pre_operational);
        EXPECT_EQ(state_after(1, by_heat), NmtState::operational);
        EXPECT_EQ(state_after(2, by_heat), NmtState::stopped);
    }
    send("000#8000");
    EXPECT_EQ(refusal(0x1029, 1, 3, 1), "06090031");
    EXPECT_EQ(refusal(0x1029, 2, 3, 1), "06090031");
}

TEST_F(Ax060805Errors, MasterMayStartANodeWhoseErrorLasts) {
    verifies<req::INC_ERR_011>();
    send("000#0100");
    fail_accelerometer();
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    send("000#0100");
    pass(50);  // ten more samples with the same error
    EXPECT_EQ(device->state(), NmtState::operational);
}

TEST_F(Ax060805Errors, HotSensorPreventsTheSelfStartAfterResetCommunication) {
    verifies<req::INC_ERR_011, req::INC_START_002>();
    write(0x5555, 0, 1, 1);
    write(0x1029, 2, 0, 1);
    write(0x1010, 1, 0x65766173, 4);
    heat(130.0F);
    EXPECT_EQ(send("000#8200"), (Frames{"77F#00"}));
    pass(50);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    heat(25.0F);
    send("000#8200");
    pass(1);
    EXPECT_EQ(device->state(), NmtState::operational);
}

TEST_F(Ax060805Errors, ErrorThatEndedBeforeTheNodeHasANodeIdIsNotReported) {
    verifies<req::INC_ERR_007, req::INC_LSS_002>();
    for (const char* request : {"7E5#0401", "7E5#11FF", "7E5#17"}) {
        send(request);
    }
    EXPECT_EQ(power_on(), Frames{});
    EXPECT_EQ(heat(130.0F), Frames{});
    EXPECT_EQ(heat(25.0F), Frames{});
    send("7E5#0401");
    send("7E5#1105");
    EXPECT_EQ(send("7E5#0400"), (Frames{"705#00"}));
}

TEST_F(Ax060805Errors, SensorErrorIsReportedAtTheNextSensorSampleNotAtTheFilterRate) {
    verifies<req::INC_ERR_005, req::INC_FILTER_001>();
    write(0x2052, 0, 7, 2);
    pass(6);
    inputs.sensor_temperature = 130.0F;
    set_inputs();
    // the sample at 10 ms reports the error; the additional filters, which run at 7 ms, do not
    EXPECT_EQ(pass(4), (Frames{"4:0FF#0042010000000000"}));
}

TEST_F(Ax060805Errors, ErrorThatOutlastsResetNodeIsReportedAgain) {
    verifies<req::INC_ERR_006, req::INC_ERR_007, req::INC_ERR_011>();
    fail_accelerometer();
    EXPECT_EQ(send("000#8100"), (Frames{"77F#00", "0FF#00FF010000000000"}));
    EXPECT_EQ(listed(), (List{0x0000FF00}));
    EXPECT_EQ(read(0x4020), 2U);
    EXPECT_EQ(send("000#8200"), (Frames{"77F#00"}));
    EXPECT_EQ(read(0x1001), 1U);
}

TEST_F(Ax060805Errors, ErrorListHasRoomForFourActiveErrors) {
    verifies<req::INC_ERR_002, req::INC_OD_1003, req::INC_ERR_017, req::INC_ERR_018>();
    write(0x1029, 1, 1, 1);
    write(0x1029, 2, 1, 1);
    write(0x1400, 5, 50, 2);
    write(0x1016, 1, 0x00310064, 4);
    send("000#0100");
    fail_accelerometer();
    heat(130.0F);
    inputs.can_overrun = true;
    set_inputs();
    send("27F#000000000000");
    send("731#05");
    pass(60);  // RPDO1 becomes overdue
    EXPECT_EQ(listed(), (List{0x00008250, 0x00008110, 0x00004200, 0x0000FF00}));
    pass(50);  // the heartbeat of node 31h is missing now
    EXPECT_EQ(listed(), (List{0x80318130, 0x00008250, 0x00008110, 0x00004200}));
    heat(25.0F);
    EXPECT_EQ(listed(), (List{0x80318130, 0x00008250, 0x00008110}));
    fail_accelerometer(false);  // the accelerometer error FF00h ends; the list has already dropped its entry
    EXPECT_EQ(listed(), (List{0x80318130, 0x00008250, 0x00008110}));
    EXPECT_EQ(read(0x1003, 4), 0U);
}

TEST_F(Ax060805Errors, ErrorListCanBeClearedWhileErrorsLast) {
    verifies<req::INC_ERR_003, req::INC_ERR_013, req::INC_OD_1003, req::INC_ERR_019>();
    fail_accelerometer();
    EXPECT_EQ(refusal(0x1003, 0, 1, 1), "06090030");
    EXPECT_EQ(refusal(0x1003, 0, 15, 1), "06090030");
    EXPECT_EQ(listed(), (List{0x0000FF00}));
    write(0x1003, 0, 0, 1);
    EXPECT_EQ(listed(), (List{}));
    EXPECT_EQ(read(0x1003, 1), 0U);
    EXPECT_EQ(read(0x1001), 1U);
    EXPECT_EQ(read(0x4020), 2U);
    EXPECT_EQ(fail_accelerometer(false), (Frames{"5:0FF#0000000000000000"}));
    EXPECT_EQ(read(0x1001), 0U);
}

TEST_F(Ax060805Errors, ErrorRegisterIs1WhileAnyErrorLasts) {
    verifies<req::INC_ERR_001, req::INC_OD_1001>();
    heat(130.0F);
    inputs.can_overrun = true;
    set_inputs();
    EXPECT_EQ(read(0x1001), 1U);
    heat(25.0F);
    EXPECT_EQ(read(0x1001), 1U);
    inputs.can_overrun = false;
    set_inputs();
    EXPECT_EQ(read(0x1001), 0U);
}

TEST_F(Ax060805Errors, LostFramesAreReportedAsErrorCode8110h) {
    verifies<req::INC_ERR_008, req::INC_T22, req::INC_S_CAN_OVERRUN>();
    inputs.can_overrun = true;
    EXPECT_EQ(set_inputs(), (Frames{"0FF#1081010000000000"}));
    EXPECT_EQ(listed(), (List{0x00008110}));
    inputs.can_overrun = false;
    EXPECT_EQ(set_inputs(), (Frames{"0FF#0000000000000000"}));
}

TEST_F(Ax060805Errors, EndOfBusOffIsReportedAsErrorCode8140hButErrorPassiveIsNotReported) {
    verifies<req::INC_ERR_015, req::INC_T22, req::INC_S_CAN_STATE, req::CO_EMCY_010>();
    inputs.can_state = 2;
    EXPECT_EQ(set_inputs(), (Frames{}));
    EXPECT_EQ(read(0x1001), 0U);
    inputs.can_state = 3;
    EXPECT_EQ(set_inputs(), (Frames{}));
    inputs.can_state = 0;
    EXPECT_EQ(set_inputs(), (Frames{"0FF#4081000000000000"}));  // no error is active: the error register is 0
    EXPECT_EQ(read(0x1001), 0U);
    EXPECT_EQ(listed(), (List{}));
    pass(1000);
    EXPECT_EQ(listed(), (List{}));
}

TEST_F(Ax060805Errors, MissingHeartbeatIsReportedWithItsNodeId) {
    verifies<req::INC_ERR_004, req::INC_ERR_014, req::INC_ERR_010, req::INC_HB_002, req::INC_T22, req::INC_OD_1016,
             req::INC_HB_005>();
    write(0x1016, 1, 0x002200C8, 4);  // 1016h:1 consumer heartbeat time: node 22h, 200 ms
    pass(1000);                       // the device monitors the producer only after its first heartbeat
    EXPECT_EQ(read(0x1001), 0U);
    send("000#0100");
    send("722#05");
    const Frames told = pass(300);
    EXPECT_EQ(read(0x1001), 1U);
    EXPECT_EQ(listed(), (List{0x80228130}));
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_NE(std::find(told.begin(), told.end(), "200:0FF#3081012280000000"), told.end());
    EXPECT_EQ(send("722#05"), (Frames{"0FF#0000000000000000"}));
    EXPECT_EQ(listed(), (List{}));
}

TEST_F(Ax060805Errors, MissingGuardingRequestIsInTheErrorListAs10008130h) {
    verifies<req::INC_ERR_004, req::INC_ERR_014, req::INC_ERR_010, req::INC_T22, req::INC_OD_100C, req::INC_OD_100D>();
    write(0x100C, 0, 100, 2);
    write(0x100D, 0, 3, 1);
    write(0x1029, 1, 2, 1);
    EXPECT_EQ(send("77F#R"), (Frames{"77F#7F"}));
    EXPECT_EQ(pass(299), (Frames{}));
    EXPECT_EQ(pass(1), (Frames{"1:0FF#3081010010000000"}));
    EXPECT_EQ(device->state(), NmtState::stopped);
    send("000#8000");
    EXPECT_EQ(listed(), (List{0x10008130}));
    send("77F#R");
    EXPECT_EQ(listed(), (List{}));
}

TEST_F(Ax060805Errors, OverdueRpdoIsReportedAsErrorCode8250h) {
    verifies<req::INC_ERR_009, req::INC_ERR_010, req::INC_T22, req::INC_OD_1400>();
    write(0x1400, 5, 100, 2);
    pass(1000);
    EXPECT_EQ(read(0x1001), 0U);
    send("000#0100");
    send("27F#000000000000");
    pass(99);
    EXPECT_EQ(read(0x1001), 0U);
    EXPECT_EQ(pass(1), (Frames{"1:0FF#5082010000000000"}));
    EXPECT_EQ(listed(), (List{0x00008250}));
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    send("000#0100");
    send("27F#000000000000");
    EXPECT_EQ(listed(), (List{}));
}

TEST_F(Ax060805Errors, TooShortRpdoIsReportedAsErrorCode8210h) {
    verifies<req::INC_ERR_016, req::INC_T22>();
    send("000#0100");
    EXPECT_EQ(send("27F#0000000000"), (Frames{"0FF#1082010000000000"}));
    EXPECT_EQ(listed(), (List{0x00008210}));
    EXPECT_EQ(send("27F#010000000000"), (Frames{"0FF#0000000000000000"}));
}

TEST_F(Ax060805Errors, BusOffChangesTheNmtStateByErrorBehaviour1029hSub1) {
    verifies<req::INC_ERR_010, req::INC_OD_1029>();
    const auto state_after_bus_off = [this](std::uint32_t reaction) {
        send("000#8000");
        write(0x1029, 1, reaction, 1);
        write(0x1029, 2, 1, 1);
        send("000#0100");
        inputs.can_state = 3;
        set_inputs();
        const NmtState state = device->state();
        inputs.can_state = 0;
        set_inputs();
        return state;
    };
    EXPECT_EQ(state_after_bus_off(0), NmtState::pre_operational);
    EXPECT_EQ(state_after_bus_off(1), NmtState::operational);
    EXPECT_EQ(state_after_bus_off(2), NmtState::stopped);
}

// By section 4.2.13, a missing heartbeat and an overdue RPDO both lead to pre-operational.
TEST_F(Ax060805Errors, HeartbeatErrorAndThenRpdoTimeOutEachLeadToPreOperational) {
    verifies<req::INC_ERR_010>();
    write(0x1016, 1, 0x00220064, 4);  // 1016h:1 consumer heartbeat time: node 22h, 100 ms
    write(0x1400, 5, 100, 2);
    for (const char* heard_once : {"722#05", "27F#000000000000"}) {
        send("000#0100");
        send(heard_once);
        pass(100);
        EXPECT_EQ(device->state(), NmtState::pre_operational) << heard_once;
    }
}

TEST_F(Ax060805Errors, DamagedStoredParametersAreReportedAsErrorCode6300hAndDefaultsApply) {
    verifies<req::INC_ERR_012, req::INC_T22, req::INC_ERR_021>();
    write_real(0x2200, 0, 12.0F);
    write(0x1010, 1, 0x65766173, 4);
    std::array<std::uint8_t, 1> byte{};
    const std::size_t inside = 200;
    ASSERT_TRUE(memory.read(inside, MutableBytes{byte}));
    byte[0] = static_cast<std::uint8_t>(~byte[0]);
    ASSERT_TRUE(memory.write(inside, ByteView{byte}));
    EXPECT_EQ(power_on(), (Frames{"77F#00", "0FF#0063010000000000"}));
    EXPECT_EQ(real(0x2200), 0.0F);
    EXPECT_EQ(listed(), (List{0x00006300}));
    pass(1000);
    EXPECT_EQ(read(0x1001), 1U);
}

// During bus-off the boot-up message is lost. The errors found at boot-up are not lost.
TEST_F(Ax060805Errors, DamagedStoredParametersFoundDuringBusOffAreReportedAfterBusOff) {
    verifies<req::CO_EMCY_031, req::INC_ERR_021>();
    write(0x1010, 1, 0x65766173, 4);
    memory.bytes()[200] ^= 0x01;
    inputs.can_state = 3;
    EXPECT_EQ(power_on(), Frames{});
    EXPECT_EQ(pass(500), Frames{});
    inputs.can_state = 0;
    const Frames sent_after = set_inputs();
    EXPECT_EQ(sent_after.at(0), "0FF#0063010000000000");
}

}  // namespace canproof::test
