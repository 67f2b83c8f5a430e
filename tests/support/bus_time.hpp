// SPDX-License-Identifier: Apache-2.0
// The time that frames take on a bus of 1 Mbit/s, on which a bit takes 1 µs.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "target/stm32f405/receive_ring.hpp"

namespace canproof::test {

/// Returns the fewest bits of a frame on the bus: 44 (64 with a 29-bit identifier), its data, and three between frames;
/// no stuff bits (ISO 11898-1).
inline std::uint32_t fewest_bits(const Frame& frame) {
    const std::uint32_t data = frame.remote ? 0U : 8U * frame.length;
    return 47U + data + (frame.extended ? 20U : 0U);
}

/// Adds up the frames that a device receives from one deadline to the next. The first of them may have been on the bus
/// before: when a call takes long, frames wait in the ring of the driver. The bits of a full ring do not count.
class BusTime {
  public:
    void begin(Instant deadline) {
        begun_ = deadline;
        bits_ = 0;
        frames_ = 0;
    }
    void add(const Frame& frame) {
        ++frames_;
        bits_ += frames_ > stm32f405::ReceiveRing::capacity ? fewest_bits(frame) : 0U;
    }
    /// Returns whether a bus can carry the frames until `now`.
    bool is_enough(Instant now) const { return bits_ <= elapsed(begun_, now).us; }

  private:
    Instant begun_{};
    std::uint64_t bits_{0};
    std::size_t frames_{0};
};

}  // namespace canproof::test
