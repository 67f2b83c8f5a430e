// SPDX-License-Identifier: Apache-2.0
// A model of the independent watchdog for its driver (RM0090 chapter 21). The test advances its time.
#pragma once

#include "target/stm32f405/watchdog.hpp"
#include "tests/support/stm32f405/peripheral.hpp"

namespace canproof::test {

class WatchdogModel final : public Peripheral {
  public:
    WatchdogModel() : Peripheral{&block_, sizeof block_} {}

    stm32f405::WatchdogRegisters& registers() { return block_; }

    /// Lets `ms` milliseconds pass while the watchdog's oscillator has `khz` (nominally 32 kHz).
    void pass(double ms, double khz = 32);
    bool has_bitten() const { return bitten_; }
    bool is_running() const { return running_; }
    std::size_t refreshes() const { return refreshes_; }
    /// Holds the update of IWDG_PR or of IWDG_RLR: its flag in IWDG_SR stays set, and the new value has no effect.
    void hold_updates(bool prescaler, bool reload) {
        prescaler_.held = prescaler;
        reload_.held = reload;
    }
    void stay_updating(bool stays) { hold_updates(stays, stays); }

  private:
    std::uint32_t on_read(std::size_t offset) override;
    void on_write(std::size_t offset, std::uint32_t bits) override;

    /// A register whose new value takes effect after some cycles of the oscillator.
    struct Updated {
        std::uint32_t value;  ///< the value in effect
        std::uint32_t next{0};
        std::uint32_t reads{0};  ///< reads of IWDG_SR until the new value takes effect; 0: none is pending
        bool held{false};

        void take() {
            value = reads > 0 && !held ? next : value;
            reads = held ? reads : 0;
        }
    };

    void write(Updated& one, std::uint32_t bits);

    stm32f405::WatchdogRegisters block_{};
    bool running_{false}, accessible_{false}, bitten_{false};
    Updated prescaler_{0}, reload_{0xFFF};
    double left_{0};  ///< remaining counts
    std::size_t refreshes_{0};
};

}  // namespace canproof::test
