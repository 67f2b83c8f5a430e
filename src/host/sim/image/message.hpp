// SPDX-License-Identifier: Apache-2.0
// Messages between this program and a device's image on the microcontroller (src/target/bridge). A message is its
// length in two bytes, its kind, and values in the order of the bus, the least significant byte first. A frame is its
// identifier (u32), flags (u8: 1 extended, 2 remote), length (u8) and eight bytes.
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

/// First value of an image's greeting. Another value means another protocol.
constexpr std::uint32_t protocol = 0x31504243U;  // "CBP1"
/// Bytes of stored parameters that one message carries at most.
constexpr std::size_t most_memory_bytes = 512U;

enum class Kind : std::uint8_t {
    // From the image.
    greeting,  ///< protocol, number of inputs and of outputs (u8 each), length of the device's name (u8), its
               ///< characters
    state,  ///< after each command: next deadline (u64), node-ID and NMT state (u8 each), bit rate (u32), whether the
            ///< boot-up message waits (u8), number of frames that wait (u8), these, outputs (f64 each)
    read,   ///< stored parameters: address (u32), count (u16)
    write,  ///< address (u32), count (u16), the bytes
    commit,
    // From the host. Each command begins with the number (u8) of frames that went out since the last state.
    begin,       ///< answers the greeting: size of the parameter memory (u32)
    power_on,    ///< time (u64), inputs (f64 each)
    receive,     ///< time, frame
    set_inputs,  ///< time, inputs
    advance,     ///< time
    look,        ///< only the state
    stored       ///< answers read, write and commit: whether it was done (u8); after a read the bytes
};

/// One message, to be written or read. A value that does not fit, or a read past the end, only makes the message
/// unsound.
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
    /// Returns and removes the next value; zero when there is none.
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
    /// Returns and removes the next `count` bytes; none when there are fewer. They are valid as long as the message.
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

    /// Returns the bytes to send: the length, then the values that were put.
    ByteView sent() {
        store_le<head>(bytes_.data(), end_ - head);
        return ByteView{bytes_.data(), end_};
    }
    /// Returns the buffer into which a message is read: first `head` bytes, then as many bytes as expected() returns.
    std::uint8_t* buffer() { return bytes_.data(); }
    /// Returns the number of bytes behind the head; 0 when the head is invalid.
    std::size_t expected() const {
        const std::uint64_t length = load_le<head>(bytes_.data());
        return (length <= (capacity - head)) ? static_cast<std::size_t>(length) : 0U;
    }
    /// Ends the reading of the message: take() begins behind the kind.
    void filled() {
        end_ = head + expected();
        at_ = head + sizeof(Kind);
        sound_ = end_ >= at_;
    }

  private:
    /// Each pattern of bits is a valid value.
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
