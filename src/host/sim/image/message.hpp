// SPDX-License-Identifier: Apache-2.0
// Messages between this program and a device's image on the microcontroller (src/target/bridge). A message consists of
// its length in two bytes, its kind, and values. Values are in the byte order of the bus: the least significant byte
// first. A frame is its identifier (u32), flags (u8: 1 extended, 2 remote), length (u8) and eight bytes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "firmware/base/bytes.hpp"
#include "firmware/canopen/frame.hpp"

namespace canproof::bridge {

/// First value of an image's greeting. An image with another value uses another protocol.
constexpr std::uint32_t protocol = 0x31504243U;  // the characters "CBP1"
/// First value of the greeting of an image that has its own clock. Such an image acts at its own times, which are not
/// before those of the commands.
constexpr std::uint32_t protocol_of_own_clock = 0x31434243U;  // the characters "CBC1"
/// Greatest number of bytes of stored parameters in one message.
constexpr std::size_t most_memory_bytes = 512U;

enum class Kind : std::uint8_t {
    // Messages from the image.
    /// protocol, number of inputs and of outputs (u8 each), length of the device's name (u8), its characters
    greeting,
    /// after each command: next deadline (u64), node-ID and NMT state (u8 each), bit rate (u32). Then: whether the
    /// boot-up message waits (u8), number of waiting frames (u8), these frames, outputs (f64 each)
    state,
    read,   ///< requests stored parameters: address (u32), count (u16)
    write,  ///< sends parameters to store: address (u32), count (u16), the bytes
    commit,
    // Messages from the host. The commands from power_on to look begin with the number (u8) of frames that were sent
    // since the last state.
    begin,       ///< answers the greeting: size of the parameter memory (u32)
    power_on,    ///< time (u64), inputs (f64 each)
    receive,     ///< time, frame
    set_inputs,  ///< time, inputs
    advance,     ///< time
    look,        ///< requests only the state
    stored       ///< answers read, write and commit: whether this succeeded (u8); after a read also the bytes
};

/// One message that is written or read. A value that does not fit, or a read beyond the end, makes the message invalid
/// and has no other effect.
class Message {
  public:
    static constexpr std::size_t head = 2U;
    static constexpr std::size_t capacity = 2048U;

    Message() = default;
    explicit Message(const Kind kind) { put(kind); }

    bool is_sound() const { return sound_; }
    Kind kind() const { return static_cast<Kind>(bytes_[head]); }

    /// Appends a number or an enumerator.
    template <typename Value>
    void put(const Value value) {
        static_assert(is_value<Value>);
        if (!has_room(sizeof(Value))) {
            return;
        }
        static_cast<void>(std::memcpy(&bytes_[end_], &value, sizeof(Value)));
        end_ += sizeof(Value);
    }
    /// Removes and returns the next value. Returns zero when there is none.
    template <typename Value>
    Value take() {
        static_assert(is_value<Value>);
        Value value{};
        if (has_left(sizeof(Value))) {
            static_cast<void>(std::memcpy(&value, &bytes_[at_], sizeof(Value)));
            at_ += sizeof(Value);
        }
        return value;
    }

    void put_bytes(const ByteView bytes) {
        if (has_room(bytes.size())) {
            static_cast<void>(std::copy_n(bytes.data(), bytes.size(), &bytes_[end_]));
            end_ += bytes.size();
        }
    }
    /// Removes and returns the next `count` bytes; none when there are fewer. The view is valid as long as the message
    /// exists.
    ByteView take_bytes(const std::size_t count) {
        const bool whole = has_left(count);
        const std::size_t from = at_;
        at_ += whole ? count : 0U;
        return whole ? ByteView{&bytes_[from], count} : ByteView{};
    }

    void put_frame(const Frame& frame) {
        put(frame.id);
        put(static_cast<std::uint8_t>((frame.extended ? 1U : 0U) | (frame.remote ? 2U : 0U)));
        put(frame.length);
        put_bytes(ByteView{frame.data});
    }
    Frame take_frame() {
        Frame frame{};
        frame.id = take<std::uint32_t>();
        const auto flags = take<std::uint8_t>();
        frame.extended = (flags & 1U) != 0U;
        frame.remote = (flags & 2U) != 0U;
        frame.length = take<std::uint8_t>();
        MutableBytes{frame.data}.copy(0U, take_bytes(max_frame_length));
        return frame;
    }

    /// Returns the bytes to send: the length, and then the values that were put.
    ByteView sent() {
        store_le<head>(bytes_.data(), end_ - head);
        return ByteView{bytes_.data(), end_};
    }
    /// Returns the buffer for reading a message. The caller first reads `head` bytes, then as many bytes as expected()
    /// returns.
    std::uint8_t* buffer() { return bytes_.data(); }
    /// Returns the number of bytes after the head; 0 when the head is invalid.
    std::size_t expected() const {
        const std::uint64_t length = load_le<head>(bytes_.data());
        return (length <= (capacity - head)) ? static_cast<std::size_t>(length) : 0U;
    }
    /// Marks the message in the buffer as complete. take() then begins with the value after the kind.
    void filled() {
        end_ = head + expected();
        at_ = head + sizeof(Kind);
        sound_ = end_ >= at_;
    }

  private:
    /// True when each bit pattern is a valid value of the type.
    template <typename Value>
    static constexpr bool is_value =
        (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) || std::is_enum_v<Value>;

    bool has_room(const std::size_t count) {
        sound_ = sound_ && (count <= (capacity - end_));
        return sound_;
    }
    bool has_left(const std::size_t count) {
        sound_ = sound_ && (at_ <= end_) && (count <= (end_ - at_));
        return sound_;
    }

    std::array<std::uint8_t, capacity> bytes_{};
    std::size_t end_{head};
    std::size_t at_{head};
    bool sound_{true};
};

}  // namespace canproof::bridge
