// SPDX-License-Identifier: Apache-2.0
// What the main loop of a device gives to its device, in which order and at which time.
#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
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
    RecordingDevice device{{}, &calls, &deadline};
    SmallLoop<RecordingDevice> small{unit, device};

    RecordedLoop() {
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

TEST(LoopOrder, DeviceGetsTheInputsOfAPassBeforeItsFrames) {
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
