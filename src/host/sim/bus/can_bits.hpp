// A classic CAN frame as bits on the wire (ISO 11898-1): CRC-15, stuff bits, length, rank in arbitration.
#pragma once

#include <cstdint>
#include <vector>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

/// Recessive bits between two frames.
constexpr unsigned intermission_bits = 3U;
/// An error frame as all nodes make it together: six dominant bits each, at most twelve, and the delimiter.
constexpr unsigned error_frame_bits = 12U + 8U;
/// Extra bits that an error-passive node waits after a frame of its own.
constexpr unsigned suspend_bits = 8U;
/// After so many recessive bits a bus-off controller takes part again.
constexpr unsigned bus_off_recovery_bits = 128U * 11U;

/// Start of frame to the last data bit, without stuff bits: what the CRC is taken over.
std::vector<bool> unstuffed_bits(const Frame& frame);
/// x^15 + x^14 + x^10 + x^8 + x^7 + x^4 + x^3 + 1, start 0.
std::uint16_t crc15(const std::vector<bool>& bits);
/// How many bits are stuffed in: one of the other level after five equal ones, which counts as the first of the next
/// five.
unsigned count_stuff_bits(const std::vector<bool>& bits);
/// Start of frame to the end of frame, stuff bits included, intermission not.
unsigned frame_bits(const Frame& frame);
/// The arbitration field left-aligned in 32 bits: the lower rank wins. A data frame wins over its remote frame, a base
/// identifier over an extended one that begins with it.
std::uint32_t arbitration_rank(const Frame& frame);

}  // namespace canproof::host
