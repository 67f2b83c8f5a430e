// SPDX-License-Identifier: Apache-2.0
// The flash with a program image and its seal (a CRC over the image). Tests of the self-test invert bits of this flash.
#pragma once

#include <vector>

#include "firmware/base/bytes.hpp"
#include "tests/support/crc32_by_definition.hpp"

namespace canproof::test {

class SealedFlash {
  public:
    /// Makes an image of `vectors` bytes of vectors and `code` bytes of code; the seal (four bytes) follows the code.
    SealedFlash(std::size_t vectors, std::size_t code) : vectors_{vectors} {
        for (std::size_t i = 0; i < vectors + code; ++i) {
            bytes_.push_back(static_cast<std::uint8_t>(i * 37 + 11));
        }
        const std::uint32_t seal = crc32_by_definition(bytes_);
        for (std::uint32_t shift = 0; shift < 32; shift += 8) {
            bytes_.push_back(static_cast<std::uint8_t>(seal >> shift));
        }
    }

    ByteView vectors() const { return {bytes_.data(), vectors_}; }
    ByteView image() const { return {bytes_.data() + vectors_, bytes_.size() - vectors_}; }
    std::size_t size() const { return bytes_.size(); }
    void turn(std::size_t at, std::uint32_t bit) { bytes_.at(at) ^= static_cast<std::uint8_t>(1U << bit); }

  private:
    std::size_t vectors_;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace canproof::test
