// SPDX-License-Identifier: Apache-2.0
// Gives an AX060805 the most work of a frame: each error has begun and ended, and its two emergency messages wait. When
// these tests run on the microcontroller, src/target/run_suites measures the longest frame.
#include "generated/ax060805/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_load.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax060805FrameLoad : public InclinometerLoad {
  protected:
    static constexpr std::size_t errors =
        7;  ///< overrun, temperature, accelerometer, heartbeat, guarding, two of RPDOs

    void SetUp() override {
        InclinometerLoad::SetUp();
        stay_in_state();
        watch_bus();
        for (int number = 1; number <= 4; ++number) {
            // A TPDO has priority over the messages, and over the TPDO before it.
            map_tpdo(number, 0x400000A4U - static_cast<std::uint32_t>(number));
        }
        send_alone("000#0100");
        hear();
    }
    /// Lets each error begin and end.
    void begin_and_end_errors() {
        inputs.accelerometer_fault = true;
        suffer(true, 200.0F);
        send_alone("27F#00");
        pass(period_ms);
        inputs.accelerometer_fault = false;
        suffer(false, 25.0F);
        pass(5);
        hear();
    }
};

}  // namespace

TEST_F(Ax060805FrameLoad, StartSendsTheMessagesOfAllErrorsThatBeganAndEndedInADisturbance) {
    verifies<req::CO_EMCY_004, req::CO_EMCY_006, req::CO_PDO_049>();
    disturb_bus();
    begin_and_end_errors();
    send("000#0200");
    pass(1);
    for (const CanState state : {CanState::bus_off, CanState::error_active}) {
        inputs.can_state = static_cast<std::uint8_t>(state);
        set_inputs();
    }
    free_bus(TransmitQueue::capacity - (2 * errors) - 1 - 4);
    const Frames frames = send_alone("000#0100");
    EXPECT_EQ(emergencies(frames), (2 * errors) + 1) << "and one for the end of bus-off";
    EXPECT_EQ(frames.size(), TransmitQueue::capacity) << "with four TPDOs and the frames that waited";
}

// The queue has 32 messages of an overrun that begins and ends 16 times. The change of the bit rate takes them back:
// the last ones of the overrun remain.
TEST_F(Ax060805FrameLoad, ChangeOfTheBitRateTakesBackAQueueOfEmergencyMessages) {
    verifies<req::CO_LSS_013, req::CO_EMCY_020, req::CO_EMCY_035>();
    is_blocked = true;
    for (std::size_t i = 0; i < TransmitQueue::capacity; ++i) {
        suffer((i % 2) == 0, 25.0F);
    }
    EXPECT_EQ(queue.size(), TransmitQueue::capacity);
    begin_and_end_errors();
    send("000#8000");
    send("7E5#0401");
    send("7E5#130002");
    send_alone("7E5#150A00");
    EXPECT_TRUE(queue.empty());
    is_blocked = false;
    EXPECT_EQ(emergencies(pass(10)), 0U);
    EXPECT_EQ(device->bit_rate(), 500000U);
    EXPECT_EQ(emergencies(pass(10)), 2 * errors);
}

}  // namespace canproof::test
