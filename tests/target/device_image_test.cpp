// SPDX-License-Identifier: Apache-2.0
// The start of an image: when it powers its device on, and when it lets the device join the bus. The image runs on
// models of the whole chip, in a child process, because it never returns while its device runs.
#include <gtest/gtest.h>

#include <cstdlib>

#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "target/image/image.hpp"
#include "tests/support/stm32f405/chip_model.hpp"
#include "tests/support/stm32f405/ram_model.hpp"
#include "tests/support/stm32f405/sealed_flash.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using testing::ExitedWithCode;

/// The memory of the image and the chip.
struct ImageParts {
    SealedFlash flash{72, 200};
    RamModel ram{64};
    RamModel guard{8};
    PlainModel<stm32f405::FailureWords> failure;
    ChipModel chip;
};
ImageParts* parts = nullptr;

/// How the child process ends: run() returned, or the device runs, on the bus or not.
enum Ending : int { returned = 3, on_bus, off_bus };

/// A board whose switches select node 3 at 1 Mbit/s. It ends the process after a few passes of the main loop.
struct EndingWiring {
    using Inputs = cbx_ao412::Inputs;
    using Outputs = cbx_ao412::Outputs;

    explicit EndingWiring(stm32f405::Chip& chip) : chip_{chip} {}
    void start() {}
    void read(Inputs& inputs) {
        constexpr int passes = 10;
        inputs.switch_low = 3;
        inputs.switch_baud = 0;
        parts->chip.tim2.at(0x24) += 1000;  // in us: the loop reads the inputs once in a millisecond
        ++reads_;
        if (reads_ == passes) {
            std::_Exit(chip_.can.is_on_bus() && parts->chip.can.transmit() ? on_bus : off_bus);
        }
    }
    void drive(const Outputs&) {}

  private:
    stm32f405::Chip& chip_;
    int reads_{0};
};

class DeviceImage : public testing::Test {
  protected:
    DeviceImage() { parts = &parts_; }
    ~DeviceImage() override { parts = nullptr; }

    [[noreturn]] static void run() {
        target::DeviceImage<cbx_ao412::Device, EndingWiring, cbx_ao412::FactoryData, 1024> image{
            stm32f405::core_160_mhz};
        image.run();
        std::_Exit(returned);
    }

    ImageParts parts_;
};

}  // namespace

TEST_F(DeviceImage, SoundImageWithItsCrystalRunsItsDeviceOnTheBus) {
    verifies<req::CO_CLOCK_001, req::CO_IMAGE_001>();
    EXPECT_EXIT(run(), ExitedWithCode(on_bus), "");
}

TEST_F(DeviceImage, DamagedImageDoesNotPowerItsDeviceOn) {
    verifies<req::CO_IMAGE_001>();
    parts_.flash.turn(150, 3);
    EXPECT_EXIT(run(), ExitedWithCode(returned), "");
}

TEST_F(DeviceImage, ImageWithoutThePllDoesNotPowerItsDeviceOn) {
    verifies<req::CO_CLOCK_004>();
    parts_.chip.clock.break_pll();
    EXPECT_EXIT(run(), ExitedWithCode(returned), "");
}

TEST_F(DeviceImage, ImageOnTheInternalOscillatorRunsItsDeviceOffTheBus) {
    verifies<req::CO_CLOCK_003, req::CO_CLOCK_005>();
    parts_.chip.clock.break_crystal();
    EXPECT_EXIT(run(), ExitedWithCode(off_bus), "");
}

}  // namespace canproof::test

namespace canproof::target {

stm32f405::ImageMemory image_memory() {
    return {test::parts->flash.vectors(),
            test::parts->flash.image(),
            {test::parts->ram.words(), 0, 0},
            test::parts->guard.words()};
}

stm32f405::FailureWords& failure_words() {
    return test::parts->failure.registers();
}

}  // namespace canproof::target
