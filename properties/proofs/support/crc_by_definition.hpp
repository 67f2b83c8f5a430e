// SPDX-License-Identifier: Apache-2.0
// CRC-16 and CRC-32 by the definition of a cyclic redundancy check, one bit at a time.
#pragma once

#include <cstdint>

namespace canproof::proofs {

/// Adds one byte to a 16-bit CRC: polynomial 1021h, most significant bit first.
inline std::uint16_t crc16_by_definition(const std::uint16_t state, const std::uint8_t byte) {
    std::uint32_t remainder = state;
    for (std::uint32_t bit = 8U; bit > 0U; --bit) {
        const std::uint32_t in = (std::uint32_t{byte} >> (bit - 1U)) & 1U;
        const std::uint32_t out = (remainder >> 15U) & 1U;
        remainder = ((remainder << 1U) & 0xFFFFU) ^ ((in ^ out) * 0x1021U);
    }
    return static_cast<std::uint16_t>(remainder);
}

inline std::uint32_t reversed(const std::uint32_t word) {
    std::uint32_t result{0U};
    for (std::uint32_t bit = 0U; bit < 32U; ++bit) {
        result |= ((word >> bit) & 1U) << (31U - bit);
    }
    return result;
}

/// Adds one byte to a 32-bit CRC: polynomial 04C11DB7h, most significant bit first, with the bits of the byte and of
/// the CRC mirrored.
inline std::uint32_t crc32_by_definition(const std::uint32_t state, const std::uint8_t byte) {
    std::uint32_t remainder = reversed(state);
    for (std::uint32_t bit = 0U; bit < 8U; ++bit) {
        const std::uint32_t in = (std::uint32_t{byte} >> bit) & 1U;
        const std::uint32_t out = remainder >> 31U;
        remainder = (remainder << 1U) ^ ((in ^ out) * 0x04C11DB7U);
    }
    return reversed(remainder);
}

}  // namespace canproof::proofs
