// The independent watchdog as its driver meets it (RM0090 chapter 21): time passes when the test says so.
#pragma once

#include "target/stm32f405/watchdog.hpp"
#include "tests/support/stm32f405/peripheral.hpp"

namespace canproof::test {

class WatchdogModel final : public Peripheral {
  public:
    WatchdogModel() : Peripheral{&block_, sizeof block_} {}

    stm32f405::WatchdogRegisters& registers() { return block_; }

    /// The oscillator runs at `khz`, 32 as a rule.
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
    double left_{0};  ///< counts
    std::size_t refreshes_{0};
};

}  // namespace canproof::test
