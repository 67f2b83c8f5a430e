// SYNC: consumer and producer (CiA 301, 7.2.5; objects 1005h, 1006h, 1019h).
#pragma once

#include "firmware/base/requirement.hpp"
#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

class Sync {
  public:
    Sync(ObjectDictionary& objects, TransmitQueue& queue) noexcept : objects_{objects}, queue_{queue} {}

    /// The node entered a state in which SYNC works, or left the last one: the producer starts or stops.
    void allow(bool allowed, Instant now) noexcept;
    /// Whether a received frame has the identifier of the SYNC message.
    bool is_sync(const Frame& frame) const noexcept {
        static_assert(implements<req::CO_SYNC_001>);
        return (frame.id == identifier_) && !frame.extended && !frame.remote;
    }
    /// Whether it has the length that 1019h asks for; any other is error 8240h.
    bool has_length(const Frame& sync) const noexcept {
        static_assert(implements<req::CO_SYNC_002>);
        return std::uint32_t{sync.length} == length_;
    }
    /// The counter that a SYNC carries; zero while 1019h is zero.
    std::uint8_t counter_of(const Frame& sync) const noexcept {
        return (length_ == 0U) ? std::uint8_t{0U} : sync.data[0];
    }
    /// True when a SYNC was produced: the node consumes its own as well.
    bool advance(const Instant now) noexcept { return (next_ <= now) ? produce(now) : false; }
    /// The counter of the SYNC that was produced last; zero while 1019h is zero.
    std::uint8_t produced_counter() const noexcept { return counter_; }
    Instant next_deadline() const noexcept { return next_; }

    AbortCode before_write(const EntryRef& entry, std::uint32_t value) const noexcept;
    void after_write(Instant now) noexcept { restart(now); }

  private:
    bool produce(Instant now) noexcept;
    bool is_producer() const noexcept;
    /// Reads the parameters; the producer starts anew, one period from now, if it is switched on.
    void restart(Instant now) noexcept;

    ObjectDictionary& objects_;
    TransmitQueue& queue_;
    Instant next_{never};
    std::uint32_t identifier_{0U};  ///< of the SYNC; zero, which is the NMT master's and never comes here: no SYNC
    std::uint8_t length_{0U};       ///< of a SYNC: one byte while 1019h is not zero
    std::uint8_t counter_{0U};
    bool allowed_{false};
};

}  // namespace canproof
