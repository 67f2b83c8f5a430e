// SPDX-License-Identifier: Apache-2.0
// The start of an image: when it powers its device on, and when it lets the device join the bus. The image runs on
// models of the whole chip, in a child process, because it never returns while its device runs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "target/image/image.hpp"
#include "tests/support/stm32f405/chip_model.hpp"
#include "tests/support/stm32f405/image_store.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using testing::ExitedWithCode;

/// The memory of the image and the chip.
struct ImageParts {
    OwnStore store;
    ChipModel chip;
    std::function<void()> on_fifth_read;
    std::function<void()> stop;  ///< stops the running image, as after an exception
    stm32f405::SelfTest failed_before{};
    cbx_ao412::Outputs driven{};
};
ImageParts* parts = nullptr;

/// How the child process ends: run() returned, the device runs, on the bus or not, or what the test awaits has
/// happened.
enum Ending : int { returned = 3, on_bus, off_bus, recorded, as_expected };

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
        parts->failed_before = chip_.failed_test;
        if (reads_ == 5 && parts->on_fifth_read) {
            parts->on_fifth_read();
        }
        if (reads_ == passes) {
            std::_Exit(chip_.can.is_on_bus() && parts->chip.can.transmit() ? on_bus : off_bus);
        }
    }
    void drive(const Outputs& outputs) {
        parts->driven = outputs;
        if (parts->store->failure.at(0) != 0) {
            std::_Exit(recorded);  // the image has recorded a failed self-test
        }
        if (++drives_ == 1000) {
            std::_Exit(off_bus);
        }
    }

  private:
    stm32f405::Chip& chip_;
    int reads_{0}, drives_{0};
};

class DeviceImage : public testing::Test {
  protected:
    DeviceImage() { parts = &parts_; }
    ~DeviceImage() override { parts = nullptr; }

    [[noreturn]] static void run() {
        target::DeviceImage<cbx_ao412::Device, EndingWiring, cbx_ao412::FactoryData, 1024> image{
            stm32f405::core_160_mhz};
        parts->stop = [&image] { image.stop(); };
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
    parts_.store->flash.turn(150, 3);
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

TEST_F(DeviceImage, ExceptionDrivesTheOutputsAsBeforePowerOnAndLeavesTheBus) {
    verifies<req::CO_SELF_008>();
    parts_.on_fifth_read = [this] {
        parts_.driven.aout[0] = 5.0F;
        const bool was_on_bus = parts_.chip.can.receive(data_frame(0x603, 8)) == BxcanModel::Taken::kept;
        parts_.stop();
        const bool is_off_bus = parts_.chip.can.receive(data_frame(0x603, 8)) == BxcanModel::Taken::filtered;
        std::_Exit(was_on_bus && is_off_bus && parts_.driven.aout[0] == 0.0F ? as_expected : on_bus);
    };
    EXPECT_EXIT(run(), ExitedWithCode(as_expected), "");
}

TEST_F(DeviceImage, FailedSelfTestIsRecorded) {
    verifies<req::CO_SELF_009>();
    parts_.on_fifth_read = [this] { parts_.store->guard.at(7) = 0; };  // a stack that exceeds its memory
    EXPECT_EXIT(run(), ExitedWithCode(recorded), "");
}

TEST_F(DeviceImage, ImageStartsWithTheRecordOfAFailedSelfTest) {
    verifies<req::CO_SELF_009>();
    stm32f405::FailureRecord{parts_.store->failure.registers()}.keep(stm32f405::SelfTest::flow);
    parts_.on_fifth_read = [this] {
        std::_Exit(parts_.failed_before == stm32f405::SelfTest::flow ? as_expected : on_bus);
    };
    EXPECT_EXIT(run(), ExitedWithCode(as_expected), "");
}

}  // namespace canproof::test
