// SPDX-License-Identifier: Apache-2.0
// The bits of a classic CAN frame as transmitted (ISO 11898-1): CRC-15, stuff bits, length, priority in arbitration.
#pragma once

#include <cstdint>
#include <vector>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

/// Number of recessive bits between two frames.
constexpr unsigned intermission_bits = 3U;
/// Number of bits of the longest error frame: at most twelve dominant bits of all nodes, and the delimiter.
constexpr unsigned error_frame_bits = 12U + 8U;
/// Number of additional bits for which an error-passive node waits after its own frame.
constexpr unsigned suspend_bits = 8U;
/// Number of recessive bits after which a bus-off controller takes part again.
constexpr unsigned bus_off_recovery_bits = 128U * 11U;

/// Returns the bits from start of frame to the last data bit, without stuff bits. The CRC is computed over these bits.
std::vector<bool> unstuffed_bits(const Frame& frame);
/// Returns the CRC of the bits, with the polynomial x^15 + x^14 + x^10 + x^8 + x^7 + x^4 + x^3 + 1 and the start value
/// 0.
std::uint16_t crc15(const std::vector<bool>& bits);
/// Returns the number of stuff bits. After five equal bits, a stuff bit of the other level follows. It counts as the
/// first of the next five bits.
unsigned count_stuff_bits(const std::vector<bool>& bits);
/// Returns the number of bits from start of frame to end of frame, with stuff bits and without the intermission.
unsigned frame_bits(const Frame& frame);
/// Returns the time of a frame and of the intermission after it, in nanoseconds, rounded down.
std::uint64_t frame_time_ns(const Frame& frame, std::uint32_t bit_rate);
/// Returns the arbitration field left-aligned in 32 bits. The frame with the lower value wins. A data frame wins over a
/// remote frame with the same identifier; an 11-bit identifier wins over a 29-bit identifier that begins with it.
std::uint32_t arbitration_rank(const Frame& frame);

}  // namespace canproof::host
