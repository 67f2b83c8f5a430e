// Heartbeat consumer: watches other nodes (CiA 301, 7.2.8.2.2; object 1016h, `00 | node-ID | time in ms`).
#pragma once

#include <array>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_dictionary.hpp"

namespace canproof {

class HeartbeatConsumer {
  public:
    /// The AX devices watch up to four producers, the CAN-CBX-AO412 one.
    static constexpr std::size_t max_producers = 4U;
    static constexpr std::uint16_t index = 0x1016U;

    explicit HeartbeatConsumer(ObjectDictionary& objects) noexcept : objects_{objects} {}

    /// Monitoring of each producer starts with the first heartbeat that is received from it.
    void reset() noexcept;
    void receive(const Frame& frame, Instant now) noexcept;
    void advance(Instant now) noexcept;
    Instant next_deadline() const noexcept;
    /// A producer that was heard has fallen silent and has not been heard again.
    bool failed() const noexcept;
    /// The same of one entry of 1016h, slot 0 for sub-index 1.
    bool failed(const std::size_t slot) const noexcept { return watches_[slot].failed; }
    /// The node-ID that this entry watches.
    std::uint8_t producer(std::size_t slot) const noexcept;

    AbortCode before_write(const EntryRef& entry, ByteView value) const noexcept;
    void after_write(const EntryRef& entry) noexcept;

  private:
    struct Watch {
        Instant deadline{never};
        bool failed{false};
    };

    std::uint32_t setting(std::size_t slot) const noexcept;

    ObjectDictionary& objects_;
    std::array<Watch, max_producers> watches_{};
};

}  // namespace canproof
