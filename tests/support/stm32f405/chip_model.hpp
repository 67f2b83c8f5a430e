// SPDX-License-Identifier: Apache-2.0
// The peripherals of a whole STM32F405 at their addresses, for code that uses the drivers of a Chip. The addresses are
// those of RM0090 2.3, Table 1, and the offsets those of its chapters 8 and 13, repeated here to check the driver's
// own.
#pragma once

#include "target/stm32f405/chip.hpp"
#include "tests/support/stm32f405/bxcan_model.hpp"
#include "tests/support/stm32f405/capture_model.hpp"
#include "tests/support/stm32f405/clock_model.hpp"
#include "tests/support/stm32f405/flash_model.hpp"
#include "tests/support/stm32f405/watchdog_model.hpp"

namespace canproof::test {

/// Passes accesses to the registers at an address of the chip on to the model that has these registers.
class Window final : public Peripheral {
  public:
    template <typename Registers>
    Window(std::uintptr_t address, Registers& registers)
        : Window{address, reinterpret_cast<stm32f405::Register*>(&registers), sizeof registers} {}
    Window(std::uintptr_t address, stm32f405::Register* first, std::size_t size)
        : Peripheral{reinterpret_cast<const void*>(address), size}, first_{first} {}

  private:
    std::uint32_t on_read(std::size_t offset) override { return first_[offset / 4].read(); }
    void on_write(std::size_t offset, std::uint32_t bits) override { first_[offset / 4].write(bits); }

    stm32f405::Register* first_;
};

/// A port of 16 pins. The test sets the levels of inputs.
class PortModel final : public Peripheral {
  public:
    enum class Mode : std::uint32_t { input, output, alternate, analog };  ///< RM0090 8.4.1

    explicit PortModel(std::uintptr_t address) : Peripheral{reinterpret_cast<const void*>(address), 0x28} {}

    void set_levels(std::uint32_t levels) { levels_ = levels; }
    Mode mode(std::uint32_t pin) const { return static_cast<Mode>(bits_[0] >> (2 * pin) & 3U); }
    bool is_pulled_up(std::uint32_t pin) const { return (bits_[3] >> (2 * pin) & 3U) == 1; }
    std::uint32_t function(std::uint32_t pin) const { return bits_[8 + pin / 8] >> (4 * (pin % 8)) & 0xFU; }
    /// Returns the pins that are outputs and high, one bit for each pin.
    std::uint32_t driven() const {
        std::uint32_t pins = 0;
        for (std::uint32_t pin = 0; pin < 16; ++pin) {
            pins |= mode(pin) == Mode::output ? high_ & (1U << pin) : 0U;
        }
        return pins;
    }

  private:
    std::uint32_t on_read(std::size_t offset) override { return offset == 0x10 ? levels_ : bits_.at(offset / 4); }
    void on_write(std::size_t offset, std::uint32_t bits) override {
        if (offset == 0x18) {
            high_ = (high_ & ~(bits >> 16U)) | (bits & 0xFFFFU);
        } else {
            bits_.at(offset / 4) = bits;
        }
    }

    std::array<std::uint32_t, 10> bits_{};
    std::uint32_t levels_{0xFFFF}, high_{0};
};

/// A converter that ends each conversion at once.
class AdcModel final : public Peripheral {
  public:
    AdcModel() : Peripheral{reinterpret_cast<const void*>(0x40012000), 0x308} {}

    /// The 12-bit code of each channel. Channel n is pin PAn for n = 0…7, and 16 is the chip's sensor of temperature.
    std::array<std::uint32_t, 17> codes{};

  private:
    std::uint32_t on_read(std::size_t offset) override {
        return offset == 0x4C ? codes.at(channel_) : offset == 0x00 ? 2U : 0U;
    }
    void on_write(std::size_t offset, std::uint32_t bits) override { channel_ = offset == 0x34 ? bits : channel_; }

    std::uint32_t channel_{0};
};

/// The models of all peripherals that a Chip uses.
struct ChipModel {
    ClockModel clock;
    FlashModel flash;
    WatchdogModel watchdog;
    PlainModel<stm32f405::TimerRegisters> tim2, tim3, tim4;
    CaptureModel tim5;
    BxcanModel can;
    PlainModel<stm32f405::DacRegisters> dac;
    PlainModel<stm32f405::Register> nvic;
    PortModel port_a{0x40020000}, port_b{0x40020400}, port_c{0x40020800};
    AdcModel adc;

    Window at_tim2{0x40000000, tim2.registers()};
    Window at_tim3{0x40000400, tim3.registers()};
    Window at_tim4{0x40000800, tim4.registers()};
    Window at_tim5{0x40000C00, tim5.registers()};
    Window at_watchdog{0x40003000, watchdog.registers()};
    Window at_can{0x40006400, can.registers()};
    Window at_power{0x40007000, clock.power()};
    Window at_dac{0x40007400, dac.registers()};
    Window at_clock{0x40023800, clock.registers()};
    Window at_flash{0x40023C00, flash.registers()};
    Window at_nvic{0xE000E100, nvic.registers()};
    Window at_sector_2{0x08008000, &flash.sectors()[0].words[0], 0x4000};
    Window at_sector_3{0x0800C000, &flash.sectors()[1].words[0], 0x4000};
};

}  // namespace canproof::test
