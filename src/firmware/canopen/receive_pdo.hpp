// Receive PDOs: communication parameters 14xxh, reception, synchronous and immediate application (CiA 301, 7.2.2
// and 7.5.2.35).
#pragma once

#include <array>

#include "firmware/canopen/object_access.hpp"
#include "firmware/canopen/pdo_mapping.hpp"
#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

/// What became of a received frame.
enum class PdoReception : std::uint8_t {
    not_ours,
    taken,
    too_short  ///< fewer bytes than mapped: nothing is applied (error 8210h)
};

class ReceivePdos {
  public:
    /// RPDO1…RPDO8: 1400h…1407h with 1600h…1607h. The devices here have at most four.
    static constexpr std::size_t max_count = 8U;

    /// `answering_remote`: bit n lets RPDO n + 1 answer a remote frame.
    ReceivePdos(ObjectDictionary& objects, ObjectAccess& access, TransmitQueue& queue,
                const std::uint8_t answering_remote) noexcept
        : objects_{objects}, access_{access}, queue_{queue}, answering_remote_{answering_remote} {}

    /// Nothing waits for a SYNC: the state after reset and outside operational.
    void reset() noexcept { waiting_.fill(Waiting{}); }
    PdoReception receive(const Frame& frame, Instant now) noexcept;
    /// Applies what was received in the synchronous types since the last SYNC, RPDO1 first.
    void sync(Instant now) noexcept;

    AbortCode before_write(const EntryRef& entry, ByteView value) const noexcept;

  private:
    struct Waiting {
        Frame frame{};
        bool present{false};
    };

    std::uint32_t cob_id_entry(std::size_t number) const noexcept;
    PdoMapping mapping(std::size_t number) const noexcept;
    PdoReception take(std::size_t number, const Frame& frame, Instant now) noexcept;
    AbortCode before_communication_write(const EntryRef& entry, std::size_t number, ByteView value) const noexcept;
    AbortCode before_mapping_write(const EntryRef& entry, std::size_t number, ByteView value) const noexcept;

    ObjectDictionary& objects_;
    ObjectAccess& access_;
    TransmitQueue& queue_;
    std::uint8_t answering_remote_;
    std::array<Waiting, max_count> waiting_{};
};

}  // namespace canproof
