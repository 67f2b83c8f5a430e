// SPDX-License-Identifier: Apache-2.0
// Tests the 1 ms cycle in which the device computes its universal outputs: start, chains of blocks, late calls, cycles
// that are skipped (AX130751 manual, 1.2, 1.3).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/output_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST_F(Ax130751Output, OutputsAreOffAfterPowerOnAndReset) {
    verifies<req::AOR_OUT_026>();
    set8(0x2242, 1, 2);  // inverse: the relay is ON
    set16(0x7321, 1, 2000);
    set16(0x7320, 1, -5000);
    no_ramps(1);
    store();
    pass(10);
    EXPECT_FLOAT_EQ(volts(1), 3.5F);  // the command 0 is half way between -5000 and 5000: 2 V + half of (5 V - 2 V)
    EXPECT_TRUE(relay_on());
    const auto all_off = [this] { return volts(1) == 0.0F && !relay_on() && device->outputs().relay_no; };
    send("000#817F");
    EXPECT_TRUE(all_off()) << "reset";
    pass(1);
    EXPECT_TRUE(all_off()) << "pre-operational";
    start();
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 3.5F);
    EXPECT_TRUE(relay_on());
    power_on();
    EXPECT_TRUE(all_off()) << "power-on";
    EXPECT_FLOAT_EQ(get_real(0x5020), 24.0F) << "measured at once";
    start();
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 3.5F);
}

TEST_F(Ax130751Output, ResetPutsBothOutputsOffWithoutARamp) {
    verifies<req::AOR_OUT_026>();
    command(1, 5000);
    command(2, 5000);
    pass(1000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    EXPECT_FLOAT_EQ(volts(2), 5.0F);
    send("000#817F");
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    EXPECT_FLOAT_EQ(volts(2), 0.0F);
}

TEST_F(Ax130751Output, ChainOfBlocksSettlesInOneCycleAndALoopOfBlocksStepsEachCycle) {
    verifies<req::AOR_OUT_001, req::AOR_OUT_030>();
    // Extra received value 1 (2500h:1) passes through table 1, logic block 1 and math block 1 to output 1; each is
    // scaled from 0 to 100.
    extra_as_percent(1);
    extra_as_percent(2);
    set8(0x3010, 0, canopen);
    set8(0x3011, 0, 4);
    set8(0x3300, 1, 1);
    set8(0x4000, 1, 1);
    set8(0x4100, 1, logic_source);
    set8(0x4101, 1, 1);
    set8(0x4100, 2, canopen);
    set8(0x4101, 2, 5);
    no_ramps(1);
    set8(0x2340, 1, math_source);
    set8(0x6302, 1, 2);
    set16(0x7322, 1, 10000);
    pass(1);
    extra(1, 50);  // extra() sets 2500h and lets one cycle run
    EXPECT_FLOAT_EQ(volts(1), 2.5F);
    // Math block 2 adds 1 % to its own output in each cycle.
    set16(0x2500, 2, 1);
    for (const auto& [sub, source, number] : {std::tuple{1, math_source, 2}, std::tuple{2, canopen, 5}}) {
        set8(0x4200, sub, source);
        set8(0x4201, sub, number);
    }
    set16(0x4222, 2, 10000);
    set8(0x4000, 2, 1);
    pass(1);
    EXPECT_EQ(get16(0x4030, 2), 100);
    pass(1);
    EXPECT_EQ(get16(0x4030, 2), 200);
    pass(10);
    EXPECT_EQ(get16(0x4030, 2), 1200);
    pass(200);
    EXPECT_EQ(get16(0x4030, 2), 10000) << "bounded by its scaling";
}

TEST_F(Ax130751Output, ChainOfBlocksAgainstTheEvaluationOrderTakesOneCyclePerBlock) {
    verifies<req::AOR_OUT_030, req::AOR_OUT_002>();
    // Extra received value 1 (2500h:1) passes from table 10 to table 9 and so on to table 1, which takes ten cycles.
    extra_as_percent(1);
    for (int table = 1; table <= 9; ++table) {
        set8(static_cast<std::uint16_t>(0x3000 + (0x10 * table)), 0, lookup_source);
        set8(static_cast<std::uint16_t>(0x3001 + (0x10 * table)), 0, table + 1);
    }
    set8(0x3100, 0, canopen);
    set8(0x3101, 0, 4);
    pass(100);
    set16(0x2500, 1, 70);
    pass(1);
    EXPECT_EQ(get16(0x3108, 0), 70);
    EXPECT_EQ(get16(0x3098, 0), 0);
    now = now + milliseconds(8);
    device->advance(now);  // nothing has requested a cycle since the last call
    EXPECT_EQ(get16(0x3028, 0), 70);
    EXPECT_EQ(get16(0x3018, 0), 0);
    pass(1);
    EXPECT_EQ(get16(0x3018, 0), 70);
}

TEST_F(Ax130751Output, OutputFollowsABlinkingOutputOneCycleLater) {
    verifies<req::AOR_OUT_030, req::AOR_DO_010>();
    make(10);
    set8(0x2340, 1, 7);  // the control of output 1 is the drive state of output 2: 0 V or 5 V
    set8(0x2341, 1, 2);
    set8(0x6302, 1, 0);
    set16(0x7322, 1, 1);
    set16(0x6310, 2, 1020);
    set8(0x2241, 2, 3);
    set16(0x2223, 2, 40);
    pass(10);
    set8(0x6220, 2, 1);
    pass(1);
    EXPECT_TRUE(is_on(2));
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    for (int half = 0; half < 6; ++half) {
        pass(1);
        EXPECT_EQ(is_on(2), half % 2 == 0) << half;
        EXPECT_FLOAT_EQ(volts(1), half % 2 == 0 ? 5.0F : 0.0F) << half;
        pass(39);
    }
}

TEST_F(Ax130751Output, OutputsThatFollowEachOtherInALoopChangeOncePerCycle) {
    verifies<req::AOR_OUT_030>();
    // Output 2 follows output 1. Output 1 follows output 2 plus 0.1 V or 0.1 mA, so both outputs rise in each cycle.
    const auto close_loop = [this](int type, int source, int full) {
        for (const int output : {1, 2}) {
            set16(0x6310, output, type);
            no_ramps(output);
            set8(0x2341, output, 3 - output);
            set16(0x7322, output, full);
            set16(0x7323, output, full);
        }
        set16(0x7322, 1, full - 100);
        set16(0x7321, 1, 100);
        set8(0x2340, 2, source);
        set8(0x2340, 1, not_used);  // output 1 is OFF
        pass(10);
        set8(0x2340, 1, source);
    };
    close_loop(10, 7, 5000);
    pass(20);
    EXPECT_FLOAT_EQ(volts(1), 2.0F);
    pass(10);
    EXPECT_FLOAT_EQ(volts(2), 3.0F);
    // 14 V drive only 0.014 mA through 1 MOhm. So the feedback of the outputs is constant, while their targets grow.
    inputs.load = {1.0e6F, 1.0e6F};
    set_inputs();
    close_loop(20, 6, 20000);
    pass(20);
    EXPECT_EQ(get16(0x2370, 1), 14);
    EXPECT_EQ(get16(0x7330, 1), 2000);
    EXPECT_EQ(get16(0x7330, 2), 2000);
}

TEST_F(Ax130751Output, TpdoDeadlinesDoNotShiftTheOneMillisecondCycle) {
    verifies<req::AOR_OUT_001, req::AOR_OUT_027>();
    // Math block 2 adds 1 % to its own output in every cycle; TPDO1 is due every 7 ms, half a millisecond after a
    // cycle.
    send("000#807F");
    extra_as_percent(2);
    for (const auto& [sub, source, number] : {std::tuple{1, math_source, 2}, std::tuple{2, canopen, 5}}) {
        set8(0x4200, sub, source);
        set8(0x4201, sub, number);
    }
    set16(0x4222, 2, 10000);
    set8(0x4000, 2, 1);
    set16(0x1800, 5, 7);
    pass(10);
    now = now + Duration{500};
    start();
    set16(0x2500, 2, 1);
    EXPECT_EQ(pass(10).size(), 1U);
    EXPECT_EQ(device->objects().read(0x4030, 2), 1000U);
    EXPECT_EQ(pass(10).size(), 1U);
    EXPECT_EQ(device->objects().read(0x4030, 2), 2000U);
}

TEST_F(Ax130751Output, LateCallOfAdvancePerformsAllMissedCycles) {
    verifies<req::AOR_OUT_027>();
    send("000#807F");
    pass(1);
    start();                 // from here on every 100 ms TPDO1 carries 2370h:1 and 2370h:2 (feedback)
    send("27F#8813000000");  // 5 V: the ramp, which takes 1 s, begins in the cycle 1 ms later
    now = now + milliseconds(300);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"1FF#EF010000", "1FF#E3030000", "1FF#D7050000"}));  // 495, 995 and 1495 mV
    pass(1000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    now = now + milliseconds(300);  // from here on, no output changes
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"1FF#88130000", "1FF#88130000", "1FF#88130000"}));
}

TEST_F(Ax130751Output, FullTransmitQueueDelaysNoOutput) {
    verifies<req::AOR_OUT_027>();
    set16(0x1800, 5, 1);
    start();
    send("27F#8813000000");  // 5 V: the ramp of a second begins with the cycle 1 ms later
    now = now + milliseconds(501);
    device->advance(now);  // 501 TPDOs are due, but the full queue accepts only some
    EXPECT_FLOAT_EQ(volts(1), 2.5F);
    EXPECT_EQ(sent().size(), TransmitQueue::capacity);
}

TEST_F(Ax130751Output, SlowRampKeepsRunningWhileTheFeedbackValueIsConstant) {
    verifies<req::AOR_OUT_012>();
    make(10);
    set16(0x7323, 1, 100);  // the ramp takes 10 s for 0.1 V: 7330h rises by one count every 100 ms
    set16(0x2330, 1, 10000);
    set16(0x7300, 1, 5000);
    pass(1);
    pass(40);
    EXPECT_FLOAT_EQ(volts(1), 0.0004F);  // less than half of the last digit, which is 1 mV
    EXPECT_EQ(get16(0x2370, 1), 0);
    pass(360);
    EXPECT_FLOAT_EQ(volts(1), 0.004F);
    EXPECT_EQ(get16(0x2370, 1), 4);
}

TEST_F(Ax130751Output, DeviceWithIdleOutputsRunsNoCycles) {
    verifies<req::AOR_OUT_001>();
    set16(0x1800, 5, 0);  // 1800h:5 event timer of TPDO1: off
    pass(5000);
    EXPECT_EQ(device->next_deadline(), never) << "at rest";
    command(1, 5000);
    EXPECT_LE(device->next_deadline(), now + milliseconds(1)) << "a ramp is under way";
    pass(5000);
    EXPECT_EQ(device->next_deadline(), never);
    set16(0x6310, 2, 1020);
    set8(0x6220, 2, 1);
    pass(10);
    EXPECT_EQ(device->next_deadline(), never) << "nor has a digital output anything to do";
}

}  // namespace canproof::test
