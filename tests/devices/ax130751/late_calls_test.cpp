// SPDX-License-Identifier: Apache-2.0
// Tests an AX130751 that is called late. For each missed cycle and deadline the device must use the values that applied
// when it was due, also when a frame or new inputs arrive with the late call (manual, 1.2, 1.3, 1.8).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751LateCalls : public Ax130751Blocks {
  protected:
    void SetUp() override {
        Ax130751Blocks::SetUp();
        set16(0x1800, 5, 0);  // 1800h:5 event timer of TPDO1: off
    }
    /// Sets up math block 2 to add 2500h:2 (EC Extra Received Process Value), in percent, to its own output in each
    /// cycle. 4030h:2 (Math Output Process Value) is in hundredths of a percent.
    void make_counter() {
        extra_as_percent(2);
        set8(0x4201, 1, 2);
        set8(0x4200, 1, math_source);
        set8(0x4201, 2, 5);
        set8(0x4200, 2, canopen);
        set8(0x4203, 1, 2);
        set16(0x4222, 1, 10000);
        set8(0x4203, 2, 0);
        set16(0x4222, 2, 100);
        set8(0x4000, 2, 1);
        set32(0x1401, 1, 0x4000037F);  // RPDO2, which maps 2500h:1 to 2500h:3, becomes valid
        start();
        pass(10);
    }
    int counted() { return static_cast<int>(device->objects().read(0x4030, 2)); }
    /// Lets time pass without a call of the device.
    void wait(std::uint64_t ms) { now = now + milliseconds(ms); }
};

}  // namespace

TEST_F(Ax130751LateCalls, ReceivedFrameTakesEffectInTheNextCycleNotInMissedOnes) {
    verifies<req::AOR_OUT_027, req::AOR_OUT_001>();
    make_counter();
    send("37F#000001000000");  // math block 2 now adds 1 % per cycle
    wait(5);
    send("37F#000000000000");
    EXPECT_EQ(counted(), 500) << "five cycles with 1 %, run when the frame came";
    pass(10);
    EXPECT_EQ(counted(), 500);
    wait(20);
    send("37F#000002000000");
    EXPECT_EQ(counted(), 500) << "no cycle of the past sees it";
    pass(3);
    EXPECT_EQ(counted(), 1100);
}

TEST_F(Ax130751LateCalls, NewInputsTakeEffectInTheNextCycleNotInMissedOnes) {
    verifies<req::AOR_OUT_027, req::AOR_DIAG_002, req::AOR_DIAG_007, req::AOR_DIAG_012>();
    inputs.supply = 7.5F;
    EXPECT_EQ(set_inputs(), Frames{});
    wait(5);
    inputs.supply = 24.0F;
    EXPECT_EQ(set_inputs(), (Frames{"0FF#0031010000000000"})) << "the cycles on the way saw 7.5 V";
    EXPECT_FLOAT_EQ(get_real(0x5020), 7.5F) << "the next cycle measures";
    EXPECT_EQ(pass(1), (Frames{"1:0FF#0000000000000000"}));
    inputs.cpu_temperature = 90.0F;
    wait(500);
    EXPECT_EQ(set_inputs(), Frames{}) << "it was cold all the time";
    EXPECT_EQ(pass(1), (Frames{"1:0FF#0042010000000000"}));
}

TEST_F(Ax130751LateCalls, RpdoThatComesAfterItsEventTimeIsReportedAsTimedOut) {
    verifies<req::AOR_OUT_027, req::AOR_SRC_004>();
    set16(0x1400, 5, 50);
    start();
    send("27F#E803000000");
    wait(49);
    EXPECT_EQ(send("27F#E803000000"), Frames{});
    wait(50);
    EXPECT_EQ(send("27F#E803000000"), (Frames{"0FF#0081010000000000", "0FF#0000000000000000"}));
}

TEST_F(Ax130751LateCalls, RpdoTimeOutAffectsTheOutputInTheNextCycle) {
    verifies<req::AOR_OUT_027, req::AOR_SRC_004, req::AOR_OUT_011>();
    no_ramps(1);
    set16(0x7341, 1, 3000);
    set16(0x1400, 5, 50);
    start();
    send("27F#E803000000");  // commands 1 V
    wait(50);
    device->advance(now);
    EXPECT_FLOAT_EQ(volts(1), 1.0F) << "the cycle of this millisecond came before the time-out";
    EXPECT_LE(device->next_deadline(), now + milliseconds(1));
    wait(1);
    device->advance(now);
    EXPECT_FLOAT_EQ(volts(1), 3.0F);
    wait(3);
    send("27F#E803000000");
    EXPECT_FLOAT_EQ(volts(1), 3.0F);
    EXPECT_LE(device->next_deadline(), now + milliseconds(1));
    wait(1);
    device->advance(now);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
}

TEST_F(Ax130751LateCalls, OutputReactsToAnRpdoTimeOutThatALateCallOfAdvanceDetects) {
    verifies<req::AOR_OUT_027, req::AOR_SRC_004, req::AOR_OUT_011>();
    no_ramps(1);
    set16(0x7341, 1, 3000);
    set16(0x1400, 5, 50);
    start();
    send("27F#E803000000");
    wait(52);  // RPDO1 is late after 50 ms; the cycle at 51 ms, which was missed too, detects this
    device->advance(now);
    EXPECT_FLOAT_EQ(volts(1), 3.0F);
}

TEST_F(Ax130751LateCalls, RpdoTimeOutIsDetectedInTimeWhileAFullQueueRefusesAnEmcy) {
    verifies<req::AOR_OUT_027, req::AOR_SRC_004, req::AOR_OUT_011>();
    no_ramps(1);
    set16(0x7341, 1, 3000);
    set16(0x1400, 5, 50);
    start();
    for (std::size_t i = 0; i < TransmitQueue::capacity; ++i) {
        queue.push(host::parse_frame("001#", "other traffic"));
    }
    device->receive(host::parse_frame("27F#E803000000", "1 V"), now);
    device->receive(host::parse_frame("57F#00", "too short: 8210h"), now);
    for (const int ms : {20, 20, 20, 1}) {
        wait(static_cast<std::uint64_t>(ms));
        device->advance(now);
    }
    EXPECT_FLOAT_EQ(volts(1), 3.0F) << "a cycle after the time-out was seen";
    queue = TransmitQueue{};
    wait(1);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"0FF#1082010000000000", "0FF#0081010000000000"}));
}

TEST_F(Ax130751LateCalls, DeviceAtRestHasNoDeadlineUntilItsInputsChange) {
    verifies<req::AOR_OUT_027>();
    pass(500);
    EXPECT_EQ(device->next_deadline(), never) << "at rest";
    wait(1000);
    inputs.load[0] = 300.0F;
    set_inputs();
    EXPECT_EQ(device->next_deadline(), now + milliseconds(1)) << "new inputs wake it";
    pass(5);
    EXPECT_EQ(device->next_deadline(), never);
}

TEST_F(Ax130751LateCalls, CyclesOfOneMillisecondBeginAtTheReset) {
    verifies<req::AOR_OUT_001, req::AOR_OUT_027>();
    pass(100);
    now = now + Duration{400};
    set16(0x7300, 1, 1000);  // requests a cycle, which runs at the next whole millisecond
    EXPECT_EQ(device->next_deadline(), now + Duration{600});
    send("000#817F");
    EXPECT_EQ(device->next_deadline(), now + milliseconds(1));
    pass(20);
    now = now + Duration{100};
    set16(0x7300, 1, 1000);
    EXPECT_EQ(device->next_deadline(), now + Duration{900});
}

TEST_F(Ax130751LateCalls, DeviceWithIdleBlocksRunsNoCycles) {
    verifies<req::AOR_OUT_001>();
    // 2500h:1 feeds tables 1 and 4, logic block 2 (table 4), math block 1 and output 1.
    extra_as_percent(1);
    for (const int table : {0x3010, 0x3040}) {
        set8(static_cast<std::uint16_t>(table + 1), 0, 4);
        set8(static_cast<std::uint16_t>(table), 0, canopen);
    }
    set8(0x3300, 2, 1);
    for (const int input : {1, 2}) {
        set8(0x4101, input, 2);
        set8(0x4100, input, logic_source);
    }
    set8(0x4000, 1, 1);
    no_ramps(1);
    set8(0x2341, 1, 1);
    set8(0x2340, 1, math_source);
    extra(1, 70);
    pass(20);
    EXPECT_EQ(get16(0x3018, 0), 70);
    EXPECT_EQ(get16(0x4030, 1), 10000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    pass(20);
    EXPECT_EQ(device->next_deadline(), never);
    set8(0x3015, 1, 1);  // table 1 becomes a time profile of 100 ms
    for (int point = 2; point <= 11; ++point) {
        set32(0x3016, point, 10);
    }
    extra(1, 100);
    EXPECT_EQ(device->next_deadline(), now + milliseconds(1)) << "it runs";
    pass(110);
    EXPECT_EQ(device->next_deadline(), never) << "it has ended";
}

TEST_F(Ax130751LateCalls, NoCycleIsDueForAFrameThatComesWithNewInputs) {
    verifies<req::AOR_OUT_027>();
    make_counter();
    for (std::uint64_t i = 0; i < 200; ++i) {
        now.us += 100 * (i % 13);
        inputs.supply = (i % 2) == 0 ? 24.0F : 25.0F;
        set_inputs();
        // the inputs of the same time have run the cycle
        EXPECT_GT(device->next_deadline().us, now.us) << i;
        const int before = counted();
        send("37F#000001000000");
        EXPECT_EQ(counted(), before) << i;
    }
}

}  // namespace canproof::test
