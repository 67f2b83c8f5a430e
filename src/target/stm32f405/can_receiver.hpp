// SPDX-License-Identifier: Apache-2.0
// Reception with bxCAN: two FIFOs of three frames, read in the order in which the frames arrived (RM0090 32.7.3,
// 32.9.3).
#pragma once

#include "firmware/canopen/frame.hpp"
#include "target/stm32f405/bxcan_registers.hpp"

namespace canproof::stm32f405 {

class CanReceiver {
  public:
    explicit CanReceiver(BxcanRegisters& registers) noexcept : registers_{registers} {}

    /// Takes the oldest frame out of the FIFOs. Returns false when there is none, or while the hardware still releases
    /// the place of the last one.
    bool receive(Frame& frame) noexcept;
    /// Returns whether frames were lost since the last call because a FIFO was full.
    bool take_overrun() noexcept;
    /// Sets whether received frames raise an interrupt.
    void interrupt_on_frames(bool enabled) noexcept;

  private:
    std::size_t oldest(std::uint32_t pending_0, std::uint32_t pending_1) const noexcept;

    BxcanRegisters& registers_;
    bool overrun_{false};
};

}  // namespace canproof::stm32f405
