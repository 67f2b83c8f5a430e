// SPDX-License-Identifier: Apache-2.0
// Naive LEDs and coding switches of the CAN-CBX-AO412 by Tables 5 to 11 of its manual (sections 3.2, 3.3). Times are in
// milliseconds. Shares no code with the firmware.
#pragma once

#include <array>
#include <cstdint>

namespace canproof::naive_ao4 {

/// The states of Table 5: off, on, blinking, or a number of flashes.
enum class Light { off, on, blinking, one_flash, two_flashes, three_flashes };

inline bool flashes(std::uint64_t at_ms, unsigned count, unsigned pause_ms) {
    const std::uint64_t round_ms = 200U * count + 200U * (count - 1U) + pause_ms;
    const std::uint64_t within = at_ms % round_ms;
    return within < 200U * (2U * count - 1U) && within / 200U % 2U == 0;
}

/// Returns whether an LED is lit. The pattern of a red LED begins 200 ms later than the pattern of a green LED.
inline bool is_lit(Light light, bool red, std::uint64_t now_ms) {
    constexpr std::uint64_t rounds_ms = 16000;  // a multiple of the length of every pattern, in ms
    const std::uint64_t at = red ? now_ms + rounds_ms - 200U : now_ms + rounds_ms;
    switch (light) {
        case Light::off:
            return false;
        case Light::on:
            return true;
        case Light::blinking:
            return at / 200U % 2U == 0;
        case Light::one_flash:
            return flashes(at, 1, 1400);
        case Light::two_flashes:
            return flashes(at, 2, 1000);
        case Light::three_flashes:
        default:
            return flashes(at, 3, 1000);
    }
}

/// Returns the bit rate in bit/s for a setting of the switch Baud (Table 11).
inline std::uint32_t bit_rate(unsigned setting) {
    constexpr std::array<std::uint32_t, 16> rates{1000000, 666667, 500000, 333333, 250000, 166000, 125000, 100000,
                                                  66667,   50000,  33333,  20000,  12500,  10000,  800000, 83333};
    return rates[setting % 16];
}

}  // namespace canproof::naive_ao4
