// A CAN controller of the STM32F405 as the device's main loop and its interrupt see it.
#pragma once

#include "target/stm32f405/can_controller.hpp"
#include "target/stm32f405/can_receiver.hpp"
#include "target/stm32f405/can_transmitter.hpp"
#include "target/stm32f405/receive_ring.hpp"

namespace canproof::stm32f405 {

class Bxcan {
  public:
    /// `clock_hz`: that of APB1.
    Bxcan(BxcanRegisters& registers, const std::uint32_t clock_hz) noexcept
        : controller_{registers, clock_hz}, receiver_{registers}, transmitter_{registers} {}

    /// Leaves the bus, forgets what was to be sent, joins again at `bit_rate` bit/s.
    void set_bit_rate(std::uint32_t bit_rate, Instant now) noexcept;
    std::uint32_t bit_rate() const noexcept { return controller_.bit_rate(); }

    /// The next steps of the controller; frames from the queue to the mailboxes.
    void advance(TransmitQueue& queue, Instant now) noexcept;
    CanState state() const noexcept { return controller_.state(); }
    bool is_on_bus() const noexcept { return controller_.is_on_bus(); }

    /// For the interrupt: all that the FIFOs hold goes to the ring.
    void drain() noexcept;
    /// For the main loop: the oldest frame of the ring; false when there is none.
    bool receive(Frame& frame) noexcept { return ring_.pop(frame); }
    /// Whether a FIFO or the ring had no room for a frame since the last call.
    bool take_overrun() noexcept { return ring_.take_overrun(); }
    void interrupt_on_frames(const bool enabled) noexcept { receiver_.interrupt_on_frames(enabled); }

  private:
    CanController controller_;
    CanReceiver receiver_;
    CanTransmitter transmitter_;
    ReceiveRing ring_{};
};

}  // namespace canproof::stm32f405
