// SPDX-License-Identifier: Apache-2.0
// The image of the AX130751 as it is flashed, on models of the chip.
#include "devices/ax130751/firmware/ax130751.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/support/stm32f405/flashed_runs.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST(FlashedAx130751, StartsOnlyWithASoundImageAndTheClockOfItsPll) {
    verifies<req::CO_IMAGE_001, req::CO_CLOCK_004>();
    runs_that_do_not_start(flashed_ax130751());
}

TEST(FlashedAx130751, IsOnTheBusOnlyWithItsCrystal) {
    verifies<req::CO_CLOCK_001, req::CO_CLOCK_005, req::CO_SELF_008>();
    runs_with_and_without_crystal(flashed_ax130751());
}

TEST(FlashedAx130751, TakesFramesOfOneAndOfSeveralPasses) {
    verifies<req::CO_CAN_004>();
    run_with_frames(flashed_ax130751());
}

TEST(FlashedAx130751, RecordsAFailedSelfTestAndLeavesTheBus) {
    verifies<req::CO_SELF_008, req::CO_SELF_009, req::CO_SELF_011, req::CO_SELF_017>();
    runs_with_failed_self_tests<ax130751::Device>(flashed_ax130751());
}

TEST(FlashedAx130751, NoticesOutputsAndSettingsThatChangeInAPass) {
    verifies<req::CO_SELF_007, req::CO_SELF_019>();
    runs_with_failures_in_a_pass<ax130751::Device>(flashed_ax130751());
}

}  // namespace canproof::test
