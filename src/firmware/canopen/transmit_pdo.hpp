// SPDX-License-Identifier: Apache-2.0
// Transmit PDOs: sent on events, by their timer, at a SYNC or on request (CiA 301, 7.2.2 and 7.5.2.37).
#pragma once

#include "firmware/canopen/pdo_communication.hpp"
#include "firmware/canopen/pdo_mapping.hpp"
#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

/// The event of transmission types 254 and 255; CiA 301 leaves it to the manufacturer and the profile.
enum class TpdoTrigger : std::uint8_t {
    /// A change of a mapped process value; the event timer sets the longest interval. A TPDO of type 254 or 255 is also
    /// sent once on entering operational.
    value_change,
    /// The event timer alone. If the timer is not zero, the TPDO is also sent on entering operational. If it is zero,
    /// the TPDO is sent on request only (AX130751, AX188001, AX060805: "time-driven").
    event_timer
};

/// The settings of one transmit PDO: they change only when its objects are written or loaded.
struct TransmitPdoSettings {
    bool usable{false};
    bool event_driven{false};  ///< usable and of type 254 or 255
    PdoParameters parameters{};
    PdoMapping mapping{};
};

/// One transmit PDO. The first member must have the alignment of the settings, so that no member lies in their padding.
struct TransmitPdo : TransmitPdoSettings {
    std::uint64_t sample{0U};   ///< the values at the last SYNC, if `sampled`
    std::uint64_t watched{0U};  ///< watch_mark() of each value whose change is an event
    bool sampled{false};
    bool pending{false};           ///< an event has occurred; its frame has not been sent yet
    bool cycle_begun{false};       ///< the SYNC from which SYNCs are counted has come (see sync_start)
    std::uint8_t syncs{0U};        ///< SYNCs since the last frame of a cyclic TPDO (type 1 to 240)
    Instant inhibited_until{};     ///< no event frame is sent before this time (inhibit time)
    Instant timer_expires{never};  ///< the event timer's next event
    Instant due{never};            ///< when the next event frame is due
};
static_assert(alignof(TransmitPdoSettings) == alignof(std::uint64_t));

class TransmitPdos {
  public:
    /// Each of the `pdos` gets an equal part of `lines` for its mapping.
    TransmitPdos(const Slots<TransmitPdo>& pdos, const Slots<PdoLine>& lines, ObjectDictionary& objects,
                 TransmitQueue& queue, const TpdoTrigger trigger) noexcept
        : tpdos_{pdos}, trigger_{trigger}, lines_{lines}, objects_{objects}, queue_{queue} {}

    /// Reads the parameters after they were loaded; the node is not operational.
    void reset() noexcept;
    /// Enters operational. The next advance() sends the TPDOs that are due on entering this state.
    void start(Instant now) noexcept;
    /// Leaves operational.
    void stop() noexcept;

    /// Returns whether a TPDO may wait for a change of one of the values whose watch_mark() is in `marks`.
    bool is_watched(const std::uint64_t marks) const noexcept { return (watched_ & marks) != 0U; }
    /// Notes that a value may have changed; takes little time when no TPDO waits for it. No frame leaves before the
    /// next advance(), so that values which change together leave together.
    void value_changed(const std::uint16_t index, const std::uint8_t subindex, const Instant now) noexcept {
        const std::uint64_t mark = watch_mark(index, subindex);
        if (is_watched(mark)) {
            note_change(mark, index, subindex, now);
        }
    }
    /// Processes a SYNC. `is_counted` is true when the SYNC contains the counter `counter`, that is, while 1019h (SYNC
    /// counter overflow) is not zero.
    void sync(std::uint8_t counter, bool is_counted) noexcept;
    /// Answers a remote frame; ignores one that requests no TPDO of this node.
    void answer(const Frame& request, Instant now) noexcept;
    /// Sends each TPDO that is due at `now`; none is due before next_deadline().
    void advance(Instant now) noexcept;
    Instant next_deadline() const noexcept { return next_; }
    const Slots<TransmitPdo>& all() const noexcept { return tpdos_; }
    const Slots<PdoLine>& lines() const noexcept { return lines_; }

    /// Applies a new value of an entry of a TPDO's parameters (18xxh) or mapping (1Axxh). Ignores other entries.
    void after_write(const EntryRef& entry, Instant now) noexcept;

  private:
    bool waits_for_changes(const TransmitPdo& tpdo) const noexcept;
    void refresh(std::size_t number) noexcept;
    void begin(TransmitPdo& tpdo, Instant now) const noexcept;
    void note_change(std::uint64_t mark, std::uint16_t index, std::uint8_t subindex, Instant now) noexcept;
    void sync_one(TransmitPdo& tpdo, bool begins_cycle) noexcept;
    static bool begins_cycle(const TransmitPdo& tpdo, std::uint8_t counter, bool is_counted) noexcept;
    void send_event(TransmitPdo& tpdo, Instant now) noexcept;
    [[gnu::noinline]] void restart_timer(TransmitPdo& tpdo, Instant now) const noexcept;
    void send(const TransmitPdo& tpdo, std::uint64_t values) noexcept;
    void plan(TransmitPdo& tpdo, Instant event) noexcept;
    void schedule() noexcept;

    Slots<TransmitPdo> tpdos_;
    TpdoTrigger trigger_;
    bool running_{false};
    std::uint8_t active_{0U};  ///< the number of TPDOs up to the last one that is usable
    Slots<PdoLine> lines_;
    ObjectDictionary& objects_;
    TransmitQueue& queue_;
    std::uint64_t watched_{0U};  ///< the union of `watched` of all TPDOs
    Instant next_{never};
};

}  // namespace canproof
