// SPDX-License-Identifier: Apache-2.0
// Receive PDOs: reception, synchronous and immediate application, monitoring by the event timer (CiA 301, 7.2.2 and
// 7.5.2.35).
#pragma once

#include "firmware/canopen/object_access.hpp"
#include "firmware/canopen/pdo_communication.hpp"
#include "firmware/canopen/pdo_mapping.hpp"
#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

/// The settings of one receive PDO: they change only when its objects are written or loaded.
struct ReceivePdoSettings {
    static constexpr std::uint32_t nobody = UINT32_MAX;  ///< not the identifier of any frame

    std::uint32_t identifier{nobody};  ///< identifier of its frames; `nobody` while the PDO is not valid
    PdoParameters parameters{};
    PdoMapping mapping{};
};

/// One receive PDO. The first member must have the alignment of the settings, so that no member lies in their padding.
struct ReceivePdo : ReceivePdoSettings {
    Instant due{never};  ///< the PDO is overdue if no accepted frame comes until this time
    Frame waiting{};
    bool waits{false};
};
static_assert(alignof(ReceivePdoSettings) == alignof(Instant));

class ReceivePdos {
  public:
    /// Each of the `pdos` gets an equal part of `lines` for its mapping. `answering_remote`: bit n lets RPDO n + 1
    /// answer a remote frame.
    ReceivePdos(const Slots<ReceivePdo>& pdos, const Slots<PdoLine>& lines, ObjectDictionary& objects,
                ObjectAccess& access, TransmitQueue& queue, const std::uint8_t answering_remote) noexcept
        : rpdos_{pdos},
          answering_remote_{answering_remote},
          lines_{lines},
          objects_{objects},
          access_{access},
          queue_{queue} {}

    /// Reads the parameters after they were loaded: no frame waits, and no error of an RPDO remains.
    void reset() noexcept;
    /// Leaves operational: no frame waits for a SYNC, and no RPDO is expected. Errors of RPDOs remain until a correct
    /// reception ends them.
    void stop() noexcept;
    /// Processes a data frame with an 11-bit identifier in operational; ignores one that is no RPDO of this node.
    void receive(const Frame& frame, Instant now) noexcept;
    /// Processes a remote frame in operational; ignores one that no RPDO of this node answers.
    void answer(const Frame& request) noexcept;
    /// Applies the RPDOs of synchronous types received since the last SYNC, RPDO1 first.
    void sync(Instant now) noexcept;
    /// Detects overdue receptions.
    void advance(const Instant now) noexcept {
        if (next_ <= now) {
            find_overdue(now);
        }
    }
    Instant next_deadline() const noexcept { return next_; }

    /// Returns whether, since the last call, errors of RPDOs may have changed or the monitoring of an RPDO has begun.
    bool take_change() noexcept {
        if (!changed_) {
            return false;
        }
        changed_ = false;
        return true;
    }
    /// Returns whether there is an RPDO whose last frame was too short for its mapping (error 8210h). A write to its
    /// parameters or its mapping ends this error.
    bool has_short() const noexcept { return (failed_ & (all_pdos << came_short)) != 0U; }
    /// Returns whether a value of an RPDO was refused (error 8200h). A frame of this RPDO whose values are accepted
    /// ends the error, and so does a write to the parameters or the mapping of the RPDO.
    bool has_refused() const noexcept { return (failed_ & (all_pdos << came_refused)) != 0U; }
    /// Returns whether an RPDO is too short, refused or overdue: see has_short(), has_refused() and overdue().
    bool has_failed() const noexcept { return failed_ != 0U; }
    /// Returns the RPDOs of which no frame with accepted values was received within the event time: bit n stands for
    /// RPDO n + 1. Such a frame ends the error, and so does a write to the parameters or the mapping of the RPDO.
    std::uint8_t overdue() const noexcept { return static_cast<std::uint8_t>((failed_ >> came_late) & all_pdos); }
    const Slots<ReceivePdo>& all() const noexcept { return rpdos_; }
    const Slots<PdoLine>& lines() const noexcept { return lines_; }

    /// Reads the parameters and mapping of an RPDO again after a write to one of their entries (14xxh, 16xxh). Ignores
    /// other entries.
    void after_write(const EntryRef& entry) noexcept;

    /// Returns whether the invariant between two calls holds (properties/invariants): each identifier has 11 bits or is
    /// `nobody`. A frame that waits for its SYNC has all mapped bytes. The next deadline is the earliest of all PDOs,
    /// from the first stop() after a reset() on.
    bool is_consistent() const noexcept;

  private:
    void refresh(std::size_t number) noexcept;
    static constexpr std::uint32_t all_pdos = 0xFFU;
    static_assert(max_pdos <= 8U, "a set of PDOs has eight bits, one per PDO");
    // First bit of each kind of error in failed_; the eight bits from there on stand for RPDO1 to RPDO8.
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
    std::uint8_t answering_remote_;
    bool changed_{false};       ///< see take_change()
    std::uint32_t failed_{0U};  ///< eight bits each for came_short, came_refused and came_late
    Slots<PdoLine> lines_;
    ObjectDictionary& objects_;
    ObjectAccess& access_;
    TransmitQueue& queue_;
    Instant next_{never};
};

}  // namespace canproof
