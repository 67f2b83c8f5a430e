// SPDX-License-Identifier: Apache-2.0
// The flash with a program image and its seal (a CRC over the image). Tests of the self-test invert bits of this flash.
#pragma once

#include <vector>

#include "firmware/base/bytes.hpp"

namespace canproof::test {

class SealedFlash {
  public:
    /// Makes an image of `vectors` bytes of vectors and `code` bytes of code; the seal (four bytes) follows the code.
    SealedFlash(std::size_t vectors, std::size_t code) : vectors_{vectors} {
        for (std::size_t i = 0; i < vectors + code; ++i) {
            bytes_.push_back(static_cast<std::uint8_t>(i * 37 + 11));
        }
        const std::uint32_t seal = crc();
        for (std::uint32_t shift = 0; shift < 32; shift += 8) {
            bytes_.push_back(static_cast<std::uint8_t>(seal >> shift));
        }
    }

    ByteView vectors() const { return {bytes_.data(), vectors_}; }
    ByteView image() const { return {bytes_.data() + vectors_, bytes_.size() - vectors_}; }
    std::size_t size() const { return bytes_.size(); }
    void turn(std::size_t at, std::uint32_t bit) { bytes_.at(at) ^= static_cast<std::uint8_t>(1U << bit); }

  private:
    /// Returns the CRC-32 of ISO-HDLC computed by its definition: the remainder of the division by the polynomial
    /// 04C11DB7h. The lowest bit of each byte comes first.
    std::uint32_t crc() const {
        std::uint32_t remainder = 0xFFFFFFFF;
        for (const std::uint8_t byte : bytes_) {
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

    std::size_t vectors_;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace canproof::test
