// SPDX-License-Identifier: Apache-2.0
// The reaction of a device to a failed self-test. The device is the CAN-CBX-AO412 with 5 V at its output 1; it runs on
// models of the microcontroller.
#include <gmock/gmock.h>

#include "tests/support/settings_watch.hpp"
#include "tests/support/stm32f405/core_model.hpp"
#include "tests/support/stm32f405/device_on_models.hpp"
#include "tests/support/stm32f405/small_devices.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using stm32f405::SelfTest;
using testing::IsEmpty;

class FailedSelfTest : public testing::Test {
  protected:
    void SetUp() override {
        core_model() = CoreModel{};
        unit_.run(5);
        unit_.ask(0x000, {0x01, 0x03});                                      // NMT start
        unit_.ask(0x603, {0x2B, 0x11, 0x64, 0x01, 0xB3, 0x3E, 0x00, 0x00});  // the manual, 7.10.2.3: 5.0 V
        ASSERT_NEAR(unit_.board.driven.aout[0], 5.0F, 0.01F);
        ASSERT_EQ(unit_.loop.failed(), SelfTest::none);
    }
    void TearDown() override { core_model() = CoreModel{}; }

    cbx_ao412::Outputs& outputs() { return const_cast<cbx_ao412::Outputs&>(unit_.device.outputs()); }

    /// Inverts one bit of 2405h:1, the calibration gain of output 1.
    void change_gain() {
        const EntryRef gain = unit_.device.objects().lookup(0x2405, 1);
        ASSERT_TRUE(gain.exists());
        const_cast<std::uint8_t*>(unit_.device.objects().bytes(*gain.row).data())[1] ^= 0x40;
    }

    /// Runs the main loop until a self-test fails, for at most `passes` passes; the failed one must be `test`. Then
    /// checks that the outputs are off, the bus is silent and the watchdog is not refreshed any more.
    void expect_safe_state(SelfTest test, std::uint32_t passes) {
        for (std::uint32_t i = 0; i < passes && unit_.loop.failed() == SelfTest::none; ++i) {
            EXPECT_THAT(unit_.run(1), IsEmpty());
        }
        EXPECT_EQ(unit_.loop.failed(), test);
        const std::size_t refreshes = chips_.watchdog.refreshes();
        unit_.board.driven.aout[0] = 5.0F;  // 5 V that the loop has not set; it must switch them off
        EXPECT_THAT(unit_.run(5), IsEmpty());
        EXPECT_FALSE(unit_.can.is_on_bus());
        EXPECT_NE(chips_.can.receive(data_frame(0x603, 8)), BxcanModel::Taken::kept);
        for (const float volts : unit_.board.driven.aout) {
            EXPECT_EQ(volts, 0.0F);
        }
        EXPECT_FALSE(chips_.watchdog.has_bitten());
        EXPECT_THAT(unit_.run(10010), IsEmpty());  // 10,010 steps are 1.001 s
        EXPECT_EQ(chips_.watchdog.refreshes(), refreshes);
        EXPECT_TRUE(chips_.watchdog.has_bitten());
        EXPECT_EQ(unit_.loop.failed(), test);
    }

    Chips chips_;
    Unit unit_{chips_};
};

}  // namespace

TEST_F(FailedSelfTest, StuckBitOfRamEndsInTheSafeState) {
    verifies<req::CO_SELF_001, req::CO_SELF_008>();
    chips_.ram.set_defect({RamModel::Fault::stuck, {40, 7}, true, {0, 0}, false});
    // The RAM of 64 words is tested in 21 slices of four words; neighbouring slices share one word. The loop tests one
    // slice in every third pass.
    expect_safe_state(SelfTest::ram, 63);
}

TEST_F(FailedSelfTest, FlippedBitOfFlashEndsInTheSafeState) {
    verifies<req::CO_SELF_002, req::CO_SELF_008>();
    chips_.image.turn(150, 2);
    // The vectors (72 bytes) are 5 slices and the code (204 bytes) 13; the loop checks one slice in every third pass.
    // Two rounds are allowed, because the first may already be past the changed byte.
    expect_safe_state(SelfTest::flash, 2 * 3 * 18);
}

TEST_F(FailedSelfTest, FailedCoreRegisterEndsInTheSafeState) {
    verifies<req::CO_SELF_003, req::CO_SELF_008>();
    core_model().registers_hold = false;
    expect_safe_state(SelfTest::core, 3);
}

TEST_F(FailedSelfTest, StackOverflowEndsInTheSafeState) {
    verifies<req::CO_SELF_004, req::CO_SELF_008, req::CO_WATCHDOG_002>();
    chips_.guard.at(7) = 0;
    expect_safe_state(SelfTest::stack, 1);
}

TEST_F(FailedSelfTest, ClockOfTwiceThePlannedFrequencyEndsInTheSafeState) {
    verifies<req::CO_SELF_006, req::CO_SELF_008>();
    chips_.capture.timer_mhz = 160;
    expect_safe_state(SelfTest::clock, 10);
}

TEST_F(FailedSelfTest, OutputCorruptedBeforeTheComputationIsNotDriven) {
    verifies<req::CO_SELF_007, req::CO_SELF_008>();
    unit_.board.on_read = [this] { outputs().aout[2] = 8.0F; };
    unit_.run(10);  // in 1 ms (10 passes) the loop reads the inputs once and so calls on_read()
    EXPECT_EQ(unit_.board.driven.aout[2], 0.0F);
    expect_safe_state(SelfTest::outputs, 0);
}

/// The loop gives the controller a new bit rate of the device in each pass, also in one without a computation.
TEST_F(FailedSelfTest, BitRateCorruptedInRamIsNotGivenToTheController) {
    verifies<req::CO_SELF_011, req::CO_SELF_008>();
    bool has_read = false;
    unit_.board.on_read = [&has_read] { has_read = true; };
    for (int i = 0; i < 10 && !has_read; ++i) {
        unit_.run(1);
    }
    ASSERT_TRUE(has_read);  // the device computes again 1 ms (10 passes) later
    constexpr std::uint32_t bit_rate = 1000000;
    auto* const bytes = reinterpret_cast<std::uint8_t*>(&unit_.device);
    const auto* const value = reinterpret_cast<const std::uint8_t*>(&bit_rate);
    auto* const found = std::search(bytes, bytes + sizeof unit_.device, value, value + sizeof bit_rate);
    ASSERT_NE(found, bytes + sizeof unit_.device);
    ASSERT_EQ(unit_.device.bit_rate(), bit_rate);
    *found ^= 0x20;  // 1,000,032 bit/s, for which there is no bit timing
    ASSERT_NE(unit_.device.bit_rate(), bit_rate);
    expect_safe_state(SelfTest::state, 1);
}

TEST_F(FailedSelfTest, ParameterCorruptedInRamIsNotUsedForTheNextFrame) {
    verifies<req::CO_SELF_011, req::CO_SELF_008, req::CO_SELF_018>();
    change_gain();
    Frame request = data_frame(0x603, 8);
    request.data = {0x2B, 0x11, 0x64, 0x01, 0xB3, 0x3E, 0x00, 0x00};
    chips_.can.receive(request);
    EXPECT_THAT(unit_.run(1), IsEmpty());
    EXPECT_EQ(unit_.board.driven.aout[0], 0.0F);
    expect_safe_state(SelfTest::state, 0);
}

TEST_F(FailedSelfTest, SettingCorruptedWhileTheDeviceComputesIsNoticedInThatPass) {
    verifies<req::CO_SELF_019, req::CO_SELF_008>();
    const std::size_t pieces = pieces_of(unit_.device.settings()).size();
    EXPECT_EQ(pieces, 5U);  // the dictionary, RPDO1 to RPDO3 and their mapped lines; the device has no TPDO
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        Chips chips;
        Unit unit{chips};
        unit.run(5);
        // The loop reads the inputs after it has compared the state with its checksum, and before the device computes.
        unit.board.on_read = [&unit, piece] {
            MutableBytes bytes = pieces_of(unit.device.settings())[piece];
            bytes.set(1, static_cast<std::uint8_t>(bytes[1] ^ 0x40U));
        };
        EXPECT_THAT(unit.run(10), IsEmpty());  // in 1 ms (10 passes) the loop reads the inputs once
        EXPECT_EQ(unit.loop.failed(), SelfTest::state) << piece;
    }
}

TEST_F(FailedSelfTest, SettingThatAClientWritesIsNoFailedSelfTest) {
    verifies<req::CO_SELF_019>();
    const std::uint32_t before = unit_.device.settings().changes;
    unit_.ask(0x603, {0x2B, 0x17, 0x10, 0x00, 0xF4, 0x01, 0, 0});        // 1017h producer heartbeat time: 500 ms
    unit_.ask(0x603, {0x23, 0x00, 0x14, 0x01, 0x03, 0x02, 0x00, 0x80});  // 1400h:1 COB-ID of RPDO1: not valid
    unit_.ask(0x603, {0x23, 0x00, 0x14, 0x01, 0x04, 0x02, 0x00, 0x00});  // 204h
    unit_.ask(0x000, {0x82, 0x03});                                      // NMT reset communication
    EXPECT_NE(unit_.device.settings().changes, before);
    EXPECT_EQ(unit_.loop.failed(), SelfTest::none);
}

TEST_F(FailedSelfTest, ParameterCorruptedInRamIsNoticedWithinAMillisecond) {
    verifies<req::CO_SELF_011, req::CO_SELF_012>();
    change_gain();
    expect_safe_state(SelfTest::state, 10);
}

TEST_F(FailedSelfTest, DeviceComputesOnlyWhenItsInputsAreSampled) {
    verifies<req::CO_SELF_018>();
    bool sampled = false;
    unit_.board.on_read = [&sampled] { sampled = true; };
    for (int pass = 0; pass < 10 && !sampled; ++pass) {  // of 100 µs
        unit_.run(1);
    }
    ASSERT_TRUE(sampled);
    change_gain();  // the next computation will detect the changed byte
    EXPECT_THAT(unit_.run(9), IsEmpty());
    EXPECT_EQ(unit_.loop.failed(), SelfTest::none);
    unit_.run(1);  // the device computes again: 1 ms after the last sample of the inputs
    EXPECT_EQ(unit_.loop.failed(), SelfTest::state);
}

TEST_F(FailedSelfTest, QueuedFrameThatDidNotComeFromTheDeviceIsNotSent) {
    verifies<req::CO_SELF_008, req::CO_SELF_017>();
    ASSERT_TRUE(unit_.queue.push(data_frame(0x183, 0)));  // a frame like TPDO1, put into the queue by the test and not
                                                          // by the device
    EXPECT_THAT(unit_.run(1), IsEmpty());
    expect_safe_state(SelfTest::state, 0);
}

TEST_F(FailedSelfTest, DeviceDoesNotComputeWithCorruptedOutputs) {
    verifies<req::CO_SELF_007, req::CO_SELF_008>();
    bool sampled = false;
    unit_.board.on_read = [&sampled] { sampled = true; };
    while (!sampled) {
        unit_.run(1);
    }
    unit_.run(9);  // the next pass reads the inputs again
    unit_.board.on_read = [this] { outputs().aout[2] = 8.0F; };
    Frame request = data_frame(0x603, 8);
    request.data = {0x2B, 0x11, 0x64, 0x02, 0xB3, 0x3E, 0x00, 0x00};  // 5.0 V at output 2
    chips_.can.receive(request);
    EXPECT_THAT(unit_.run(20), IsEmpty());
    EXPECT_EQ(unit_.device.outputs().aout[1], 0.0F);
    expect_safe_state(SelfTest::outputs, 0);
}

TEST_F(FailedSelfTest, NestedLoopPassEndsInTheSafeState) {
    verifies<req::CO_SELF_005, req::CO_SELF_008>();
    unit_.board.on_read = [this] { unit_.loop.pass(); };
    expect_safe_state(SelfTest::flow, 10);
}

TEST_F(FailedSelfTest, DeviceLoopContinuesWhileNoSelfTestFails) {
    verifies<req::CO_SELF_005>();
    EXPECT_THAT(unit_.run(5000), IsEmpty());
    EXPECT_EQ(unit_.loop.failed(), SelfTest::none);
    EXPECT_NEAR(unit_.board.driven.aout[0], 5.0F, 0.01F);
    EXPECT_GE(unit_.tests.flash().passes(), 92U);  // 5000 / 3 / 18 = 92: in every third of 5000 passes, one of 18
                                                   // slices
    // 5000 / 3 / 21 = 79: in every third pass, one of 21 slices; and one whole test at power-on
    EXPECT_GE(unit_.tests.ram().passes(), 80U);
}

TEST(DeviceLoop, InputsAreReadOnceInAMillisecond) {
    verifies<req::CO_SELF_012>();
    Chips chips;
    Unit unit{chips};
    unit.run(5);
    for (int i = 0; i < 50; ++i) {
        int reads = 0;
        for (int pass = 0; pass < 10; ++pass) {  // a pass takes 100 µs
            unit.board.on_read = [&reads] { ++reads; };
            unit.run(1);
        }
        EXPECT_EQ(reads, 1);
    }
}

TEST(DeviceLoop, OutputCorruptedAfterTheComputationIsNotDriven) {
    verifies<req::CO_SELF_007, req::CO_SELF_008>();
    Chips chips;
    Unit unit{chips};  // the test uses the drivers of `unit`, but runs ChangingDevice on them
    int looks = 0;
    bool changes = false;
    ChangingDevice device{{}, &looks, &changes};
    SmallLoop<ChangingDevice> small{unit, device};
    small.run(1);
    EXPECT_EQ(small.loop.failed(), SelfTest::none);
    changes = true;
    const std::size_t drives = unit.board.drives;
    small.run(1);
    EXPECT_EQ(unit.board.drives - drives, 1U);  // only the safe state, not the corrupted output before it
    EXPECT_EQ(small.loop.failed(), SelfTest::outputs);
    EXPECT_EQ(unit.board.driven.aout[1], 0.0F);
}

TEST(DeviceLoop, DeviceDoesNotStartWithAFailedCoreOrRam) {
    verifies<req::CO_SELF_010>();
    for (const bool is_core : {true, false}) {
        Chips chips;
        core_model().registers_hold = !is_core;
        if (!is_core) {
            chips.ram.set_defect({RamModel::Fault::transition, {63, 31}, true, {0, 0}, false});
        }
        Unit unit{chips};
        EXPECT_EQ(unit.loop.failed(), is_core ? SelfTest::core : SelfTest::ram);
        EXPECT_THAT(unit.run(10010), IsEmpty());
        EXPECT_GT(unit.board.drives, 10000U);
        EXPECT_TRUE(chips.watchdog.has_bitten());
        core_model() = CoreModel{};
    }
}

}  // namespace canproof::test
