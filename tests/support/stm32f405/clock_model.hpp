// SPDX-License-Identifier: Apache-2.0
// Models of reset and clock control, power and flash for the clock driver (RM0090 chapters 3, 5 and 7).
#pragma once

#include <map>

#include "target/stm32f405/clock.hpp"
#include "tests/support/stm32f405/peripheral.hpp"

namespace canproof::test {

/// Models a peripheral whose registers have no side effects.
template <typename Registers>
class PlainModel final : public Peripheral {
  public:
    PlainModel() : Peripheral{&block_, sizeof block_}, bits_(sizeof block_ / 4) {}

    Registers& registers() { return block_; }
    std::uint32_t& at(std::size_t offset) { return bits_.at(offset / 4); }

  private:
    std::uint32_t on_read(std::size_t offset) override { return at(offset); }
    void on_write(std::size_t offset, std::uint32_t bits) override { at(offset) = bits; }

    Registers block_{};
    std::vector<std::uint32_t> bits_;
};

class ClockModel;

/// The power controller. Without its clock it ignores writes, and while the PLL is on the voltage stays as it is
/// (RM0090 5.4.1).
class PowerModel final : public Peripheral {
  public:
    explicit PowerModel(const ClockModel& clock) : Peripheral{&block_, sizeof block_}, clock_{clock} {}

    stm32f405::PowerRegisters& registers() { return block_; }
    std::uint32_t control() const { return control_; }

  private:
    std::uint32_t on_read(std::size_t offset) override { return offset == 0 ? control_ : 0; }
    void on_write(std::size_t offset, std::uint32_t bits) override;

    const ClockModel& clock_;
    stm32f405::PowerRegisters block_{};
    std::uint32_t control_{0};
};

class ClockModel final : public Peripheral {
  public:
    ClockModel() : Peripheral{&block_, sizeof block_} {}

    stm32f405::ClockRegisters& registers() { return block_; }
    stm32f405::PowerRegisters& power() { return power_.registers(); }
    stm32f405::FlashRegisters& flash() { return flash_.registers(); }

    void break_crystal() { crystal_works_ = false; }
    void break_pll() { pll_works_ = false; }
    /// Keeps the core on its present clock when the driver selects another one.
    void break_switch() { switches_ = false; }
    void reset_by_watchdog() { status_ |= stm32f405::rcc_csr::by_watchdog; }

    /// These two functions return the configured clock of the core and of APB1, in MHz.
    double core_mhz() const;
    double apb1_mhz() const;
    /// Returns a register that enables the clocks of peripherals: RCC_AHB1ENR (30h), RCC_APB1ENR (40h), RCC_APB2ENR
    /// (44h).
    std::uint32_t enabled(std::size_t offset) const { return enabled_.at(offset); }
    bool is_pll_on() const { return (control_ & stm32f405::rcc_cr::pll_on) != 0; }
    bool is_crystal_watched() const { return (control_ & stm32f405::rcc_cr::security_on) != 0; }

  private:
    std::uint32_t on_read(std::size_t offset) override;
    void on_write(std::size_t offset, std::uint32_t bits) override;
    double pll_mhz() const;
    bool has_crystal() const { return crystal_works_ && (control_ & stm32f405::rcc_cr::crystal_on) != 0; }
    bool is_locked() const;

    stm32f405::ClockRegisters block_{};
    PowerModel power_{*this};
    PlainModel<stm32f405::FlashRegisters> flash_;
    bool crystal_works_{true}, pll_works_{true}, switches_{true};
    // Values after a reset: RM0090 7.3.
    std::uint32_t control_{0x00000083}, pll_{0x24003010}, configuration_{0}, status_{0x0E000000};
    std::map<std::size_t, std::uint32_t> enabled_{{0x30, 0x00100000}, {0x40, 0}, {0x44, 0}};
};

}  // namespace canproof::test
