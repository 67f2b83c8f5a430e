// SPDX-License-Identifier: Apache-2.0
#include "target/zynqmp/can.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::zynqmp {

namespace {

/// Returns four bytes from `First` on as a word of the controller, the first byte in the highest bits.
template <std::size_t First>
std::uint32_t word_of(const Frame& frame) noexcept {
    return (std::uint32_t{frame.data[First]} << 24U) | (std::uint32_t{frame.data[First + 1U]} << 16U) |
           (std::uint32_t{frame.data[First + 2U]} << 8U) | std::uint32_t{frame.data[First + 3U]};
}

template <std::size_t First>
void set_bytes(Frame& frame, const std::uint32_t word) noexcept {
    frame.data[First] = static_cast<std::uint8_t>(word >> 24U);
    frame.data[First + 1U] = static_cast<std::uint8_t>((word >> 16U) & 0xFFU);
    frame.data[First + 2U] = static_cast<std::uint8_t>((word >> 8U) & 0xFFU);
    frame.data[First + 3U] = static_cast<std::uint8_t>(word & 0xFFU);
}

std::uint32_t identifier_word(const Frame& frame) noexcept {
    if (frame.extended) {
        const std::uint32_t high = frame.id >> idr::low_bits;
        const std::uint32_t low = frame.id & idr::low_mask;
        return (high << idr::high_shift) | idr::remote_standard | idr::extended | (low << idr::low_shift) |
               (frame.remote ? idr::remote_extended : 0U);
    }
    return (frame.id << idr::high_shift) | (frame.remote ? idr::remote_standard : 0U);
}

void set_identifier(Frame& frame, const std::uint32_t word) noexcept {
    const std::uint32_t high = word >> idr::high_shift;
    frame.extended = (word & idr::extended) != 0U;
    if (frame.extended) {
        frame.id = (high << idr::low_bits) | ((word >> idr::low_shift) & idr::low_mask);
        frame.remote = (word & idr::remote_extended) != 0U;
    } else {
        frame.id = high;
        frame.remote = (word & idr::remote_standard) != 0U;
    }
}

}  // namespace

/// Gives the controller a frame whenever its buffer is free. All other frames wait in the queue, which sorts them by
/// identifier. The size of the queue bounds the loop, so that it also ends when the hardware sends at once.
static_assert(implements<req::CO_ZCAN_008>);
void Can::advance(TransmitQueue& queue, const Instant now) noexcept {
    controller_.advance(now);
    const bool is_on = controller_.is_on_bus();
    for (std::size_t count = 0U; count < TransmitQueue::capacity; ++count) {
        if (is_on && !queue.empty() && !registers_.status.has(sr::first_full)) {
            send(queue.pop());
        }
    }
}

void Can::send(const Frame& frame) noexcept {
    FrameRegisters& buffer = registers_.transmit_first;
    buffer.identifier.write(identifier_word(frame));
    buffer.length.write(std::uint32_t{frame.length} << length_shift);
    buffer.data_1.write(word_of<0U>(frame));
    buffer.data_2.write(word_of<4U>(frame));
}

/// Reads the four words of the oldest frame; each read takes the word out of the FIFO. RXNEMP stays set until it is
/// cleared, and is set again at once while another frame waits (UG1087, ISR).
static_assert(implements<req::CO_ZCAN_006> && implements<req::CO_ZCAN_009> && implements<req::CO_ZCAN_012>);
bool Can::receive(Frame& frame) noexcept {
    if (!registers_.interrupt_status.has(isr::not_empty)) {
        return false;
    }
    FrameRegisters& fifo = registers_.receive_fifo;
    const std::uint32_t identifier = fifo.identifier.read();
    const std::uint32_t length = fifo.length.read() >> length_shift;
    const std::uint32_t data_1 = fifo.data_1.read();
    const std::uint32_t data_2 = fifo.data_2.read();
    registers_.interrupt_clear.write(isr::not_empty);
    set_identifier(frame, identifier);
    // A length code of 9 to 15 means eight bytes (ISO 11898-1).
    frame.length = static_cast<std::uint8_t>((length < max_frame_length) ? length : max_frame_length);
    set_bytes<0U>(frame, data_1);
    set_bytes<4U>(frame, data_2);
    return true;
}

static_assert(implements<req::CO_ZCAN_012>);
bool Can::take_overrun() noexcept {
    const bool lost = registers_.interrupt_status.has(isr::overrun);
    if (lost) {
        registers_.interrupt_clear.write(isr::overrun);
    }
    return lost;
}

}  // namespace canproof::zynqmp
