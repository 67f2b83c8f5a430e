// SPDX-License-Identifier: Apache-2.0
// Naive PDOs by CiA 301 (7.4.7, 7.5.2.36, 7.5.2.38). A PDO is a row of bits that begins with the least significant bit
// of the first byte. The mapping assigns these bits to the mapped objects in turn. Shares no code with the firmware.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace canproof::naive_pdo {

using Bytes = std::vector<std::uint8_t>;
using Bits = std::vector<bool>;

/// One entry of a mapping: an object, or a dummy entry (an index below 1000h) that skips bits.
struct Mappable {
    unsigned index;
    unsigned subindex;
    unsigned bits;
};
using Mapping = std::vector<Mappable>;
using Values = std::map<std::pair<unsigned, unsigned>, std::uint64_t>;

inline bool is_gap(const Mappable& line) {
    return line.index < 0x1000;
}

inline unsigned total_bits(const Mapping& mapping) {
    unsigned bits = 0;
    for (const Mappable& line : mapping) {
        bits += line.bits;
    }
    return bits;
}

inline unsigned total_bytes(const Mapping& mapping) {
    return (total_bits(mapping) + 7) / 8;
}

inline Bits bits_of(const Bytes& bytes) {
    Bits bits;
    for (const std::uint8_t byte : bytes) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            bits.push_back(((byte >> bit) & 1U) != 0);
        }
    }
    return bits;
}

inline Bytes bytes_of(const Bits& bits) {
    Bytes bytes((bits.size() + 7) / 8);
    for (std::size_t i = 0; i < bits.size(); ++i) {
        bytes[i / 8] = static_cast<std::uint8_t>(bytes[i / 8] | (bits[i] ? 1U << (i % 8) : 0U));
    }
    return bytes;
}

/// Returns the data of a TPDO with this mapping and the values `values` (of type Values or a type with its interface).
template <typename AnyValues>
Bytes packed(const Mapping& mapping, AnyValues values) {
    Bits bits;
    for (const Mappable& line : mapping) {
        for (unsigned bit = 0; bit < line.bits; ++bit) {
            bits.push_back(((values[{line.index, line.subindex}] >> bit) & 1U) != 0);
        }
    }
    return bytes_of(bits);
}

/// Returns `values` as they are after the reception of an RPDO. All mapped values are set, or none if the frame is too
/// short or `fits(line, value)` is false for one of them.
template <typename AnyValues, typename Fits>
AnyValues received(const AnyValues& values, const Mapping& mapping, const Bytes& frame, const Fits& fits) {
    if (frame.size() < total_bytes(mapping)) {
        return values;
    }
    const Bits bits = bits_of(frame);
    AnyValues next = values;
    std::size_t at = 0;
    for (const Mappable& line : mapping) {
        std::uint64_t value = 0;
        for (unsigned bit = 0; bit < line.bits; ++bit, ++at) {
            value |= static_cast<std::uint64_t>(bits[at]) << bit;
        }
        if (is_gap(line)) {
            continue;
        }
        if (!fits(line, value)) {
            return values;
        }
        next[{line.index, line.subindex}] = value;
    }
    return next;
}

}  // namespace canproof::naive_pdo
