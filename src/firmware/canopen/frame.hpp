// SPDX-License-Identifier: Apache-2.0
// A classic CAN frame (ISO 11898-1: up to eight data bytes).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/base/bytes.hpp"

namespace canproof {

constexpr std::size_t max_frame_length = 8U;

struct Frame {
    std::uint32_t id{0U};  ///< 11-bit identifier 0…7FFh, or 29-bit when `extended`
    bool extended{false};
    bool remote{false};       ///< RTR: requests the frame, carries no data
    std::uint8_t length{0U};  ///< DLC, 0…8
    /// Aligned, so that the data are moved as one word.
    alignas(std::uint64_t) std::array<std::uint8_t, max_frame_length> data{};

    /// Returns whether this is a data frame with an 11-bit identifier.
    bool is_plain() const noexcept { return ((extended ? 1U : 0U) | (remote ? 1U : 0U)) == 0U; }
    ByteView payload() const noexcept { return ByteView{data.data(), remote ? std::size_t{0U} : std::size_t{length}}; }
};

/// Returns a data frame with `length` (0…8) zero bytes.
inline Frame data_frame(const std::uint32_t id, const std::uint8_t length) noexcept {
    Frame frame{};
    frame.id = id;
    frame.length = length;
    return frame;
}
/// Makes `frame` a data frame with the low `length` (0…8) bytes of `data`; the lowest byte is sent first. The other
/// bytes of `data` must be zero.
inline void set_data_frame(Frame& frame, const std::uint32_t id, const std::uint8_t length,
                           const std::uint64_t data) noexcept {
    frame.id = id;
    frame.extended = false;
    frame.remote = false;
    frame.length = length;
    set_field_le<0U, max_frame_length>(frame.data, data);
}
/// Returns the data frame that set_data_frame() makes of these values.
inline Frame data_frame(const std::uint32_t id, const std::uint8_t length, const std::uint64_t data) noexcept {
    Frame frame{};
    set_data_frame(frame, id, length, data);
    return frame;
}

}  // namespace canproof
