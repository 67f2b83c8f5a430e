// Transmit PDOs: on events, by their timer, at a SYNC, on request (CiA 301, 7.2.2 and 7.5.2.37).
#pragma once

#include "firmware/canopen/pdo_communication.hpp"
#include "firmware/canopen/pdo_mapping.hpp"
#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

/// What the event of types 254 and 255 is, which CiA 301 leaves to the manufacturer and the profile.
enum class TpdoTrigger : std::uint8_t {
    /// A mapped process value changes; the event timer bounds the interval. Sent once on entering operational.
    value_change,
    /// The event timer alone, and entering operational while it is not zero: with zero the TPDO is silent (AX130751,
    /// AX188001, AX060805: "time-driven").
    event_timer
};

/// One transmit PDO.
struct TransmitPdo {
    PdoParameters parameters{};
    PdoMapping mapping{};
    std::uint64_t sample{0U};  ///< the values of the last SYNC
    bool usable{false};
    bool event_driven{false};   ///< usable, of type 254 or 255
    std::uint64_t watched{0U};  ///< watch_mark() of each value whose change is an event
    bool sampled{false};
    bool pending{false};           ///< an event has not been told yet
    bool cycle_begun{false};       ///< the SYNC of the start value has come
    std::uint8_t syncs{0U};        ///< SYNCs of the present cycle
    Instant inhibited_until{};     ///< no event is told before
    Instant timer_expires{never};  ///< the event timer's next event
    Instant due{never};            ///< when an event is to be told next
};

class TransmitPdos {
  public:
    /// `lines` are shared evenly among the `pdos`.
    TransmitPdos(const Slots<TransmitPdo>& pdos, const Slots<PdoLine>& lines, ObjectDictionary& objects,
                 TransmitQueue& queue, const TpdoTrigger trigger) noexcept
        : tpdos_{pdos}, lines_{lines}, objects_{objects}, queue_{queue}, trigger_{trigger} {}

    /// The parameters were loaded anew. Outside operational.
    void reset() noexcept;
    /// Operational is entered: what is sent on entering leaves with the next advance().
    void start(Instant now) noexcept;
    /// Operational is left.
    void stop() noexcept;

    /// A mapped value may have changed; costs next to nothing when no TPDO waits for it. The frame leaves with the next
    /// advance(), so that values which change together leave together.
    void value_changed(const std::uint16_t index, const std::uint8_t subindex, const Instant now) noexcept {
        const std::uint64_t mark = watch_mark(index, subindex);
        if ((watched_ & mark) != 0U) {
            note_change(mark, index, subindex, now);
        }
    }
    /// A SYNC, with its counter, or zero while 1019h is zero.
    void sync(std::uint8_t counter) noexcept;
    /// A remote frame; one that asks for no TPDO of this node is passed over.
    void answer(const Frame& request, Instant now) noexcept;
    void advance(const Instant now) noexcept {
        if (next_ <= now) {
            send_due(now);
        }
    }
    Instant next_deadline() const noexcept { return next_; }

    /// An entry of 18xxh or 1Axxh has a new value.
    void after_write(const EntryRef& entry, Instant now) noexcept;

  private:
    bool waits_for_changes(const TransmitPdo& tpdo) const noexcept;
    void refresh(std::size_t number) noexcept;
    void begin(TransmitPdo& tpdo, Instant now) const noexcept;
    void note_change(std::uint64_t mark, std::uint16_t index, std::uint8_t subindex, Instant now) noexcept;
    void sync_one(TransmitPdo& tpdo, std::uint8_t counter) noexcept;
    void send_due(Instant now) noexcept;
    void send_event(TransmitPdo& tpdo, Instant now) noexcept;
    [[gnu::noinline]] void restart_timer(TransmitPdo& tpdo, Instant now) const noexcept;
    void send(const TransmitPdo& tpdo, std::uint64_t values) noexcept;
    void plan(TransmitPdo& tpdo, Instant event) noexcept;
    void schedule() noexcept;

    Slots<TransmitPdo> tpdos_;
    Slots<PdoLine> lines_;
    ObjectDictionary& objects_;
    TransmitQueue& queue_;
    TpdoTrigger trigger_;
    bool running_{false};
    std::uint64_t watched_{0U};  ///< the same of all TPDOs
    Instant next_{never};
};

}  // namespace canproof
