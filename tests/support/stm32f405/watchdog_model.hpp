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
    void stay_updating(bool stays) { stays_updating_ = stays; }

  private:
    std::uint32_t on_read(std::size_t offset) override;
    void on_write(std::size_t offset, std::uint32_t bits) override;

    stm32f405::WatchdogRegisters block_{};
    bool running_{false}, accessible_{false}, bitten_{false}, stays_updating_{false};
    std::uint32_t prescaler_{0}, reload_{0xFFF};
    std::uint32_t updating_reads_{0};
    double left_{0};  ///< remaining counts
    std::size_t refreshes_{0};
};

}  // namespace canproof::test
