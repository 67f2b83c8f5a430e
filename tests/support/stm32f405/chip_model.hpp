// SPDX-License-Identifier: Apache-2.0
// The peripherals of a whole STM32F405 at their addresses, for code that uses the drivers of a Chip. The addresses are
// those of RM0090 2.3, Table 1, and the offsets those of its chapters 8 and 13, repeated here to check the driver's
// own.
#pragma once

#include <utility>

#include "target/stm32f405/chip.hpp"
#include "tests/support/stm32f405/bxcan_model.hpp"
#include "tests/support/stm32f405/capture_model.hpp"
#include "tests/support/stm32f405/clock_model.hpp"
#include "tests/support/stm32f405/flash_model.hpp"
#include "tests/support/stm32f405/watchdog_model.hpp"

namespace canproof::test {

/// The clock of a peripheral: a bit of RCC_AHB1ENR (30h), RCC_APB1ENR (40h) or RCC_APB2ENR (44h). While it is off, the
/// peripheral ignores writes and reads as 0 (RM0090 7.3).
struct Supply {
    const ClockModel* clock{nullptr};  ///< without a model, the clock is always on
    std::size_t offset{0};
    std::uint32_t position{0};

    bool is_on() const { return clock == nullptr || (clock->enabled(offset) >> position & 1U) != 0; }
};

/// Passes accesses to the registers at an address of the chip on to the model that has these registers.
class Window final : public Peripheral {
  public:
    template <typename Registers>
    Window(std::uintptr_t address, Registers& registers, Supply supply = {})
        : Window{address, reinterpret_cast<stm32f405::Register*>(&registers), sizeof registers, supply} {}
    Window(std::uintptr_t address, stm32f405::Register* first, std::size_t size, Supply supply = {})
        : Peripheral{reinterpret_cast<const void*>(address), size}, first_{first}, supply_{supply} {}

  private:
    std::uint32_t on_read(std::size_t offset) override { return supply_.is_on() ? first_[offset / 4].read() : 0; }
    void on_write(std::size_t offset, std::uint32_t bits) override {
        if (!supply_.is_on()) {
            return fault("a write to a peripheral without its clock");
        }
        first_[offset / 4].write(bits);
    }

    stm32f405::Register* first_;
    Supply supply_;
};

/// A port of 16 pins. The test sets the levels of inputs.
class PortModel final : public Peripheral {
  public:
    enum class Mode : std::uint32_t { input, output, alternate, analog };  ///< RM0090 8.4.1

    explicit PortModel(std::uintptr_t address, Supply supply = {})
        : Peripheral{reinterpret_cast<const void*>(address), 0x28}, supply_{supply} {}

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
        if (!supply_.is_on()) {
            return fault("a write to a port without its clock");
        }
        if (offset == 0x18) {
            high_ = (high_ & ~(bits >> 16U)) | (bits & 0xFFFFU);
        } else {
            bits_.at(offset / 4) = bits;
        }
    }

    Supply supply_;
    std::array<std::uint32_t, 10> bits_{};
    std::uint32_t levels_{0xFFFF}, high_{0};
};

/// A converter that ends each conversion at once (RM0090 13.3, 13.13).
class AdcModel final : public Peripheral {
  public:
    static constexpr std::uintptr_t address = 0x40012000;

    explicit AdcModel(Supply supply = {})
        : Peripheral{reinterpret_cast<const void*>(address), 0x308}, supply_{supply} {}

    /// The 12-bit code of each channel. Channel n is pin PAn for n = 0…7, and 16 is the chip's sensor of temperature.
    std::array<std::uint32_t, 17> codes{};

    /// Sets whether a conversion ends.
    void answer(bool answers) { answers_ = answers; }
    /// Returns the channels of the conversions since the last call.
    std::vector<std::uint32_t> take_conversions() { return std::exchange(conversions_, {}); }

  private:
    static constexpr std::uint32_t done = 1U << 1U, on = 1U << 0U, start = 1U << 30U, sensor_on = 1U << 23U;

    std::uint32_t on_read(std::size_t offset) override {
        if (offset == 0x4C) {
            status_ = 0;  // reading the result clears EOC
            return result_;
        }
        return offset == 0x00 ? status_ : 0;
    }
    void on_write(std::size_t offset, std::uint32_t bits) override {
        if (!supply_.is_on()) {
            return fault("a write to the converter without its clock");
        }
        channel_ = offset == 0x34 ? bits : channel_;
        common_ = offset == 0x304 ? bits : common_;
        if (offset == 0x08) {
            // SWSTART has an effect only when ADON was set before (RM0090 13.13.3).
            if ((bits & start) != 0 && is_on_) {
                convert();
            }
            is_on_ = (bits & on) != 0;
        }
    }
    void convert() {
        conversions_.push_back(channel_);
        const bool has_source = channel_ != 16 || (common_ & sensor_on) != 0;
        result_ = has_source ? codes.at(channel_) : 0;
        status_ = answers_ ? done : 0;
    }

    Supply supply_;
    std::uint32_t channel_{0}, common_{0}, status_{0}, result_{0};
    bool is_on_{false}, answers_{true};
    std::vector<std::uint32_t> conversions_;
};

/// The models of all peripherals that a Chip uses.
struct ChipModel {
    static constexpr std::size_t ahb1 = 0x30, apb1 = 0x40, apb2 = 0x44;  ///< RCC_AHB1ENR, RCC_APB1ENR, RCC_APB2ENR

    ClockModel clock;
    FlashModel flash;
    WatchdogModel watchdog;
    PlainModel<stm32f405::TimerRegisters> tim2, tim3, tim4;
    CaptureModel tim5;
    BxcanModel can;
    PlainModel<stm32f405::DacRegisters> dac;
    PlainModel<stm32f405::Register> nvic;
    PortModel port_a{0x40020000, {&clock, ahb1, 0}};
    PortModel port_b{0x40020400, {&clock, ahb1, 1}};
    PortModel port_c{0x40020800, {&clock, ahb1, 2}};
    AdcModel adc{Supply{&clock, apb2, 8}};

    Window at_tim2{0x40000000, tim2.registers(), {&clock, apb1, 0}};
    Window at_tim3{0x40000400, tim3.registers(), {&clock, apb1, 1}};
    Window at_tim4{0x40000800, tim4.registers(), {&clock, apb1, 2}};
    Window at_tim5{0x40000C00, tim5.registers(), {&clock, apb1, 3}};
    Window at_watchdog{0x40003000, watchdog.registers()};
    Window at_can{0x40006400, can.registers(), {&clock, apb1, 25}};
    Window at_power{0x40007000, clock.power()};
    Window at_dac{0x40007400, dac.registers(), {&clock, apb1, 29}};
    Window at_clock{0x40023800, clock.registers()};
    Window at_flash{0x40023C00, flash.registers()};
    Window at_nvic{0xE000E100, nvic.registers()};
    Window at_sector_2{0x08008000, &flash.sectors()[0].words[0], 0x4000};
    Window at_sector_3{0x0800C000, &flash.sectors()[1].words[0], 0x4000};
};

}  // namespace canproof::test
