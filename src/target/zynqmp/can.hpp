// SPDX-License-Identifier: Apache-2.0
// A CAN controller of the Zynq UltraScale+ with the functions that a device's main loop calls (target/can_port.hpp).
// Frames leave through TXHPB, which holds one frame, and arrive in RXFIFO, which holds 64 frames (UG1085, "TX
// Messages", "RX Messages"). 64 of the shortest frames take 3 ms at 1 Mbit/s, so the main loop can read them in time
// without an interrupt.
#pragma once

#include "firmware/canopen/transmit_queue.hpp"
#include "target/zynqmp/can_controller.hpp"

namespace canproof::zynqmp {

class Can {
  public:
    /// `clock_hz`: CAN_REF_CLK.
    Can(CanRegisters& registers, const std::uint32_t clock_hz) noexcept
        : registers_{registers}, controller_{registers, clock_hz} {}

    /// Leaves the bus, drops the frame that waits in the controller and joins again at `bit_rate` bit/s.
    void set_bit_rate(const std::uint32_t bit_rate, const Instant now) noexcept {
        controller_.set_bit_rate(bit_rate, now);
    }
    std::uint32_t bit_rate() const noexcept { return controller_.bit_rate(); }

    /// Advances the controller and moves frames from the queue to it.
    void advance(TransmitQueue& queue, Instant now) noexcept;
    CanState state() const noexcept { return controller_.state(); }
    bool is_on_bus() const noexcept { return controller_.is_on_bus(); }

    /// Takes the oldest received frame. Returns false when there is none.
    bool receive(Frame& frame) noexcept;
    /// Returns whether a frame was lost since the last call because RXFIFO was full.
    bool take_overrun() noexcept;

  private:
    void send(const Frame& frame) noexcept;

    CanRegisters& registers_;
    CanController controller_;
};

}  // namespace canproof::zynqmp
