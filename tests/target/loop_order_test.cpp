// SPDX-License-Identifier: Apache-2.0
// The calls of the main loop to its device: their order, their time and what they pass.
#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/settings_watch.hpp"
#include "tests/support/stm32f405/core_model.hpp"
#include "tests/support/stm32f405/small_devices.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using stm32f405::SelfTest;

/// A recording device in its main loop, for which ten passes have passed: it has got its inputs once.
struct RecordedLoop {
    Chips chips;
    Unit unit{chips};
    std::string calls;
    Instant deadline{never};
    CanState can_state{CanState::error_active};
    RecordingDevice device{{}, &calls, &deadline, &can_state};
    SmallLoop<RecordingDevice> small;

    explicit RecordedLoop(bool may_join = true) : small{unit, device, may_join} {
        EXPECT_EQ(take(), "power_on ");
        small.run(10);
        EXPECT_EQ(take(), "inputs ");  // ten passes take 1 ms, in which the loop samples the inputs once
    }
    std::string take() { return std::exchange(calls, {}); }
    void receive(std::initializer_list<std::uint32_t> ids) {
        for (const std::uint32_t id : ids) {
            EXPECT_EQ(chips.can.receive(data_frame(id, 8)), BxcanModel::Taken::kept);
            unit.can.drain();
        }
    }
};

}  // namespace

TEST(DeviceLoop, DeviceGetsTheInputsOfAPassBeforeItsFrames) {
    verifies<req::CO_SELF_018>();
    RecordedLoop bench;
    bench.receive({203, 303});
    bench.small.run(1);
    EXPECT_EQ(bench.take(), "inputs 203 303 ");
    EXPECT_EQ(bench.small.loop.failed(), SelfTest::none);
}

TEST(LoopOrder, DeviceGetsAtMostEightFramesInAPassAndTheOthersInTheNext) {
    verifies<req::CO_WATCHDOG_002>();
    RecordedLoop bench;
    bench.receive({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
    bench.small.run(1);
    EXPECT_EQ(bench.take(), "inputs 1 2 3 4 5 6 7 8 ");
    bench.small.run(1);
    EXPECT_EQ(bench.take(), "inputs 9 10 11 ");
    bench.small.run(1);
    EXPECT_EQ(bench.take(), "");
}

// The inputs are sampled again ten passes later, so only the deadline lets the device compute.
TEST(LoopOrder, DeviceAdvancesInTheFirstPassThatIsNotBeforeItsDeadline) {
    verifies<req::CO_SELF_018>();
    RecordedLoop bench;
    const Instant now = bench.unit.time.now();
    bench.deadline = Instant{now.us + 201};
    bench.small.run(2);
    EXPECT_EQ(bench.take(), "");
    bench.deadline = Instant{now.us + 300};
    bench.small.run(1);
    EXPECT_EQ(bench.take(), "inputs advance ");
}

// CAN_TI0R to CAN_TI2R lie at 180h, 190h and 1A0h (RM0090 32.9.3): a written mailbox may be sent at once.
TEST(LoopOrder, AnswerIsInAMailboxAfterThePassThatTakesTheRequest) {
    verifies<req::CO_CAN_006>();
    Chips chips;
    Unit unit{chips};
    unit.run(5);
    Frame request = data_frame(0x603, 8);
    request.data = {0x40, 0x00, 0x10, 0x00};
    ASSERT_EQ(chips.can.receive(request), BxcanModel::Taken::kept);
    EXPECT_EQ(unit.run(1).size(), 1U);
}

TEST(LoopOrder, NothingReachesAMailboxInThePassInWhichASelfTestFails) {
    verifies<req::CO_SELF_008, req::CO_SELF_017, req::CO_SELF_019>();
    for (const bool is_queue : {true, false}) {
        Chips chips;
        Unit unit{chips};
        unit.run(19);  // the next pass, 2 ms after the power-on, samples the inputs
        AccessLog log;
        if (is_queue) {
            ASSERT_TRUE(unit.queue.push(data_frame(0x183, 0)));  // no frame of the device
        } else {
            unit.board.on_read = [&unit] {  // before the device computes, which answers the request
                MutableBytes bytes = pieces_of(unit.device.settings())[0];
                bytes.set(1, static_cast<std::uint8_t>(bytes[1] ^ 0x40U));
            };
            Frame request = data_frame(0x603, 8);
            request.data = {0x40, 0x00, 0x10, 0x00};
            ASSERT_EQ(chips.can.receive(request), BxcanModel::Taken::kept);
        }
        unit.run(1);
        EXPECT_EQ(unit.loop.failed(), SelfTest::state) << is_queue;
        const auto base = reinterpret_cast<std::uintptr_t>(&chips.can.registers());
        for (const Write& one : log.take_writes()) {
            EXPECT_FALSE(one.address >= base + 0x180 && one.address < base + 0x1B0) << one;
        }
    }
}

TEST(LoopOrder, DeviceWithACorruptedStateDoesNotCompute) {
    verifies<req::CO_SELF_011>();
    RecordedLoop bench;
    ++bench.device.state;
    bench.receive({1});
    bench.small.run(1);
    EXPECT_EQ(bench.small.loop.failed(), SelfTest::state);
    EXPECT_EQ(bench.take(), "");
}

TEST(LoopOrder, DeviceIsNotPoweredOnAfterAFailedTestOfTheCore) {
    verifies<req::CO_SELF_010>();
    Chips chips;
    Unit unit{chips};
    std::string calls;
    RecordingDevice device{{}, &calls};
    core_model().registers_hold = false;
    SmallLoop<RecordingDevice> small{unit, device};
    core_model() = CoreModel{};
    EXPECT_EQ(small.loop.failed(), SelfTest::core);
    small.run(20);
    EXPECT_EQ(calls, "");
}

TEST(LoopOrder, InputsAreNotReadAfterAFailedSelfTest) {
    verifies<req::CO_SELF_008>();
    Chips chips;
    Unit unit{chips};
    unit.run(5);
    chips.guard.at(7) = 0;
    unit.run(1);
    ASSERT_EQ(unit.loop.failed(), SelfTest::stack);
    bool reads = false;
    unit.board.on_read = [&reads] { reads = true; };
    unit.run(20);
    EXPECT_FALSE(reads);
}

TEST(LoopOrder, SampleOfTheInputsHasTheStateOfTheControllerInItsPass) {
    verifies<req::CO_CAN_008>();
    RecordedLoop bench;
    bench.small.run(9);
    EXPECT_EQ(bench.can_state, CanState::error_active);
    bench.chips.can.count_errors(256, 0);
    bench.small.run(1);  // the pass that samples the inputs
    EXPECT_EQ(bench.can_state, CanState::bus_off);
}

TEST(LoopOrder, DeviceThatMayNotJoinTheBusGetsTheStateBusOff) {
    verifies<req::CO_CLOCK_005>();
    const RecordedLoop bench{false};
    EXPECT_EQ(bench.can_state, CanState::bus_off);
}

TEST(LoopOrder, LostFrameIsReportedToTheDeviceForExactlyOneSecond) {
    verifies<req::CO_CAN_005, req::CO_EMCY_016>();
    Chips chips;
    Unit unit{chips};
    unit.run(5);
    for (int i = 0; i < 4; ++i) {
        chips.can.receive(data_frame(0x101, 0));
    }
    const auto passes_to_a_frame = [&unit] {
        int passes = 1;
        while (unit.run(1).empty() && passes < 20000) {
            ++passes;
        }
        return passes;
    };
    passes_to_a_frame();                    // CAN overrun, at the next sample of the inputs
    EXPECT_EQ(passes_to_a_frame(), 10000);  // no error any more, 1 s later: 10,000 passes of 100 us
}

}  // namespace canproof::test
