// SPDX-License-Identifier: Apache-2.0
// Recognises the device's own frames in a log: frames that it has sent and that the log has not shown since.
#pragma once

#include <cstdint>
#include <deque>
#include <unordered_map>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"

namespace canproof::host {

class OwnFrames {
  public:
    /// Longest time that a frame waits for the bus; it bounds memory and search time for any length of log.
    static constexpr Duration longest_wait = milliseconds(60000);

    void sent(const Frame& frame, Instant now);
    /// Returns whether the device has sent this frame. Each sent frame is recognised once.
    bool match(const Frame& frame, Instant now);

  private:
    struct Content {
        std::uint64_t data;
        std::uint32_t id;
        std::uint32_t form;  ///< length, extended, remote
        bool operator==(const Content& other) const {
            return data == other.data && id == other.id && form == other.form;
        }
    };
    struct Hash {
        std::size_t operator()(const Content& one) const;
    };
    struct Count {
        std::uint32_t open{0};  ///< sent, not yet seen in the log
        std::uint32_t seen{0};  ///< seen, and still in order_
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
