// SPDX-License-Identifier: Apache-2.0
// Hashes the observations of a run: FNV-1a, 64 bits. Two runs have the same value only when all observations were
// equal, apart from collisions.
#pragma once

#include <cstring>
#include <type_traits>

#include "firmware/base/bytes.hpp"

namespace canproof::fuzz {

class Digest {
  public:
    void add(ByteView bytes) {
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            value_ = (value_ ^ bytes[i]) * 0x100000001B3U;
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
    std::uint64_t value_{0xCBF29CE484222325U};
};

}  // namespace canproof::fuzz
