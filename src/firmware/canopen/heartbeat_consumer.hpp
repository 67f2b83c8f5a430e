// SPDX-License-Identifier: Apache-2.0
// Heartbeat consumer: watches other nodes (CiA 301, 7.2.8.2.2; object 1016h consumer heartbeat time, `00 | node-ID |
// time in ms`).
#pragma once

#include <array>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "generated/canopen/index.hpp"

namespace canproof {

class HeartbeatConsumer {
  public:
    /// The AX130751 and the AX188001 watch up to four producers, the AX060805 and the CAN-CBX-AO412 one.
    static constexpr std::size_t max_producers = 4U;
    static constexpr std::uint32_t index = generated::canopen::index::consumer_heartbeat_time;

    explicit HeartbeatConsumer(ObjectDictionary& objects) noexcept : objects_{objects} {}

    /// Reads the parameters. Monitoring of each producer starts with its first heartbeat.
    void reset() noexcept;
    /// Processes a data frame with an 11-bit identifier. Returns whether it is the heartbeat of a watched producer.
    bool receive(const Frame& frame, const Instant now) noexcept {
        return (any_ && (frame.length == 1U)) ? hear(frame.id, now) : false;
    }
    void advance(const Instant now) noexcept {
        if (next_ <= now) {
            find_silent(now);
        }
    }
    Instant next_deadline() const noexcept { return next_; }
    /// Returns the watched producers whose heartbeat has stopped and not resumed: bit n stands for the producer in
    /// 1016h:n + 1.
    std::uint32_t failed() const noexcept { return failed_; }
    /// Returns the node-ID in 1016h:slot + 1 consumer heartbeat time, also when that entry watches no node.
    std::uint8_t producer(std::size_t slot) const noexcept;

    AbortCode before_write(const EntryRef& entry, std::uint32_t wanted) const noexcept;
    void after_write(const EntryRef& entry) noexcept;

    /// Returns whether the invariant between two calls holds (properties/invariants): the next deadline is the earliest
    /// of all producers. A producer that is not watched or has failed has no deadline. A watched producer has a node-ID
    /// of 1 to 127 and a time of 1 to 65535 ms.
    bool is_consistent() const noexcept;

  private:
    struct Watch {
        /// Identifier of the producer's heartbeat. 0 when no node is watched: 0 is the identifier of NMT commands,
        /// which never reach this class.
        std::uint32_t identifier{0U};
        Duration time{};
        Instant deadline{never};
    };

    bool hear(std::uint32_t identifier, Instant now) noexcept;
    void find_silent(Instant now) noexcept;
    void schedule() noexcept;
    std::uint32_t setting(std::size_t slot) const noexcept;
    /// Reads one entry of 1016h (consumer heartbeat time) again and discards what was received from its producer.
    void restart(std::size_t slot) noexcept;

    ObjectDictionary& objects_;
    std::uint32_t failed_{0U};
    bool any_{false};  ///< a producer is watched, or was watched earlier
    Instant next_{never};
    std::array<Watch, max_producers> watches_{};
};

}  // namespace canproof
