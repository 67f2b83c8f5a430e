// SPDX-License-Identifier: Apache-2.0
// Hashes the observations of a run into 64 bits. Works as FNV-1a does, but takes eight bytes at a time instead of one.
// Two runs have the same hash only when all observations were equal, apart from collisions.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

#include "firmware/base/bytes.hpp"

namespace canproof::fuzz {

class Digest {
  public:
    void add(ByteView bytes) {
        const std::uint8_t* at = bytes.data();
        std::size_t left = bytes.size();
        for (; left >= sizeof value_; left -= sizeof value_, at += sizeof value_) {
            std::uint64_t word = 0;
            std::memcpy(&word, at, sizeof word);
            add_word(word);
        }
        if (left != 0) {
            std::array<std::uint8_t, sizeof value_> rest{
                static_cast<std::uint8_t>(left)};  // the number of bytes, so that a byte 0 at the end changes the hash
            std::copy_n(at, left, rest.begin() + 1);
            std::uint64_t word = 0;
            std::memcpy(&word, rest.data(), sizeof word);
            add_word(word);
        }
    }
    template <typename Number>
    void add(Number number) {
        static_assert(std::is_arithmetic_v<Number>);
        std::uint8_t bytes[sizeof number];
        std::memcpy(bytes, &number, sizeof number);
        add(ByteView{bytes, sizeof number});
    }
    std::uint64_t value() const { return value_; }

  private:
    void add_word(std::uint64_t word) {
        value_ = (value_ ^ word) * 0x100000001B3U;
        value_ ^= value_ >> 32U;  // mixes the upper 32 bits into the lower 32 bits
    }

    std::uint64_t value_{0xCBF29CE484222325U};
};

}  // namespace canproof::fuzz
