// SPDX-License-Identifier: Apache-2.0
// How much of the bus the frames of a run take.
#pragma once

#include <algorithm>
#include <cstdint>

#include "host/conform/link/target.hpp"
#include "host/sim/bus/can_bits.hpp"

namespace canproof::host::conform {

/// Frames and their bits. A frame counts with its stuff bits and the intermission behind it.
class BusUse {
  public:
    /// Adds a frame. Frames must come in order of time.
    void add(const FrameRecord& record) {
        const std::uint64_t bits = frame_bits(record.frame) + intermission_bits;
        const std::uint64_t second = record.time.us / 1000000U;
        bits_of_second_ = (second == second_ ? bits_of_second_ : 0U) + bits;
        second_ = second;
        busiest_second_ = std::max(busiest_second_, bits_of_second_);
        bits_ += bits;
        ++frames_;
        own_frames_ += record.own ? 1U : 0U;
    }

    std::uint64_t frames() const { return frames_; }
    /// Returns the number of frames that the tester sent.
    std::uint64_t own_frames() const { return own_frames_; }
    std::uint64_t bits() const { return bits_; }
    /// The most bits of frames that ended in one second of the clock.
    std::uint64_t busiest_second() const { return busiest_second_; }

  private:
    std::uint64_t frames_{0};
    std::uint64_t own_frames_{0};
    std::uint64_t bits_{0};
    std::uint64_t second_{0};
    std::uint64_t bits_of_second_{0};
    std::uint64_t busiest_second_{0};
};

}  // namespace canproof::host::conform
