// SPDX-License-Identifier: Apache-2.0
// SYNC: consumer and producer (CiA 301, 7.2.5; objects 1005h COB-ID SYNC, 1006h communication cycle period, 1019h
// synchronous counter overflow value).
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

    /// Permits or forbids SYNC when the node enters or leaves a state in which SYNC works: the producer starts or
    /// stops.
    void allow(bool allowed, Instant now) noexcept;
    /// Returns whether a received frame has the identifier of the SYNC message.
    bool is_sync(const Frame& frame) const noexcept {
        static_assert(implements<req::CO_SYNC_001>);
        return (frame.id == identifier_) && !frame.extended && !frame.remote;
    }
    /// Returns whether a SYNC has the length that 1019h (SYNC counter overflow) demands: one byte, or none while 1019h
    /// is zero. Any other length is error 8240h.
    bool has_length(const Frame& sync) const noexcept {
        static_assert(implements<req::CO_SYNC_002> && implements<req::CO_SYNC_009>);
        return std::uint32_t{sync.length} == length_;
    }
    /// Returns whether SYNCs contain a counter: whether 1019h (SYNC counter overflow) is not zero.
    bool counts() const noexcept { return length_ != 0U; }
    /// Returns the counter of a SYNC; zero while 1019h (SYNC counter overflow) is zero.
    std::uint8_t counter_of(const Frame& sync) const noexcept {
        return (length_ == 0U) ? std::uint8_t{0U} : sync.data[0];
    }
    /// Produces a SYNC when one is due. Returns true when it did so: the node then consumes its own SYNC as well.
    bool advance(const Instant now) noexcept { return (next_ <= now) ? produce(now) : false; }
    /// Returns the counter of the last produced SYNC; zero while 1019h (SYNC counter overflow) is zero and before the
    /// first SYNC.
    std::uint8_t produced_counter() const noexcept { return counter_; }
    Instant next_deadline() const noexcept { return next_; }

    AbortCode before_write(const EntryRef& entry, std::uint32_t value) const noexcept;
    void after_write(Instant now) noexcept { restart(now); }

    /// Returns whether the invariant between two calls holds (properties/invariants): identifier and length of SYNC are
    /// those of 1005h (COB-ID SYNC) and 1019h (synchronous counter overflow value). A SYNC is due only while the
    /// producer may work, is switched on and has a period. Before the first allow(), the settings may be others.
    bool is_consistent() const noexcept;

  private:
    bool produce(Instant now) noexcept;
    bool is_producer() const noexcept;
    /// Reads the parameters and clears the counter. The producer, if it is permitted and switched on, sends its next
    /// SYNC one period from now.
    void restart(Instant now) noexcept;

    ObjectDictionary& objects_;
    TransmitQueue& queue_;
    Instant next_{never};
    /// Identifier of the SYNC. Zero means no SYNC: 0 is the identifier of NMT, whose frames never reach is_sync().
    std::uint32_t identifier_{0U};
    std::uint8_t length_{0U};  ///< length of a SYNC in bytes: 1 while 1019h (SYNC counter overflow) is not zero
    std::uint8_t counter_{0U};
    bool allowed_{false};
};

}  // namespace canproof
