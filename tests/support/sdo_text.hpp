// SPDX-License-Identifier: Apache-2.0
// SDO data for tests: bytes, their CRC (computed bit by bit as in CiA 301, 7.2.4.3.16), and the SDO segments that carry
// these bytes.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

namespace canproof::test {

using Bytes = std::vector<std::uint8_t>;

/// Returns `count` bytes: `first`, `first` + 1, and so on. After FFh comes 00h.
inline Bytes counting(std::size_t count, std::uint8_t first = 1) {
    Bytes bytes;
    for (std::size_t i = 0; i < count; ++i) {
        bytes.push_back(static_cast<std::uint8_t>(first + i));
    }
    return bytes;
}

/// Computes the CRC with the polynomial x^16 + x^12 + x^5 + 1 and the start value 0, one bit at a time.
inline std::uint16_t crc16_bit_by_bit(const Bytes& bytes) {
    unsigned crc = 0;
    for (const std::uint8_t byte : bytes) {
        for (int bit = 7; bit >= 0; --bit) {
            const unsigned carry = ((crc >> 15) ^ (byte >> bit)) & 1U;
            crc = ((crc << 1) & 0xFFFFU) ^ (carry * 0x1021U);
        }
    }
    return static_cast<std::uint16_t>(crc);
}

inline std::string hex_bytes(const Bytes& bytes, std::size_t from, std::size_t count, std::size_t width) {
    std::string text;
    for (std::size_t i = 0; i < width; ++i) {
        text += fmt::format("{:02X}", i < count && from + i < bytes.size() ? bytes[from + i] : 0);
    }
    return text;
}

/// Returns a number as hexadecimal digits, least significant byte first.
inline std::string hex_le(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) {
        text += fmt::format("{:02X}", (value >> (8 * i)) & 0xFF);
    }
    return text;
}

/// Returns the block segment `sequence` with the seven bytes from `from` on. Bit 7 of its first byte marks the last
/// segment.
inline std::string block_segment(const std::string& id, unsigned sequence, const Bytes& bytes, std::size_t from) {
    const bool last = from + 7 >= bytes.size();
    return id + "#" + hex_le(sequence | (last ? 0x80U : 0U), 1) + hex_bytes(bytes, from, 7, 7);
}

/// Returns the frame that ends the block transfer of `bytes`: `C1h | unused << 2` and the CRC. Client and server both
/// use this form.
inline std::string block_end(const std::string& id, const Bytes& bytes) {
    const unsigned unused = bytes.empty() ? 7U : static_cast<unsigned>((7 - bytes.size() % 7) % 7);
    return id + "#" + hex_le(0xC1U | (unused << 2U), 1) + hex_le(crc16_bit_by_bit(bytes), 2) + "0000000000";
}

}  // namespace canproof::test
