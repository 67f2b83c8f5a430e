// SPDX-License-Identifier: Apache-2.0
// Gives an AX060805 the longest cycle: a sample ends a fault of the sensor, all filters have full windows of many
// turns, all binary functions take the latency, and all timers end. Emergency messages have waited for room in the
// queue. When this test runs on the microcontroller, src/target/run_suites measures the cycle.
#include "generated/ax060805/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_load.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax060805CycleLoad : public InclinometerLoad {
  protected:
    void SetUp() override {
        factory.range = ax060805::AngleConfiguration::right_angle;
        InclinometerLoad::SetUp();
        stay_in_state();
        watch_bus();
        map_rpdo(2, 0x4000037F, {0x25000210});
        for (int number = 1; number <= 4; ++number) {
            map_tpdo(number, 0x400000FFU + (static_cast<std::uint32_t>(number) * 0x100U));
        }
        for (int function = 1; function <= 10; ++function) {
            operate(function, 20);  // shift right
            for (std::uint8_t input = 1; input <= 2; ++input) {
                connect(function, input, 8);          // the latency
                write(at(function, 3), input, 2, 1);  // bitwise not
            }
        }
        angle_digits(100);
    }
    /// Sets pitch and roll to the same angle in degrees, as tilt angles: at most 45 degrees from 0 or 180.
    void tilt(double degrees) {
        const double angle = degrees * 3.14159265358979323846 / 180.0;
        const double across = std::sqrt(std::cos(2.0 * angle));
        feel(std::sin(angle), -std::sin(angle), std::cos(angle) > 0.0 ? -across : across);
    }
    /// Fills the windows of the three filters: 63 samples at 15 degrees, then 64 turns of three samples each. The
    /// next sample exceeds 64 turns.
    void wind_filters() {
        tilt(15.0);
        pass(5);
        for (std::uint8_t angle = 1; angle <= 3; ++angle) {
            write(0x2050, angle, 1, 1);    // 2050h (angular filter type): moving average
            write(0x2051, angle, 255, 2);  // 2051h (angular filter constant): 64 runs of 4 samples
        }
        write(0x2052, 0, 5, 2);  // 2052h (angular filter rate): each sample; the filters restart with one
        pass(62 * 5);
        for (int turn = 0; turn < 64; ++turn) {
            for (const double degrees : {15.0, 165.0, 325.0}) {
                tilt(degrees);
                pass(5);
            }
        }
        write(0x2002, 0, 1, 1);  // 2002h (sensor input filter enabled)
    }
    /// Lets each error of the bus, and some of the device, begin and end while the device can send nothing.
    void disturb() {
        send_alone("37F#00");
        disturb_bus();
        inputs.accelerometer_fault = true;
        suffer(false, 25.0F);
        suffer(true, 25.0F);
        send_alone("37F#0000");
        send_alone("37F#00");
        hear();
        pass(200);
        send("67F#210B300104000000");  // begins a download in segments, which gets no segment
        pass(200);
        hear();
        pass(period_ms);
        hear();
    }
};

}  // namespace

// Overrun and the length of RPDO2 have ended and begun again, heartbeat, guarding and RPDO1 have begun and ended: two
// messages each wait, and one each of temperature and accelerometer. The sample adds one to each of these, and the
// timers one each for heartbeat, guarding and RPDO1.
TEST_F(Ax060805CycleLoad, SampleThatEndsAFaultWhenAllTimersEndReportsWhatHappenedInADisturbance) {
    verifies<req::INC_AVG_001, req::INC_AVG_015, req::INC_BIN_001, req::CO_NMT_007, req::CO_EMCY_006,
             req::CO_SDO_014>();
    suffer(true, 200.0F);
    wind_filters();
    send_alone("000#0100");
    disturb();
    pass(period_ms - 1);
    inputs.accelerometer_fault = false;
    inputs.sensor_temperature = 200.0F;
    tilt(15.0);
    free_bus(10);
    const Frames frames = pass(1);
    EXPECT_EQ(emergencies(frames), 5U * 2U + 2U * 2U + 3U);
    EXPECT_EQ(frames.size(), 17U + 10U + 4U + 1U) << "four TPDOs and the abort of the download";
    EXPECT_EQ(pitch(), 1500) << "the filters restart";
    EXPECT_EQ(output(1), 0);
}

}  // namespace canproof::test
