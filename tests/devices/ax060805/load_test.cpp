// SPDX-License-Identifier: Apache-2.0
// Gives an AX060805 the most work in one call: three full windows of the moving average, all binary functions, and all
// timers that end at the time of a sample. When these tests run on the microcontroller, src/target/run_suites measures
// the longest frame and cycle.
#include "generated/ax060805/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_functions.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax060805Load : public InclinometerFunctions {
  protected:
    static constexpr std::uint32_t period_ms = 400;  ///< of all timers: 80 samples, more than a window has

    void SetUp() override {
        InclinometerFunctions::SetUp();
        for (std::uint8_t angle = 1; angle <= 3; ++angle) {
            write(0x2050, angle, 1, 1);  // 2050h (Angular Filter Type): moving average
            // 2051h (Angular Filter Constant): 57 samples; with 64, a bus full of the frame below would take more than
            // half of the core (src/target/run_suites)
            write(0x2051, angle, 57, 2);
        }
        write(0x2052, 0, 5, 2);  // 2052h (Angular Filter Rate): 5 ms
        for (int function = 1; function <= 10; ++function) {
            operate(function, 1);
            connect(function, 1, 1);
            connect(function, 2, 2);
        }
        for (std::uint8_t cause = 1; cause <= static_cast<std::uint8_t>(read(0x1029)); ++cause) {
            write(0x1029, cause, 1, 1);  // 1029h (error behaviour): no change of the NMT state
        }
        write(0x1017, 0, period_ms, 2);
        write(0x1016, 1, 0x000B0000U + period_ms, 4);  // 1016h:1 (consumer heartbeat time): node 11
        for (std::uint16_t number = 0; number < 4; ++number) {
            const std::uint32_t valid = 0x400001FFU + (number * 0x100U);
            write(static_cast<std::uint16_t>(0x1800 + number), 1, 0x80000000U | valid, 4);
            write(static_cast<std::uint16_t>(0x1800 + number), 5, period_ms, 2);
            write(static_cast<std::uint16_t>(0x1800 + number), 1, valid, 4);
        }
        pass(period_ms);
        send("000#0100");
        send("70B#05");
        turn(20.0, 10.0);
        pass(period_ms - 1);
        inputs.sensor_temperature = 200.0F;
        set_inputs();
    }
    /// Returns the number of emergency messages.
    static int emergencies(const Frames& frames) {
        int count = 0;
        for (const std::string& frame : frames) {
            count += frame.find("0FF#") != std::string::npos ? 1 : 0;
        }
        return count;
    }
};

}  // namespace

TEST_F(Ax060805Load, SampleWithFullWindowsWhenAllTimersEndReportsTheLostHeartbeat) {
    verifies<req::INC_AVG_001, req::INC_BIN_001, req::CO_NMT_007>();
    const Frames frames = pass(1);
    EXPECT_EQ(emergencies(frames), 2) << "temperature and lost heartbeat";
    EXPECT_EQ(frames.back(), "1:77F#05");
}

TEST_F(Ax060805Load, FrameThatComesWithASampleWhenAllTimersEndIsServedAfterIt) {
    verifies<req::INC_AVG_001, req::CO_NMT_007>();
    now = now + milliseconds(1);
    const Frames frames = send("67F#4000300100000000");
    EXPECT_EQ(emergencies(frames), 2) << "temperature and lost heartbeat";
}

}  // namespace canproof::test
