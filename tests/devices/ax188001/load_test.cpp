// SPDX-License-Identifier: Apache-2.0
// Gives an AX188001 the most work in one call: a reading that changes most faults, at the time when all its timers end,
// after a disturbance of the bus during which emergency messages have waited. When these tests run on the
// microcontroller, src/target/run_suites measures the longest frame and cycle.
#include "generated/ax188001/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/disturbed_bus.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr std::uint32_t type_k = 2;
constexpr std::uint32_t type_t = 7;

class Ax188001Load : public DisturbedBus<TcsTest> {
  protected:
    void SetUp() override {
        TcsTest::SetUp();
        for (const int sub : {1, 2}) {
            write(0x4030, sub, 2, 0);  // 4030h (TC Error React Delay)
            write(0x5051, sub, 2, 0);  // 5051h (FD Error Response Delay)
            EXPECT_EQ(write(0x6110, sub, 2, type_k), 0U);
        }
        for (int cause = 1; cause <= 3; ++cause) {
            write(0x1029, cause, 1, 1);  // 1029h (error behaviour): no change of the NMT state
        }
        for (int slot = 1; slot <= 4; ++slot) {
            write(0x1016, slot, 4, 0x000A0000U + (static_cast<std::uint32_t>(slot) << 16U) + period_ms);
        }
        write(0x1017, 0, 2, period_ms);  // 1017h (producer heartbeat time)
        for (int number = 0; number < 4; ++number) {
            carry_four_values(number, period_ms);
        }
        send("000#0100");
    }
    /// Both channels above the shutdown threshold, supply and processor above their thresholds.
    void make_hot() {
        heat(1, 260.0, 'K');
        heat(2, 260.0, 'K');
        inputs.supply = 55.0F;
        inputs.cpu_temperature = 120.0F;
        set_inputs();
    }
    /// Both channels at the end of type K, where the search of the temperature takes most steps; the supply is low.
    void make_cold() {
        heat(1, -269.99, 'K');
        heat(2, -269.99, 'K');
        inputs.supply = 8.0F;
        inputs.cpu_temperature = 20.0F;
        set_inputs();
    }
    /// Lets the device receive a heartbeat of each producer. These frames do not count as frames of a full bus, because
    /// a heartbeat that ends an error comes once.
    void send_heartbeats() {
        for (const char* const frame : {"70B#05", "70C#05", "70D#05", "70E#05"}) {
            device->receive(host::parse_frame(frame, "heartbeat"), now);
        }
    }
    /// Lets all faults begin and end while the bus is disturbed, until 1 ms before a reading.
    void disturb() {
        disturb_bus();
        for (int turn = 0; turn < 4; ++turn) {
            send_heartbeats();
            turn % 2 == 0 ? make_hot() : make_cold();
            read_once();
        }
        make_hot();
        read_once();
        send_heartbeats();
        make_cold();
        pass(period_ms - 1);
        free_bus(0);
    }
};

}  // namespace

TEST_F(Ax188001Load, ReadingThatChangesNineFaultsWhenAllTimersEndReportsThemAfterADisturbance) {
    verifies<req::TCS_ERR_002, req::TCS_LIM_001, req::TCS_FD_009, req::CO_EMCY_006>();
    disturb();
    const Frames frames = pass(1);
    ASSERT_EQ(frames.size(), TransmitQueue::capacity) << "more messages wait than the queue holds";
    EXPECT_EQ(frames.front(), "1:0FF#11F0010110000000")
        << "channel 1 above 4010h:1 (TC High Temperature Warning Threshold), during the disturbance";
    EXPECT_EQ(frames.back(), "1:77F#05");
    EXPECT_EQ(process_value(1), process_value(2));
    EXPECT_NEAR(field_value(1).real(), -270.0F, 1.0F) << "the gain is still low";
}

TEST_F(Ax188001Load, FrameThatComesWithAReadingThatChangesNineFaultsIsServedAfterIt) {
    verifies<req::TCS_IN_015, req::TCS_IN_012, req::TCS_ERR_002>();
    disturb();
    now = now + milliseconds(1);
    write(0x6110, 1, 2, type_t);
    EXPECT_EQ(read(0x6110, 1).value, type_t);
}

TEST_F(Ax188001Load, SensorTypeWithWhichTheTemperatureIsTooHighBeginsTwoFaults) {
    verifies<req::TCS_IN_012, req::TCS_LIM_001, req::TCS_ERR_010>();
    EXPECT_EQ(write(0x4010, 1, 2, 2200), 0U);  // 4010h:1 (TC High Temperature Warning Threshold): 220 degC
    EXPECT_EQ(write(0x4020, 1, 2, 2400), 0U);  // 4020h:1 (TC High Temperature Shutdown Threshold): 240 degC
    constexpr std::uint32_t type_j = 1;
    EXPECT_EQ(write(0x6110, 1, 2, type_j), 0U);
    heat(1, 260.0, 'K');
    settle();
    EXPECT_LT(field_value(1).real(), 220.0F) << "10.6 mV of type J";
    free_bus(26);
    const Frames frames = send_alone("67F#2B10610102000000");
    EXPECT_GT(field_value(1).real(), 240.0F);
    EXPECT_EQ(frames.size(), 26U + 3U) << "two faults and the answer";
}

}  // namespace canproof::test
