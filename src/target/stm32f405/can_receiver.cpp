// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/can_receiver.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

constexpr std::uint32_t half_of_time = 0x8000U;
constexpr std::uint32_t time_mask = 0xFFFFU;

Frame read_frame(const Mailbox& mailbox) noexcept {
    const std::uint32_t identifier = mailbox.identifier.read();
    const std::uint32_t length = mailbox.length.read() & dtr::length;
    Frame frame{};
    frame.extended = (identifier & ir::extended) != 0U;
    frame.remote = (identifier & ir::remote) != 0U;
    frame.id = identifier >> (frame.extended ? ir::extended_shift : ir::standard_shift);
    // A length code of 9 to 15 means eight bytes (ISO 11898-1).
    frame.length = static_cast<std::uint8_t>((length < max_frame_length) ? length : max_frame_length);
    set_field_le<0U, 4U>(frame.data, mailbox.data_low.read());
    set_field_le<4U, 4U>(frame.data, mailbox.data_high.read());
    return frame;
}

}  // namespace

/// Returns the FIFO with the older frame. The time stamps wrap after 65,536 bits; the two frames are closer together,
/// because the handler runs sooner.
std::size_t CanReceiver::oldest(const std::uint32_t pending_0, const std::uint32_t pending_1) const noexcept {
    if ((pending_0 == 0U) || (pending_1 == 0U)) {
        return (pending_0 == 0U) ? 1U : 0U;
    }
    const std::uint32_t time_0 = registers_.receive[0U].length.read() >> dtr::time_shift;
    const std::uint32_t time_1 = registers_.receive[1U].length.read() >> dtr::time_shift;
    return (((time_1 - time_0) & time_mask) < half_of_time) ? 0U : 1U;
}

static_assert(implements<req::CO_CAN_004> && implements<req::CO_CAN_005>);
bool CanReceiver::receive(Frame& frame) noexcept {
    const std::uint32_t status_0 = registers_.receive_fifo[0U].read();
    const std::uint32_t status_1 = registers_.receive_fifo[1U].read();
    if (((status_0 | status_1) & rfr::overrun) != 0U) {
        overrun_ = true;
        registers_.receive_fifo[0U].write(status_0 & rfr::overrun);  // writing 1 clears the flag
        registers_.receive_fifo[1U].write(status_1 & rfr::overrun);
    }
    const std::uint32_t pending_0 = status_0 & rfr::pending;
    const std::uint32_t pending_1 = status_1 & rfr::pending;
    const bool is_releasing = ((status_0 | status_1) & rfr::release) != 0U;
    if (is_releasing || ((pending_0 | pending_1) == 0U)) {
        return false;
    }
    const std::size_t fifo = oldest(pending_0, pending_1);
    frame = read_frame(registers_.receive[fifo]);
    registers_.receive_fifo[fifo].write(rfr::release);
    return true;
}

static_assert(implements<req::CO_CAN_005>);
bool CanReceiver::take_overrun() noexcept {
    const bool lost = overrun_;
    overrun_ = false;
    return lost;
}

void CanReceiver::interrupt_on_frames(const bool enabled) noexcept {
    registers_.interrupt_enable.write(enabled ? (ier::pending_0 | ier::pending_1) : 0U);
}

}  // namespace canproof::stm32f405
