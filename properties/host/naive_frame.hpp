// SPDX-License-Identifier: Apache-2.0
// The bits of a CAN frame as a text of 0 and 1, in the order of the bus. The CRC is computed by long division.
#pragma once

#include <cstdint>
#include <string>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

/// Returns `count` bits of a number, the highest first.
inline std::string naive_bits(std::uint64_t value, unsigned count) {
    std::string bits;
    for (unsigned i = count; i-- > 0;) {
        bits += ((value >> i) % 2U == 1U) ? '1' : '0';
    }
    return bits;
}

/// Returns identifier, RTR and IDE in the order of the bus. 0 is dominant, so the smaller text wins the arbitration.
inline std::string naive_arbitration_field(const Frame& frame) {
    const std::string rtr = frame.remote ? "1" : "0";
    return frame.extended ? naive_bits(frame.id / 262144U, 11) + "11" + naive_bits(frame.id % 262144U, 18) + rtr
                          : naive_bits(frame.id, 11) + rtr + "0";
}

/// Returns the CRC: the remainder of the long division of `bits` by 1100010110011001.
inline std::string naive_crc(std::string bits) {
    const std::string divisor = "1100010110011001";
    const std::size_t places = bits.size();
    bits += std::string(15, '0');
    for (std::size_t at = 0; at < places; ++at) {
        for (std::size_t i = 0; bits[at] == '1' && i < divisor.size(); ++i) {
            // goes from the end of the divisor to its start: the first 1 of the divisor clears bits[at], which the loop
            // tests, so this must be the last step
            const std::size_t place = at + divisor.size() - 1U - i;
            bits[place] = bits[place] == divisor[divisor.size() - 1U - i] ? '0' : '1';
        }
    }
    return bits.substr(places);
}

/// Returns the number of bits from the start of the frame to its end, including stuff bits.
inline unsigned naive_frame_bits(const Frame& frame) {
    std::string bits = "0" + naive_arbitration_field(frame) + (frame.extended ? "00" : "0");
    bits += naive_bits(frame.length, 4);
    for (std::size_t i = 0; i < frame.length && !frame.remote; ++i) {
        bits += naive_bits(frame.data[i], 8);
    }
    std::string wire;
    for (const char bit : bits + naive_crc(bits)) {
        wire += bit;
        const std::string last = wire.size() < 5 ? "" : wire.substr(wire.size() - 5);
        if (last == "00000" || last == "11111") {
            wire += bit == '0' ? '1' : '0';
        }
    }
    return static_cast<unsigned>(wire.size()) + 10U;  // CRC delimiter, acknowledge, acknowledge delimiter, seven bits
                                                      // of end of frame
}

}  // namespace canproof::host
