// SPDX-License-Identifier: Apache-2.0
// The three mailboxes of bxCAN, filled from a transmit queue (RM0090 32.7.1, 32.9.3). They hold the most urgent frames;
// the hardware sends the lowest identifier first, and among equal identifiers the lowest mailbox.
#pragma once

#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "target/stm32f405/bxcan_registers.hpp"

namespace canproof::stm32f405 {

class CanTransmitter {
  public:
    explicit CanTransmitter(BxcanRegisters& registers) noexcept : registers_{registers} {}

    /// Frees the mailboxes of sent frames and fills them from the queue. If all three are full and a frame is more
    /// urgent, it replaces the least urgent one, which goes back to the queue unless it is already on the bus.
    void serve(TransmitQueue& queue) noexcept;
    /// Empties the mailboxes when the controller is bus-off: each frame that was not sent goes back to the queue. The
    /// node then takes the emergency messages from the queue, before it drops all other frames.
    void give_back(TransmitQueue& queue) noexcept;
    /// Forgets the frames in the mailboxes, after the controller has restarted and aborted them.
    void forget() noexcept;
    /// Returns the number of frames that the hardware has not sent yet.
    std::size_t waiting() const noexcept;

  private:
    struct Slot {
        Frame frame{};
        bool busy{false};
        bool aborting{false};
        bool unwanted{false};  ///< aborted and not to be sent again
    };

    void collect(TransmitQueue& queue) noexcept;
    void exchange(std::size_t mailbox, TransmitQueue& queue) noexcept;
    bool place_next(TransmitQueue& queue) noexcept;
    bool make_room(std::uint32_t id, TransmitQueue& queue) noexcept;
    std::size_t place_for(std::uint32_t id) const noexcept;
    std::size_t least_urgent() const noexcept;
    void drop_all() noexcept;
    void abort(std::size_t mailbox) noexcept;
    void request(std::size_t mailbox) noexcept;

    BxcanRegisters& registers_;
    std::array<Slot, mailbox_count> slots_{};
    bool is_alone_{false};  ///< the boot-up message is in a mailbox: no frame may overtake it
};

}  // namespace canproof::stm32f405
