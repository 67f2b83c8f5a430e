// SPDX-License-Identifier: Apache-2.0
// Compares bytes without memcmp(), because libFuzzer and the sanitizers observe each call of memcmp().
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace canproof {

inline bool same_bytes(const std::uint8_t* a, const std::uint8_t* b, std::size_t count) {
    std::uint32_t difference = 0;
    for (std::size_t i = 0; i < count; ++i) {
        difference |= static_cast<std::uint32_t>(a[i] ^ b[i]);
    }
    return difference == 0;
}
inline bool same_bytes(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    return a.size() == b.size() && same_bytes(a.data(), b.data(), a.size());
}

}  // namespace canproof
