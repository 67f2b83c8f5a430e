// SPDX-License-Identifier: Apache-2.0
// Computes how much of the bus capacity the frames of a run take.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>

#include "host/conform/link/target.hpp"
#include "host/sim/bus/can_bits.hpp"

namespace canproof::host::conform {

/// Counts frames and their bits. A frame includes its stuff bits and the intermission after it.
class BusUse {
  public:
    /// Adds a frame. Frames must be added in order of time.
    void add(const FrameRecord& record) {
        const std::uint64_t bits = frame_bits(record.frame) + intermission_bits;
        for (; !last_.empty() && last_.front().time + second <= record.time; last_.pop_front()) {
            bits_of_second_ -= last_.front().bits;
        }
        last_.push_back({record.time, bits});
        bits_of_second_ += bits;
        busiest_second_ = std::max(busiest_second_, bits_of_second_);
        bits_ += bits;
        ++frames_;
        own_frames_ += record.own ? 1U : 0U;
    }

    std::uint64_t frames() const { return frames_; }
    /// Returns the number of frames that the tester sent.
    std::uint64_t own_frames() const { return own_frames_; }
    std::uint64_t bits() const { return bits_; }
    /// Returns the number of bits in the second with the most bits. A frame counts in the second in which it ends.
    std::uint64_t busiest_second() const { return busiest_second_; }

  private:
    static constexpr Duration second = milliseconds(1000);
    struct Ended {
        Instant time{};
        std::uint64_t bits{0};
    };

    std::uint64_t frames_{0};
    std::uint64_t own_frames_{0};
    std::uint64_t bits_{0};
    std::deque<Ended> last_;  ///< frames that ended within the second before the newest frame
    std::uint64_t bits_of_second_{0};
    std::uint64_t busiest_second_{0};
};

}  // namespace canproof::host::conform
