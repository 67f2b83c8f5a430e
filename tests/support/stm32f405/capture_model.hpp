// SPDX-License-Identifier: Apache-2.0
// A model of TIM5 whose channel 4 captures the low-speed oscillator (RM0090 18.4). The test advances its time.
#pragma once

#include "target/stm32f405/selftest/clock_check.hpp"
#include "tests/support/stm32f405/peripheral.hpp"

namespace canproof::test {

class CaptureModel final : public Peripheral {
  public:
    CaptureModel() : Peripheral{&block_, sizeof block_} {}

    stm32f405::CaptureRegisters& registers() { return block_; }

    /// Real frequencies of the timer's clock and of the oscillator. A frequency of 0 stops that clock.
    double timer_mhz{80}, oscillator_khz{32};

    void pass(double us);
    /// Makes a capture happen between the next read of the status and the next read of the captured value.
    void capture_before_read() { before_read_ = true; }

  private:
    std::uint32_t on_read(std::size_t offset) override;
    void on_write(std::size_t offset, std::uint32_t bits) override;
    bool captures() const;
    void capture(double count);

    stm32f405::CaptureRegisters block_{};
    std::uint32_t control_{0}, option_{0}, mode_{0}, enable_{0}, status_{0}, captured_{0};
    double count_{0};  ///< present value of the timer's counter
    double edges_{0};  ///< edges of the oscillator since the last capture
    bool before_read_{false};
};

}  // namespace canproof::test
