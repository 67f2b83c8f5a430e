// SPDX-License-Identifier: Apache-2.0
// A CAN controller of the STM32F405: the functions for the device's main loop and for its interrupt.
#pragma once

#include "target/stm32f405/can_controller.hpp"
#include "target/stm32f405/can_receiver.hpp"
#include "target/stm32f405/can_transmitter.hpp"
#include "target/stm32f405/receive_ring.hpp"

namespace canproof::stm32f405 {

class Bxcan {
  public:
    /// `clock_hz` is the clock of APB1.
    Bxcan(BxcanRegisters& registers, const std::uint32_t clock_hz) noexcept
        : controller_{registers, clock_hz}, receiver_{registers}, transmitter_{registers} {}

    /// Leaves the bus, drops the frames in the mailboxes and joins again at `bit_rate` bit/s.
    void set_bit_rate(std::uint32_t bit_rate, Instant now) noexcept;
    std::uint32_t bit_rate() const noexcept { return controller_.bit_rate(); }

    /// Advances the controller and moves frames from the queue to the mailboxes.
    void advance(TransmitQueue& queue, Instant now) noexcept;
    CanState state() const noexcept { return controller_.state(); }
    bool is_on_bus() const noexcept { return controller_.is_on_bus(); }

    /// Moves all frames of the FIFOs to the ring buffer. The interrupt calls it.
    void drain() noexcept;
    /// Takes the oldest frame of the ring buffer; returns false when there is none. The main loop calls it.
    bool receive(Frame& frame) noexcept { return ring_.pop(frame); }
    /// Returns whether a frame was lost since the last call because a FIFO or the ring was full.
    bool take_overrun() noexcept { return ring_.take_overrun(); }
    void interrupt_on_frames(const bool enabled) noexcept { receiver_.interrupt_on_frames(enabled); }

  private:
    CanController controller_;
    CanReceiver receiver_;
    CanTransmitter transmitter_;
    ReceiveRing ring_{};
};

}  // namespace canproof::stm32f405
