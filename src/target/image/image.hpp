// SPDX-License-Identifier: Apache-2.0
// The interface between src/devices/NAME/target/device.cpp and interrupts.cpp.
#pragma once

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/chip.hpp"
#include "target/stm32f405/device_loop.hpp"
#include "target/stm32f405/image_check.hpp"

/// Handles the interrupt for received frames. device.cpp of the device defines it: it empties the FIFOs of the CAN
/// controller.
extern "C" void can_received();
/// Switches the outputs off after an exception of the processor. Each device defines this function in its device.cpp;
/// there it calls DeviceImage::stop().
extern "C" void device_failed();

namespace canproof::target {

/// Returns the memory areas of the image, whose addresses the linker provides.
stm32f405::ImageMemory image_memory();
/// Returns the words of RAM that record a failed self-test; a reset by the watchdog keeps them.
stm32f405::FailureWords& failure_words();

/// A device with its drivers. `Wiring` connects the device to its board; `MemorySize` is the size of its parameter
/// memory in bytes.
template <typename Device, typename Wiring, typename FactoryData, std::size_t MemorySize>
class DeviceImage {
  public:
    explicit DeviceImage(const stm32f405::ClockPlan& plan) : chip_{plan} {}

    /// Starts the chip and its device, and runs until power is lost. Returns when the device must not run: the image is
    /// damaged, or the PLL gives no clock.
    void run() {
        static_assert(implements<req::CO_IMAGE_001>);
        if (!stm32f405::is_sound_image(regions_.vectors, regions_.flash)) {
            return;
        }
        static_assert(implements<req::CO_SELF_009>);
        chip_.failed_test = record_.take();
        chip_.start();
        static_assert(implements<req::CO_CLOCK_004>);
        if (chip_.source == stm32f405::ClockSource::none) {
            return;
        }
        wiring_.start();
        is_wired_ = true;
        memory_.open();
        // if this fails to erase the sector, a later commit erases it or reports the failure
        static_cast<void>(memory_.prepare());
        stm32f405::DeviceLoop<Device, Wiring> loop{device_,    queue_,         wiring_, chip_.can,
                                                   chip_.time, chip_.watchdog, tests_};
        static_assert(implements<req::CO_CLOCK_005>);
        loop.power_on(chip_.source == stm32f405::ClockSource::crystal);
        for (;;) {
            loop.pass();
            if (loop.failed() != stm32f405::SelfTest::none) {
                record_.keep(loop.failed());
            }
        }
    }
    /// Handles the interrupt for received frames.
    void drain() { chip_.can.drain(); }
    /// Drives the outputs as before power-on and leaves the bus.
    static_assert(implements<req::CO_SELF_008>);
    void stop() {
        if (is_wired_) {
            wiring_.drive(typename Wiring::Outputs{});
            chip_.can.set_bit_rate(0, Instant{});
        }
    }

  private:
    stm32f405::Chip chip_;
    stm32f405::ImageMemory regions_{image_memory()};
    stm32f405::FailureRecord record_{failure_words()};
    stm32f405::SelfTests tests_{regions_, stm32f405::registers_at<stm32f405::CaptureRegisters>(stm32f405::tim5_address),
                                chip_.plan.timer_mhz()};
    stm32f405::JournalRam<MemorySize> ram_;
    stm32f405::ParameterJournal memory_{chip_.flash, stm32f405::parameter_sectors(), MutableBytes{ram_.bytes},
                                        Slots<std::uint32_t>{ram_.changed}};
    TransmitQueue queue_;
    Device device_{memory_, queue_, FactoryData{}};
    Wiring wiring_{chip_};
    bool is_wired_{false};
};

}  // namespace canproof::target
