// Numbers of successive saves, which wrap after 2^32 of them.
#pragma once

#include <cstdint>

namespace canproof {

/// Whether sequence number `a` was given after `b`, of two that lie less than 2^31 apart.
constexpr bool is_newer(const std::uint32_t a, const std::uint32_t b) noexcept {
    constexpr std::uint32_t half = 0x80000000U;
    return (a != b) && ((a - b) < half);
}

}  // namespace canproof
