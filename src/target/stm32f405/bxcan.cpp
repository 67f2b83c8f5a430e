// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/bxcan.hpp"

namespace canproof::stm32f405 {

void Bxcan::set_bit_rate(const std::uint32_t bit_rate, const Instant now) noexcept {
    controller_.set_bit_rate(bit_rate, now);
    transmitter_.forget();
}

void Bxcan::advance(TransmitQueue& queue, const Instant now) noexcept {
    controller_.advance(now);
    if (!controller_.is_on_bus()) {
        // the controller joins the bus; before, set_bit_rate() or the bus-off has emptied the mailboxes
    } else if (controller_.state() == CanState::bus_off) {
        transmitter_.give_back(queue);
    } else {
        transmitter_.serve(queue);
    }
}

void Bxcan::drain() noexcept {
    Frame frame{};
    bool any{true};
    // Twice the depth of both FIFOs: frames may arrive while the loop runs.
    for (std::size_t count = 0U; count < (2U * fifo_count * fifo_depth); ++count) {
        if (any) {
            any = receiver_.receive(frame);
        }
        if (any) {
            ring_.push(frame);
        }
    }
    if (receiver_.take_overrun()) {
        ring_.note_overrun();
    }
}

}  // namespace canproof::stm32f405
