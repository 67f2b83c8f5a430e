// Receive PDOs: reception, synchronous and immediate application, monitoring by the event timer (CiA 301, 7.2.2 and
// 7.5.2.35).
#pragma once

#include "firmware/canopen/object_access.hpp"
#include "firmware/canopen/pdo_communication.hpp"
#include "firmware/canopen/pdo_mapping.hpp"
#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

/// One receive PDO.
struct ReceivePdo {
    static constexpr std::uint32_t nobody = UINT32_MAX;  ///< an identifier that no frame has

    PdoParameters parameters{};
    PdoMapping mapping{};
    std::uint32_t identifier{nobody};  ///< that of its frames; nobody while it is not valid
    Frame waiting{};
    bool waits{false};
    Instant due{never};  ///< the next reception, at the latest
};

class ReceivePdos {
  public:
    /// `lines` are shared evenly among the `pdos`. `answering_remote`: bit n lets RPDO n + 1 answer a remote frame.
    ReceivePdos(const Slots<ReceivePdo>& pdos, const Slots<PdoLine>& lines, ObjectDictionary& objects,
                ObjectAccess& access, TransmitQueue& queue, const std::uint8_t answering_remote) noexcept
        : rpdos_{pdos},
          lines_{lines},
          objects_{objects},
          access_{access},
          queue_{queue},
          answering_remote_{answering_remote} {}

    /// The parameters were loaded anew: nothing waits, nothing is late.
    void reset() noexcept;
    /// Operational is left: nothing waits for a SYNC, no reception is expected. What was wrong stays so until a
    /// reception cures it.
    void stop() noexcept;
    /// Takes a data frame in operational; one that is no RPDO of this node is passed over.
    void receive(const Frame& frame, Instant now) noexcept;
    /// The same for a remote frame.
    void answer(const Frame& request) noexcept;
    /// Applies what was received in the synchronous types since the last SYNC, RPDO1 first.
    void sync(Instant now) noexcept;
    /// Notices receptions that are overdue.
    void advance(const Instant now) noexcept {
        if (next_ <= now) {
            find_overdue(now);
        }
    }
    Instant next_deadline() const noexcept { return next_; }

    /// An RPDO came with fewer bytes than mapped, and none of right length since (error 8210h).
    bool has_short() const noexcept { return (failed_ & (all_pdos << came_short)) != 0U; }
    /// A value of an RPDO was refused, and the RPDO has not come with values that are taken since (error 8200h).
    bool has_refused() const noexcept { return (failed_ & (all_pdos << came_refused)) != 0U; }
    /// Any of these.
    bool has_failed() const noexcept { return failed_ != 0U; }
    /// Which did not come within their event time and have not come since: bit n stands for RPDO n + 1.
    std::uint8_t overdue() const noexcept { return static_cast<std::uint8_t>((failed_ >> came_late) & all_pdos); }

    /// An entry of 14xxh or 16xxh has a new value: the PDO begins anew.
    void after_write(const EntryRef& entry) noexcept;

  private:
    void refresh(std::size_t number) noexcept;
    static constexpr std::uint32_t all_pdos = 0xFFU;
    static_assert(max_pdos <= 8U, "a PDO each is a bit of eight");
    // Where the bits of a failure begin: bit n of eight stands for RPDO n + 1.
    static constexpr std::uint32_t came_short = 0U;
    static constexpr std::uint32_t came_refused = 8U;
    static constexpr std::uint32_t came_late = 16U;

    void mark(std::uint32_t failure, std::size_t number, bool on) noexcept;
    std::size_t number_of(const ReceivePdo& wanted) const noexcept;
    void take(ReceivePdo& rpdo, const Frame& frame, Instant now) noexcept;
    bool leaves_waiting(std::size_t number) noexcept;
    bool is_taken(const ReceivePdo& rpdo, const Frame& frame) noexcept;
    void find_overdue(Instant now) noexcept;
    void schedule() noexcept;

    Slots<ReceivePdo> rpdos_;
    Slots<PdoLine> lines_;
    ObjectDictionary& objects_;
    ObjectAccess& access_;
    TransmitQueue& queue_;
    std::uint8_t answering_remote_;
    std::uint32_t failed_{0U};  ///< by came_short, came_refused and came_late
    Instant next_{never};
};

}  // namespace canproof
