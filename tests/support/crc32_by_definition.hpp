// SPDX-License-Identifier: Apache-2.0
// The CRC-32 of ISO-HDLC computed by its definition, for expected values of tests.
#pragma once

#include <cstdint>
#include <vector>

namespace canproof::test {

/// Returns the remainder of the division by the polynomial 04C11DB7h, inverted. The lowest bit of each byte comes
/// first.
inline std::uint32_t crc32_by_definition(const std::vector<std::uint8_t>& bytes) {
    std::uint32_t remainder = 0xFFFFFFFF;
    for (const std::uint8_t byte : bytes) {
        for (std::uint32_t bit = 0; bit < 8; ++bit) {
            const std::uint32_t carry = (remainder >> 31U) ^ (byte >> bit & 1U);
            remainder = (remainder << 1U) ^ (carry != 0 ? 0x04C11DB7U : 0);
        }
    }
    std::uint32_t reflected = 0;
    for (std::uint32_t bit = 0; bit < 32; ++bit) {
        reflected |= (remainder >> bit & 1U) << (31 - bit);
    }
    return ~reflected;
}

}  // namespace canproof::test
