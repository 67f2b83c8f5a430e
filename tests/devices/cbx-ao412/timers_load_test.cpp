// SPDX-License-Identifier: Apache-2.0
// Gives a CAN-CBX-AO412 the most work in one call: every message that it can have waits, and all its timers end at
// once. The device runs for 142 years then, because the divisions of its LEDs take longest with such a time. When these
// tests run on the microcontroller, src/target/run_suites measures the longest frame and cycle.
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/disturbed_bus.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr Instant after_142_years{std::uint64_t{1} << 52U};

class CbxTimersLoad : public DisturbedBus<CbxTest> {
  protected:
    void SetUp() override {
        now = after_142_years;
        CbxTest::SetUp();
        write("603#2B17100064000000");  // 1017h (producer heartbeat time): 100 ms
        write("603#2316100164003100");  // 1016h:1 (consumer heartbeat time): node 31h, 100 ms
        write("603#2305100080000040");  // 1005h (COB-ID SYNC): the device sends SYNC messages,
        write("603#23061000A0860100");  // 1006h (communication cycle period): each 100,000 us
        for (const char* const output : {"01", "02", "03", "04"}) {
            write(std::string{"603#234464"} + output + "00000060");  // 6444h: 6000h, 3072 steps
            write(std::string{"603#2B0424"} + output + "FF7F0000");  // 2404h (calibration offset): the largest
        }
        for (const char* const at : {"01", "02"}) {  // RPDO2 and RPDO3 are synchronous and carry all four outputs
            const std::string cob_id = std::string{"03"} + (at[1] == '1' ? "03" : "04");
            write(std::string{"603#23"} + at + "1401" + cob_id + "0080");
            write(std::string{"603#2F"} + at + "140200000000");
            write(std::string{"603#2F"} + at + "160000000000");
            for (const char* const line : {"01", "02", "03", "04"}) {
                write(std::string{"603#23"} + at + "16" + line + "10" + line + "1164");
            }
            write(std::string{"603#2F"} + at + "160004000000");
            write(std::string{"603#23"} + at + "1401" + cob_id + "0000");
        }
        send("000#0103");
        send("731#05");
    }
    void fail(bool fails) {
        fail_controller(fails);
        inputs.internal_fault = fails;
        inputs.hardware_fault = fails;
        set_inputs();
    }
    void set_can_state(std::uint8_t state) {
        inputs.can_state = state;
        set_inputs();
    }
    /// Lets all errors begin and end twice while the device can send nothing, and the heartbeat be lost. The node is
    /// stopped then, so that the messages wait beyond a bus-off.
    void collect_messages() {
        disturb_bus();
        for (const bool fails : {true, false, true, false}) {
            fail(fails);
            send_alone(fails ? "080#01" : "080#");
        }
        send("000#0203");
        set_can_state(3);
        set_can_state(0);
        disturb_bus();
        pass(100);
        EXPECT_EQ(device->state(), NmtState::stopped);
    }
};

}  // namespace

// 13 messages: begin and end of overrun, error passive, lost heartbeat, length of a SYNC, software and hardware, and a
// bus-off that has ended.
TEST_F(CbxTimersLoad, StartSendsTheMostMessagesThatCanWait) {
    verifies<req::CO_EMCY_004, req::CO_EMCY_006>();
    collect_messages();
    send_alone("731#05");
    free_bus(19);
    const Frames frames = send_alone("000#0103");
    EXPECT_EQ(frames.size(), 19U + 13U);
    EXPECT_EQ(frames.front(), "083#2081000A00000000") << "error passive, with ten listed errors";
    EXPECT_EQ(device->state(), NmtState::operational);
}

// The same messages, the second lost heartbeat, a heartbeat, a SYNC and the end of an SDO transfer that takes longer
// than 1000 ms.
TEST_F(CbxTimersLoad, OutputsTakeTheValuesOfRpdosAndThenTheirErrorValuesWhenAllTimersEnd) {
    verifies<req::AO4_AOUT_005, req::AO4_AOUT_006, req::CO_SDO_044>();
    collect_messages();
    send_alone("000#0103");
    pass(100);
    send_alone("603#4008100000000000");  // begins to read the 13 bytes of 1008h (manufacturer device name)
    pass(900);
    send_alone("731#05");
    send_alone("303#0020002000200020");
    send_alone("403#0040004000400040");
    pass(99);
    free_bus(15);
    const float before = volts(1);
    const Frames frames = pass(1);
    EXPECT_EQ(frames.size(), 15U + 13U + 4U);
    EXPECT_EQ(frames.front(), "1:080#");
    EXPECT_EQ(frames.at(15), "1:583#8008100000000405") << "time-out of the SDO transfer";
    EXPECT_EQ(frames.at(16), "1:703#05") << "heartbeat";
    for (const int output : {1, 2, 3, 4}) {
        EXPECT_EQ(volts(output), before) << output << ": the error value, as after the first lost heartbeat";
    }
    EXPECT_EQ(device->state(), NmtState::pre_operational) << "1029h:1 (error behaviour)";
}

}  // namespace canproof::test
