// SPDX-License-Identifier: Apache-2.0
// The image of the AX060805 as it is flashed, on models of the chip.
#include "devices/ax060805/firmware/ax060805.hpp"

#include "generated/canopen/requirements.hpp"
#include "tests/support/stm32f405/flashed_runs.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST(FlashedAx060805, StartsOnlyWithASoundImageAndTheClockOfItsPll) {
    verifies<req::CO_IMAGE_001, req::CO_CLOCK_004>();
    runs_that_do_not_start(flashed_ax060805());
}

TEST(FlashedAx060805, IsOnTheBusOnlyWithItsCrystal) {
    verifies<req::CO_CLOCK_001, req::CO_CLOCK_005, req::CO_SELF_008>();
    runs_with_and_without_crystal(flashed_ax060805());
}

TEST(FlashedAx060805, TakesFramesOfOneAndOfSeveralPasses) {
    verifies<req::CO_CAN_004>();
    run_with_frames(flashed_ax060805(), 127);
}

TEST(FlashedAx060805, BootsAgainAfterEachReset) {
    verifies<req::CO_NMT_001, req::CO_NMT_003>();
    run_with_resets(flashed_ax060805(), 127);
}

TEST(FlashedAx060805, SendsAfterABusyBusWhatWaitsInItsQueue) {
    verifies<req::CO_CAN_006>();
    run_with_busy_bus(flashed_ax060805(), 127);
}

TEST(FlashedAx060805, RecordsAFailedSelfTestAndLeavesTheBus) {
    verifies<req::CO_SELF_005, req::CO_SELF_008, req::CO_SELF_009, req::CO_SELF_011, req::CO_SELF_017>();
    runs_with_failed_self_tests<ax060805::Device>(flashed_ax060805());
}

TEST(FlashedAx060805, NoticesOutputsAndSettingsThatChangeInAPass) {
    verifies<req::CO_SELF_007, req::CO_SELF_019>();
    runs_with_failures_in_a_pass<ax060805::Device>(flashed_ax060805());
}

}  // namespace canproof::test
