// SPDX-License-Identifier: Apache-2.0
// The image of the CAN-CBX-AO412 as it is flashed, on models of the chip.
#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"

#include "generated/canopen/requirements.hpp"
#include "tests/support/stm32f405/flashed_runs.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST(FlashedCbxAo412, StartsOnlyWithASoundImageAndTheClockOfItsPll) {
    verifies<req::CO_IMAGE_001, req::CO_CLOCK_004>();
    runs_that_do_not_start(flashed_cbx_ao412());
}

TEST(FlashedCbxAo412, IsOnTheBusOnlyWithItsCrystal) {
    verifies<req::CO_CLOCK_001, req::CO_CLOCK_005, req::CO_SELF_008>();
    runs_with_and_without_crystal(flashed_cbx_ao412());
}

TEST(FlashedCbxAo412, TakesFramesOfOneAndOfSeveralPasses) {
    verifies<req::CO_CAN_004>();
    run_with_frames(flashed_cbx_ao412(), 3);
}

TEST(FlashedCbxAo412, BootsAgainAfterEachReset) {
    verifies<req::CO_NMT_001, req::CO_NMT_003>();
    run_with_resets(flashed_cbx_ao412(), 3);
}

TEST(FlashedCbxAo412, SendsAfterABusyBusWhatWaitsInItsQueue) {
    verifies<req::CO_CAN_006>();
    run_with_busy_bus(flashed_cbx_ao412(), 3);
}

TEST(FlashedCbxAo412, RecordsAFailedSelfTestAndLeavesTheBus) {
    verifies<req::CO_SELF_005, req::CO_SELF_008, req::CO_SELF_009, req::CO_SELF_011, req::CO_SELF_017>();
    runs_with_failed_self_tests<cbx_ao412::Device>(flashed_cbx_ao412());
}

TEST(FlashedCbxAo412, NoticesOutputsAndSettingsThatChangeInAPass) {
    verifies<req::CO_SELF_007, req::CO_SELF_019>();
    runs_with_failures_in_a_pass<cbx_ao412::Device>(flashed_cbx_ao412());
}

// The error codes of src/target/README.md: 5000h for failed hardware, 6110h for failed software.
TEST(FlashedCbxAo412, ReportsTheFailedSelfTestOfTheLastRun) {
    verifies<req::CO_SELF_009, req::CO_SELF_016>();
    const auto code_after = [](stm32f405::SelfTest test, bool resets) {
        stm32f405::FailureRecord{common_store().failure.registers()}.keep(test);
        FlashedBench bench{flashed_cbx_ao412()};
        if (resets) {
            bench.chip.clock.reset_by_watchdog();
        }
        EXPECT_TRUE(bench.run(1500));
        for (const Frame& frame : bench.take_sent()) {
            if (frame.id == 0x083) {
                return frame.data[0] | frame.data[1] << 8;
            }
        }
        return 0;
    };
    using stm32f405::SelfTest;
    EXPECT_EQ(code_after(SelfTest::none, false), 0);
    EXPECT_EQ(code_after(SelfTest::none, true), 0x6110);
    for (const SelfTest test : {SelfTest::core, SelfTest::clock, SelfTest::ram, SelfTest::flash}) {
        EXPECT_EQ(code_after(test, true), 0x5000);
    }
    for (const SelfTest test : {SelfTest::stack, SelfTest::outputs, SelfTest::flow, SelfTest::state}) {
        EXPECT_EQ(code_after(test, true), 0x6110);
    }
}

}  // namespace canproof::test
