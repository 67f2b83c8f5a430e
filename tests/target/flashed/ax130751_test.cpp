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
    run_with_frames(flashed_ax130751(), 127);
}

TEST(FlashedAx130751, BootsAgainAfterEachReset) {
    verifies<req::CO_NMT_001, req::CO_NMT_003>();
    run_with_resets(flashed_ax130751(), 127);
}

TEST(FlashedAx130751, SendsAfterABusyBusWhatWaitsInItsQueue) {
    verifies<req::CO_CAN_006>();
    run_with_busy_bus(flashed_ax130751(), 127);
}

TEST(FlashedAx130751, RecordsAFailedSelfTestAndLeavesTheBus) {
    verifies<req::CO_SELF_005, req::CO_SELF_008, req::CO_SELF_009, req::CO_SELF_011, req::CO_SELF_017>();
    runs_with_failed_self_tests<ax130751::Device>(flashed_ax130751());
}

TEST(FlashedAx130751, NoticesOutputsAndSettingsThatChangeInAPass) {
    verifies<req::CO_SELF_007, req::CO_SELF_019>();
    runs_with_failures_in_a_pass<ax130751::Device>(flashed_ax130751());
}

// 5555h: start in operational mode; 1010h: store; 1017h: the heartbeat, 10 ms, whose state 05h is operational.
TEST(FlashedAx130751, StartsItselfAfterAResetWhenThatIsStored) {
    verifies<req::CO_NMT_011>();
    FlashedBench bench{flashed_ax130751()};
    bench.on_pass = [&bench] {
        const std::uint32_t number = bench.passes();
        if (number == start_passes) {
            receive(bench, 0x67F, {0x2F, 0x55, 0x55, 0x00, 1, 0, 0, 0});
        } else if (number == start_passes + 20) {
            receive(bench, 0x67F, {0x23, 0x10, 0x10, 0x01, 's', 'a', 'v', 'e'});
        } else if (number == start_passes + 40) {
            receive(bench, 0x000, {0x81, 0x7F});
        } else if (number == start_passes + 60) {
            receive(bench, 0x67F, {0x2B, 0x17, 0x10, 0x00, 10, 0, 0, 0});
        }
    };
    EXPECT_TRUE(bench.run(start_passes + 300));
    const auto sent = bench.take_sent();
    ASSERT_FALSE(sent.empty());
    EXPECT_EQ(sent.back().id, 0x77FU);
    EXPECT_EQ(sent.back().data[0], 0x05);
}

// 6310h: the type of an output, 20 for a current; 7300h: its value in uA; 2330h and 2331h: its ramps in ms. 4 mA (FA0h)
// are one sixth of the range of 24 mA and of the 4095 steps of the DAC, 16 mA (3E80h) two thirds. Channel 0 of the
// converter measures the supply, at 66 V for 4095 steps; channel 16 the chip, at 0.76 V of 3.3 V for 25 degC.
TEST(FlashedAx130751, DrivesTheCurrentsThatAClientCommands) {
    verifies<req::CO_IMAGE_003>();
    const FlashedImage image = flashed_ax130751();
    FlashedBench bench{image};
    bench.chip.adc.codes[0] = 24 * 4095 / 66;
    bench.chip.adc.codes[16] = 943;
    const std::vector<std::vector<std::uint8_t>> writes{
        {0x2B, 0x30, 0x23, 1, 0, 0, 0, 0},       {0x2B, 0x30, 0x23, 2, 0, 0, 0, 0},
        {0x2B, 0x31, 0x23, 1, 0, 0, 0, 0},       {0x2B, 0x31, 0x23, 2, 0, 0, 0, 0},
        {0x2B, 0x10, 0x63, 1, 20, 0, 0, 0},      {0x2B, 0x10, 0x63, 2, 20, 0, 0, 0},
        {0x2B, 0x00, 0x73, 1, 0xA0, 0x0F, 0, 0}, {0x2B, 0x00, 0x73, 2, 0x80, 0x3E, 0, 0}};
    std::size_t next = 0;
    bench.on_pass = [&bench, &writes, &next] {
        const std::uint32_t number = bench.passes();
        if (number == start_passes) {
            receive(bench, 0x000, {0x01, 0x7F});
        } else if (number > start_passes && number % 20 == 0 && next < writes.size()) {
            receive(bench, 0x67F, writes[next++]);
        }
    };
    EXPECT_TRUE(bench.run(start_passes + 1000));
    std::size_t accepted = 0;
    for (const Frame& frame : bench.take_sent()) {
        accepted += frame.id == 0x5FF && frame.data[0] == 0x60 ? 1 : 0;
    }
    EXPECT_EQ(accepted, writes.size());
    EXPECT_EQ(bench.chip.dac.at(0x08), 683U);
    EXPECT_EQ(bench.chip.dac.at(0x14), 2730U);
}

}  // namespace canproof::test
