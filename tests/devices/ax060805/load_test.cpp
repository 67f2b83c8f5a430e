// SPDX-License-Identifier: Apache-2.0
// Gives an AX060805 the most work in one call: three full windows of the moving average, all binary functions, and all
// timers that end at the time of a sample. During a disturbance of the bus, emergency messages have waited. When these
// tests run on the microcontroller, src/target/run_suites measures the longest frame and cycle.
#include "generated/ax060805/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_load.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax060805Load : public InclinometerLoad {
  protected:
    void SetUp() override {
        InclinometerLoad::SetUp();
        for (std::uint8_t angle = 1; angle <= 3; ++angle) {
            write(0x2050, angle, 1, 1);   // 2050h (Angular Filter Type): moving average
            write(0x2051, angle, 64, 2);  // 2051h (Angular Filter Constant): the longest window
        }
        write(0x2052, 0, 5, 2);  // 2052h (Angular Filter Rate): 5 ms
        for (int function = 1; function <= 10; ++function) {
            operate(function, 1);
            connect(function, 1, 1);
            connect(function, 2, 2);
        }
        stay_in_state();
        write(0x1017, 0, period_ms, 2);
        write(0x1016, 1, 0x000B0000U + period_ms, 4);  // 1016h:1 (consumer heartbeat time): node 11
        write(0x1400, 5, period_ms, 2);
        for (std::uint16_t number = 0; number < 4; ++number) {
            const std::uint32_t valid = 0x400001FFU + (number * 0x100U);
            write(static_cast<std::uint16_t>(0x1800 + number), 1, 0x80000000U | valid, 4);
            write(static_cast<std::uint16_t>(0x1800 + number), 5, period_ms, 2);
            write(static_cast<std::uint16_t>(0x1800 + number), 1, valid, 4);
        }
        pass(period_ms);
        send("000#0100");
        hear();
    }
    /// Lets each error begin and end twice while the device can send nothing.
    void disturb() {
        disturb_bus();
        for (const bool fails : {true, false, true, false}) {
            fail_controller(fails);
            inputs.accelerometer_fault = fails;
            inputs.sensor_temperature = fails ? 200.0F : 25.0F;
            set_inputs();
            if (!fails) {
                hear();
            }
            pass(period_ms);
        }
    }
    /// Ends the disturbance 1 ms before a sample, when all timers end. `waiting` frames of others wait.
    void end_disturbance(std::size_t waiting) {
        hear();
        turn(20.0, 10.0);
        pass(period_ms - 1);
        inputs.sensor_temperature = 200.0F;
        set_inputs();
        free_bus(waiting);
    }
};

}  // namespace

// Overrun, accelerometer, heartbeat and RPDO have begun and ended: two messages each wait. The sample finds the
// temperature outside its range again, which cancels the last of its two messages: one message. Then heartbeat and RPDO
// are late again: one message each.
TEST_F(Ax060805Load, SampleWithFullWindowsWhenAllTimersEndReportsWhatHappenedInADisturbance) {
    verifies<req::INC_AVG_001, req::INC_BIN_001, req::CO_NMT_007, req::CO_EMCY_006>();
    disturb();
    end_disturbance(17);
    const Frames frames = pass(1);
    EXPECT_EQ(emergencies(frames), 11U);
    EXPECT_EQ(frames.size(), 11U + 17U + 4U) << "three TPDOs and a heartbeat";
}

TEST_F(Ax060805Load, FrameThatComesWithASampleWhenAllTimersEndIsServedAfterIt) {
    verifies<req::INC_AVG_001, req::CO_NMT_007, req::CO_EMCY_006>();
    disturb();
    end_disturbance(16);
    now = now + milliseconds(1);
    const Frames frames = send("67F#4000300100000000");
    EXPECT_EQ(emergencies(frames), 11U);
    EXPECT_EQ(frames.size(), 11U + 16U + 5U) << "three TPDOs, a heartbeat and the answer";
}

TEST_F(Ax060805Load, StartSendsAllMessagesThatWaitedInStopped) {
    verifies<req::CO_EMCY_004, req::CO_EMCY_006>();
    disturb();
    send("000#0200");
    pass(1);
    free_bus(21);
    EXPECT_EQ(emergencies(send_alone("000#0100")), 8U)
        << "begin and end of overrun, temperature and accelerometer; heartbeat and RPDO are late";
}

TEST_F(Ax060805Load, WriteThatRestartsTheFiltersReportsWhatChanged) {
    verifies<req::INC_AVG_012, req::INC_AVG_015>();
    pass(period_ms);
    write(0x2100, 0, 0, 1);  // 2100h (Pitch and Roll Angle Type): Euler angles
    write(0x2300, 0, 1, 1);  // 2300h (Auto-Null Command)
    EXPECT_EQ(read(0x2300), 0U);
}

TEST_F(Ax060805Load, FrameOfFourLateRpdosGivesThreeValues) {
    verifies<req::CO_PDO_059, req::CO_PDO_067, req::INC_RPDO_001>();
    for (int number = 1; number <= 4; ++number) {
        map_rpdo(number, 0x4000027F, {0x25000110, 0x25000210, 0x25000310, 0x25000110});
        write(static_cast<std::uint16_t>(0x13FF + number), 5, period_ms, 2);
    }
    send("27F#0100010001000100");
    fail_controller(true);
    inputs.sensor_temperature = 200.0F;
    set_inputs();
    pass(period_ms + 1);
    EXPECT_EQ(read(0x1003, 1) & 0xFFFFU, 0x8250U) << "an RPDO is overdue";
    free_bus(30);
    EXPECT_EQ(send_alone("27F#0200030004000500").size(), 31U) << "the message that the error ends";
    EXPECT_EQ(read(0x2500, 1), 5U);
    EXPECT_EQ(read(0x2500, 3), 4U);
}

}  // namespace canproof::test
