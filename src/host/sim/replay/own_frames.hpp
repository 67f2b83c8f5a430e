// SPDX-License-Identifier: Apache-2.0
// Recognises the device's own frames in a log: frames that the device has sent and that the log has not contained
// since.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <unordered_map>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"

namespace canproof::host {

class OwnFrames {
  public:
    /// Longest time that a frame waits for the bus. It limits the memory and the time of the search for a log of any
    /// length.
    static constexpr Duration longest_wait = milliseconds(60000);

    void sent(const Frame& frame, Instant now);
    /// Returns whether the device has sent this frame. Each sent frame is recognised once.
    bool match(const Frame& frame, Instant now);
    /// Returns the number of different frames that are kept.
    std::size_t kept() const { return counts_.size(); }

  private:
    /// The identifier of a frame, its length and kind, and its eight bytes of data.
    using Content = std::array<std::uint32_t, 4>;
    struct Hash {
        std::size_t operator()(const Content& one) const;
    };
    struct Count {
        std::uint32_t open{0};  ///< number of frames that were sent and not seen in the log yet
        std::uint32_t seen{0};  ///< number of frames that were seen in the log and are still in order_
    };
    struct Sent {
        Content content;
        Instant time;
    };

    static Content content_of(const Frame& frame);
    void forget(Instant now);

    std::unordered_map<Content, Count, Hash> counts_;
    std::deque<Sent> order_;
};

}  // namespace canproof::host
