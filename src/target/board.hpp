// SPDX-License-Identifier: Apache-2.0
// The smallest board on which a device can run, for measurements. Its clock, CAN mailboxes and signals lie in one
// memory-mapped window, its parameter memory in another (two static memory banks of the STM32F405's FSMC). A real board
// replaces this file by drivers; measurements cover only the device and the main loop of this file.
#pragma once

#include "firmware/base/non_volatile_memory.hpp"
#include "firmware/base/time.hpp"
#include "firmware/canopen/node.hpp"

namespace canproof::target {

/// FSMC bank 1, NOR/SRAM 1: FRAM with the stored parameters.
constexpr std::uintptr_t parameter_memory = 0x60000000U;
/// FSMC bank 1, NOR/SRAM 2: clock, CAN mailboxes and signals.
constexpr std::uintptr_t window = 0x64000000U;

/// Parameter memory of `Size` bytes.
template <std::size_t Size>
class MappedMemory final : public NonVolatileMemory {
  public:
    MappedMemory() = default;
    std::size_t size() const override { return Size; }
    bool read(const std::size_t at, MutableBytes to) const override {
        const bool inside = (at <= Size) && (to.size() <= (Size - at));
        for (std::size_t i = 0U; inside && (i < to.size()); ++i) {
            to.set(i, bytes()[at + i]);
        }
        return inside;
    }
    bool write(const std::size_t at, const ByteView from) override {
        const bool inside = (at <= Size) && (from.size() <= (Size - at));
        for (std::size_t i = 0U; inside && (i < from.size()); ++i) {
            bytes()[at + i] = from[i];
        }
        return inside;
    }
    /// Returns true and does nothing else, because each byte written to FRAM is permanent.
    bool commit() override { return true; }

  private:
    static volatile std::uint8_t* bytes() { return reinterpret_cast<volatile std::uint8_t*>(parameter_memory); }
};

/// A CAN mailbox: the sender sets `full`, the receiver clears it.
struct Mailbox {
    volatile std::uint32_t full;
    volatile std::uint32_t id;
    volatile std::uint32_t flags;  ///< bit 31 extended, bit 30 remote, bits 0 to 3 DLC
    volatile std::uint8_t data[max_frame_length];
};

template <typename Inputs, typename Outputs>
struct Window {
    volatile std::uint32_t microseconds_high;
    volatile std::uint32_t microseconds_low;
    Mailbox received;
    Mailbox sent;
    Inputs inputs;
    Outputs outputs;
};

inline Frame take(Mailbox& box) {
    Frame frame{};
    frame.id = box.id;
    frame.extended = (box.flags & 0x80000000U) != 0U;
    frame.remote = (box.flags & 0x40000000U) != 0U;
    frame.length = static_cast<std::uint8_t>(box.flags & 0xFU);
    for (std::size_t i = 0U; i < max_frame_length; ++i) {
        frame.data[i] = box.data[i];
    }
    box.full = 0U;
    return frame;
}

inline void put(Mailbox& box, const Frame& frame) {
    box.id = frame.id;
    box.flags = (frame.extended ? 0x80000000U : 0U) | (frame.remote ? 0x40000000U : 0U) | frame.length;
    for (std::size_t i = 0U; i < max_frame_length; ++i) {
        box.data[i] = frame.data[i];
    }
    box.full = 1U;
}

/// The RAM, in bytes, of the protocol layer and of the values of the dictionary. The image contains these numbers for
/// src/target/footprint, which cannot find them elsewhere in it.
struct Footprint {
    std::uint32_t node;
    std::uint32_t values;
};
template <const DictionaryTables& Tables>
constexpr Footprint footprint{
    sizeof(Node) + sizeof(ObjectDictionary) + sizeof(PdoMemoryFor<Tables>) + sizeof(TransmitQueue),
    Tables.defaults.count};

/// Powers the device on, then repeats: read inputs, receive at most one frame, do what is due, send at most one frame,
/// write outputs.
template <typename Device, typename Inputs, typename Outputs>
[[noreturn]] void run(Device& device, TransmitQueue& queue) {
    auto& board = *reinterpret_cast<Window<Inputs, Outputs>*>(window);
    const auto now = [&board]() {
        return Instant{(std::uint64_t{board.microseconds_high} << 32U) | board.microseconds_low};
    };
    device.power_on(board.inputs, now());
    for (;;) {
        asm volatile("" ::: "memory");  // the board changes the contents of the window between two passes
        device.set_inputs(board.inputs, now());
        if (board.received.full != 0U) {
            device.receive(take(board.received), now());
        }
        if (device.next_deadline() <= now()) {
            device.advance(now());
        }
        if ((board.sent.full == 0U) && !queue.empty()) {
            put(board.sent, queue.pop());
        }
        board.outputs = device.outputs();
    }
}

}  // namespace canproof::target
