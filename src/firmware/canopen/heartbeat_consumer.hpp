// Heartbeat consumer: watches other nodes (CiA 301, 7.2.8.2.2; object 1016h, `00 | node-ID | time in ms`).
#pragma once

#include <array>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "generated/canopen/index.hpp"

namespace canproof {

class HeartbeatConsumer {
  public:
    /// The AX devices watch up to four producers, the CAN-CBX-AO412 one.
    static constexpr std::size_t max_producers = 4U;
    static constexpr std::uint32_t index = generated::canopen::index::consumer_heartbeat_time;

    explicit HeartbeatConsumer(ObjectDictionary& objects) noexcept : objects_{objects} {}

    /// Monitoring of each producer starts with the first heartbeat that is received from it.
    void reset() noexcept;
    /// Takes a data frame. True when it may be a heartbeat that is watched.
    bool receive(const Frame& frame, const Instant now) noexcept {
        const bool heard = any_ && (frame.length == 1U) && !frame.extended;
        if (heard) {
            hear(frame.id, now);
        }
        return heard;
    }
    void advance(const Instant now) noexcept {
        if (next_ <= now) {
            find_silent(now);
        }
    }
    Instant next_deadline() const noexcept { return next_; }
    /// Producers that were heard, have fallen silent and have not been heard again: bit n for 1016h:n + 1.
    std::uint32_t failed() const noexcept { return failed_; }
    /// The node-ID that this entry watches.
    std::uint8_t producer(std::size_t slot) const noexcept;

    AbortCode before_write(const EntryRef& entry, std::uint32_t wanted) const noexcept;
    void after_write(const EntryRef& entry) noexcept;

  private:
    struct Watch {
        std::uint32_t identifier{0U};  ///< of the producer's heartbeat; 0, which is NMT's and never comes here: nobody
        Duration time{};
        Instant deadline{never};
    };

    void hear(std::uint32_t identifier, Instant now) noexcept;
    void find_silent(Instant now) noexcept;
    void schedule() noexcept;
    std::uint32_t setting(std::size_t slot) const noexcept;
    /// Reads one entry of 1016h anew; what was heard from its producer is forgotten.
    void restart(std::size_t slot) noexcept;

    ObjectDictionary& objects_;
    std::array<Watch, max_producers> watches_{};
    std::uint32_t failed_{0U};
    bool any_{false};  ///< somebody is watched, or was
    Instant next_{never};
};

}  // namespace canproof
