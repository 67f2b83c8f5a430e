// SPDX-License-Identifier: Apache-2.0
// The bits of a classic CAN frame on the wire (ISO 11898-1): CRC-15, stuff bits, length, priority in arbitration.
#pragma once

#include <cstdint>
#include <vector>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

/// Recessive bits between two frames.
constexpr unsigned intermission_bits = 3U;
/// Longest error frame of all nodes together: at most twelve dominant bits, and the delimiter.
constexpr unsigned error_frame_bits = 12U + 8U;
/// Additional bits that an error-passive node waits after its own frame.
constexpr unsigned suspend_bits = 8U;
/// Recessive bits after which a bus-off controller takes part again.
constexpr unsigned bus_off_recovery_bits = 128U * 11U;

/// Returns the bits from start of frame to the last data bit, without stuff bits; the CRC covers these bits.
std::vector<bool> unstuffed_bits(const Frame& frame);
/// Returns the CRC with x^15 + x^14 + x^10 + x^8 + x^7 + x^4 + x^3 + 1 and start value 0.
std::uint16_t crc15(const std::vector<bool>& bits);
/// Returns the number of stuff bits. After five equal bits a bit of the other level is inserted, which counts as the
/// first of the next five.
unsigned count_stuff_bits(const std::vector<bool>& bits);
/// Returns the bits from start of frame to end of frame, with stuff bits and without intermission.
unsigned frame_bits(const Frame& frame);
/// Returns the arbitration field left-aligned in 32 bits: the lower rank wins. A data frame wins over its remote frame,
/// and a base identifier over an extended one that begins with it.
std::uint32_t arbitration_rank(const Frame& frame);

}  // namespace canproof::host
