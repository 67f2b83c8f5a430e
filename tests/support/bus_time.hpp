// SPDX-License-Identifier: Apache-2.0
// The time that frames take on a bus of 1 Mbit/s, on which a bit takes 1 µs.
#pragma once

#include <cstdint>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"

namespace canproof::test {

/// Returns the fewest bits of a frame on the bus: 44 (64 with a 29-bit identifier), its data, and three between frames;
/// no stuff bits (ISO 11898-1).
inline std::uint32_t fewest_bits(const Frame& frame) {
    const std::uint32_t data = frame.remote ? 0U : 8U * frame.length;
    return 47U + data + (frame.extended ? 20U : 0U);
}

/// Adds up the frames that a device receives between two ticks (device cycles). The first of them may have been on the
/// bus before the earlier tick, so its bits do not count.
class BusTime {
  public:
    void begin(Instant tick) {
        begun_ = tick;
        bits_ = 0;
        has_frames_ = false;
    }
    void add(const Frame& frame) {
        bits_ += has_frames_ ? fewest_bits(frame) : 0U;
        has_frames_ = true;
    }
    /// Returns whether a bus can carry the frames until `now`.
    bool is_enough(Instant now) const { return bits_ <= elapsed(begun_, now).us; }

  private:
    Instant begun_{};
    std::uint64_t bits_{0};
    bool has_frames_{false};
};

}  // namespace canproof::test
