// SPDX-License-Identifier: Apache-2.0
// Gives an AX188001 frames and commands when most emergency messages wait: each error has begun and ended while the
// node could not send. When these tests run on the microcontroller, src/target/run_suites measures the longest frame
// and command.
#include <limits>

#include "generated/ax188001/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/disturbed_bus.hpp"
#include "tests/support/unreadable_set.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax188001WaitingLoad : public DisturbedBus<UnreadableSet<TcsBench, 1024>> {
  protected:
    /// A device that reports its faults at once, watches four producers of heartbeats, and is guarded.
    void SetUp() override {
        power_cycle();
        for (const int sub : {1, 2}) {
            write(0x4030, sub, 2, 0);    // 4030h (TC Error React Delay)
            write(0x5051, sub, 2, 0);    // 5051h (FD Error Response Delay)
            write(0x6110, sub, 2, 0x2);  // 6110h (TC Sensor Type): K
        }
        for (int cause = 1; cause <= 3; ++cause) {
            write(0x1029, cause, 1, 1);  // 1029h (error behaviour): no change of the NMT state
        }
        for (int slot = 1; slot <= 4; ++slot) {
            write(0x1016, slot, 4, 0x000A0000U + (static_cast<std::uint32_t>(slot) << 16U) + 100U);
        }
        write(0x100C, 0, 2, 50);  // 100Ch (guard time)
        write(0x100D, 0, 1, 2);   // 100Dh (life time factor)
        for (int number = 0; number < 4; ++number) {
            carry_four_values(number, 60000);
        }
        write(0x1400, 5, 2, 100);  // 1400h:5 (event timer of RPDO1)
        EXPECT_EQ(write(0x1400, 1, 4, 0x4000027F), 0U);
        EXPECT_EQ(write(0x1010, 1, 4, save), 0U);
    }
    /// Ends the errors of the bus, or lets them begin 100 ms later.
    void hear_all() {
        for (const char* const frame : {"70B#05", "70C#05", "70D#05", "70E#05", "77F#R", "27F#"}) {
            device->receive(host::parse_frame(frame, "other traffic"), now);
            static_cast<void>(sent());
        }
    }
    /// Lets the readings and the errors of the bus change: at most three faults of each channel and all of the unit.
    void make(bool hot, bool open = false) {
        for (const int channel : {1, 2}) {
            heat(channel, hot ? 260.0 : -269.99, 'K');
            cut(channel, open);
        }
        inputs.supply = hot ? 55.0F : 8.0F;
        inputs.cpu_temperature = hot ? 120.0F : 20.0F;
        set_inputs();
        fail_controller(hot);
        set_inputs();
        hear_all();
        read_once();
    }
    /// Lets each fault begin and end: eleven of the device, four heartbeats, guarding and an overrun.
    void change_all() {
        for (int turn = 0; turn < 6; ++turn) {
            make(turn % 2 == 0);
        }
        make(true, true);
        pass(9 * period_ms);
        make(false);
        make(true);
        make(false);
    }
    /// Lets a channel of type T be too cold, by a voltage below its range, with thresholds below -250 degC.
    void make_too_cold(int channel) {
        write(0x6110, channel, 2, 7);                      // 6110h (TC Sensor Type): T
        write(0x4000, channel, 2, 0xF556);                 // 4000h (TC Low Temperature Warning Threshold): -273.0 degC
        write(0x4010, channel, 2, 0xF5BA);                 // 4010h (TC High Temperature Warning Threshold): -263.0 degC
        EXPECT_EQ(write(0x4020, channel, 2, 0xF61E), 0U);  // 4020h (TC High Temperature Shutdown Threshold): -253.0
        microvolts(channel, -9000.0);
        settle();
        EXPECT_EQ(status(channel), 0x04) << "6150h (TC Status)";
    }
    /// Prepares a reading that changes all eleven faults: open circuit, too cold and over-voltage last, in operational.
    void begin_five() {
        fail_controller(true);
        inputs.supply = 55.0F;
        for (const int channel : {1, 2}) {
            make_too_cold(channel);
            cut(channel);
        }
        settle();
        send("000#0100");
        for (int number = 0; number < 4; ++number) {
            write(0x1800 + number, 5, 2, period_ms);  // the TPDOs are sent with each reading
        }
    }
    /// Sets inputs that end the five faults of begin_five() and begin the six others.
    void make_warm() {
        inputs.tc_open = {};
        inputs.cold_junction += 3.7F;
        heat(1, -230.1, 'T');
        heat(2, -220.3, 'T');
        inputs.supply = 7.3F;
        inputs.cpu_temperature = 121.3F;
        set_inputs();
    }
    /// Sets the inputs that begin the five faults again, and end the others.
    void make_cold_and_open() {
        inputs.supply = 55.0F;
        inputs.cpu_temperature = 20.0F;
        inputs.cold_junction -= 3.7F;
        for (const int channel : {1, 2}) {
            microvolts(channel, -9000.0);
        }
        settle();
        inputs.tc_open = {true, true};
        set_inputs();
        settle();
    }
    /// Lets the heartbeats, the guarding request and the RPDO come 100 ms before the next reading, at which they are
    /// missing.
    void hear_all_before_reading() {
        pass(period_ms - 100);
        hear_all();
    }
};

}  // namespace

TEST_F(Ax188001WaitingLoad, WriteEndsTwoFaultsOfAChannelAndBeginsTwo) {
    verifies<req::TCS_IN_025, req::TCS_LIM_012, req::TCS_LIM_018, req::TCS_ERR_010>();
    write(0x1029, 2, 1, 0);  // 1029h:2 (error behaviour, TC input): to pre-operational
    for (const int channel : {1, 2}) {
        write_real(0x6126, channel, 0.3F);  // 6126h (TC Scaling Factor)
        write_real(0x6127, channel, 1.7F);  // 6127h (TC Scaling Offset)
    }
    inputs.supply = 8.0F;
    inputs.cpu_temperature = 120.0F;
    write(0x2000, 2, 1, 0);  // 2000h:2 (CJ Auto Correct): off
    microvolts(2, 1234.5);
    fail_controller(true);
    hear_all();  // 100 ms later the errors of the bus begin
    make_too_cold(1);
    inputs.cold_junction = std::numeric_limits<float>::quiet_NaN();
    microvolts(1, -6007.0);
    settle();
    EXPECT_EQ(process_value(1), -512) << "without the cold junction, the channel counts as open";
    EXPECT_EQ(listed().size(), 9U);
    send("000#0100");
    free_bus(27);
    const Frames frames = send_alone("67F#2F00200100000000");  // 2000h:1 (CJ Auto Correct): off
    EXPECT_EQ(frames.size(), 27U + 5U) << "four faults and the answer";
    EXPECT_NEAR(field_value(1).real(), -230.0F, 0.1F) << "-6.007 mV of type T, above both limits";
}

TEST_F(Ax188001WaitingLoad, ReadingThatChangesAllFaultsWhenAllTimersEndReportsThem) {
    verifies<req::TCS_LIM_012, req::TCS_LIM_018, req::TCS_ERR_002, req::CO_EMCY_006>();
    begin_five();
    hear_all_before_reading();
    make_warm();
    pass(99);
    free_bus(11);
    const Frames frames = pass(1);
    EXPECT_EQ(frames.size(), 11U + 11U + 6U + 4U) << "eleven faults, six errors of the bus and four TPDOs";
    EXPECT_NEAR(field_value(1).real(), -230.1F, 0.1F);
    EXPECT_NEAR(field_value(2).real(), -220.3F, 0.1F);
}

TEST_F(Ax188001WaitingLoad, ReadingThatChangesAllFaultsSendsWhatHasWaited) {
    verifies<req::TCS_LIM_012, req::TCS_LIM_018, req::CO_EMCY_006, req::CO_EMCY_022>();
    begin_five();
    disturb_bus();
    hear_all_before_reading();
    make_warm();
    fail_controller(false);
    set_inputs();
    pass(100);
    fail_controller(true);
    make_cold_and_open();
    hear_all_before_reading();
    make_warm();
    pass(99);
    free_bus(11);
    const Frames frames = pass(1);
    ASSERT_EQ(frames.size(), TransmitQueue::capacity) << "more messages have waited";
    EXPECT_EQ(frames.front(), "1:0FF#0000010000000000") << "the first error that has ended";
    EXPECT_EQ(frames.at(TransmitQueue::capacity - 11), "1:7FF#") << "all messages pass these frames";
    EXPECT_NEAR(field_value(1).real(), -230.1F, 0.1F);
    EXPECT_NEAR(field_value(2).real(), -220.3F, 0.1F);
}

TEST_F(Ax188001WaitingLoad, ResetCommunicationKeepsTheMessagesOfTheQueue) {
    verifies<req::CO_EMCY_035, req::CO_NMT_006, req::CO_STORE_006>();
    faulty.fail_read(0);
    send("000#827F");
    const std::size_t reads = faulty.reads;
    send("000#0100");
    is_blocked = true;
    change_all();
    EXPECT_EQ(queue.size(), TransmitQueue::capacity);
    faulty.fail_read(reads);
    send("000#827F");
    is_blocked = false;
    const Frames frames = sent();
    ASSERT_EQ(frames.size(), TransmitQueue::capacity);
    EXPECT_EQ(frames.front(), "77F#00");
    EXPECT_EQ(frames.at(1), "0FF#1081010000000000") << "the first lost frame, before all other errors";
}

}  // namespace canproof::test
