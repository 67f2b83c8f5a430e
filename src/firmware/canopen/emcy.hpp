// SPDX-License-Identifier: Apache-2.0
// Errors: the error register 1001h, the error list 1003h and the emergency messages that report when an error begins
// and ends (CiA 301, 7.2.7).
#pragma once

#include <array>

#include "firmware/base/time.hpp"
#include "firmware/canopen/error_table.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

/// The contents of 1003h (error list).
enum class ErrorList : std::uint8_t {
    history,  ///< every error that has occurred, also those that have ended (CAN-CBX-AO412)
    active    ///< an error is removed from the list when it ends (Axiomatic)
};

/// The contents of an emergency message after the error register.
enum class EmcyContent : std::uint8_t {
    listed_errors,  ///< byte 3: the number of errors in 1003h (error list; CAN-CBX-AO412, 7.9.4)
    detail          ///< bytes 3 and 4: the upper half of the error's entry in 1003h, 0 when the error ends (Axiomatic)
};

class Emcy {
  public:
    Emcy(ObjectDictionary& objects, TransmitQueue& queue, const ErrorTable& errors, const ErrorList list,
         const EmcyContent content) noexcept
        : objects_{objects}, queue_{queue}, errors_{errors}, list_{list}, content_{content} {}

    /// Sets the node-ID with which the node boots. Without 1014h COB-ID EMCY it determines the identifier of the
    /// emergency messages.
    void set_node_id(const std::uint8_t node_id) noexcept { node_id_ = node_id; }
    /// Clears active errors, the error list and the waiting messages: the state after power-on and NMT reset node.
    /// Messages wait for enable(), because the boot-up message empties the queue.
    void reset() noexcept;
    /// Restores 1001h after a reset of the communication area has set 1001h and 1014h to their defaults. The error list
    /// 1003h stays as it is if it lists active errors (ErrorList::active); a history is cleared. Waiting messages are
    /// dropped if 1014h COB-ID EMCY is not valid; otherwise they wait for enable().
    void refresh() noexcept;
    /// Begins or ends a lasting error; does nothing if the error has this state already, or if the device does not have
    /// this error. When the error begins, `channel` (for example the node-ID of a lost heartbeat) is combined
    /// by OR with the low byte of the detail that the error table has for this error.
    void set(ErrorId error, bool present, Instant now, std::uint8_t channel = 0U) noexcept;
    /// Reports an error that is already over: lists it in 1003h and sends its message, as its row in the error table
    /// demands. The error never becomes active.
    void report(ErrorId error, Instant now) noexcept;
    bool is_active(const ErrorId error) const noexcept { return is_active(static_cast<std::size_t>(error)); }

    /// Takes back the messages that are in the transmit queue, because the caller is about to drop all frames of the
    /// queue. They wait again, before the messages that wait already.
    void take_back() noexcept;
    /// Permits or stops sending. The node permits it in pre-operational and operational only, and not in bus-off or
    /// while LSS changes the bit rate. While sending is stopped, messages wait.
    void enable(bool enabled, Instant now) noexcept;
    void advance(const Instant now) noexcept {
        if (enabled_ && (pending_count_ != 0U)) {
            send_pending(now);
        }
    }
    Instant next_deadline() const noexcept {
        if (register_changed_) {
            return Instant{};
        }
        const bool waits = enabled_ && (pending_count_ != 0U);
        return waits ? may_send_at_ : never;
    }
    /// Returns whether 1001h error register has changed since the last call of this function; a TPDO may carry it.
    bool take_register_change() noexcept {
        const bool changed = register_changed_;
        register_changed_ = false;
        return changed;
    }

    AbortCode before_write(const EntryRef& entry, std::uint32_t value) const noexcept;
    void after_write(const EntryRef& entry) noexcept;

    /// Returns whether the invariant between two calls holds (properties/invariants): only errors of the error table
    /// are active or have a waiting message, and 1003h (error list) has at most its full length.
    bool is_consistent() const noexcept;

  private:
    /// A waiting message. Its COB-ID, 1001h (error register), the number of listed errors and the detail are taken at
    /// the moment of sending.
    struct Pending {
        std::uint8_t error{0U};
        bool cured{false};
    };
    /// A side of the waiting messages: before the oldest or behind the newest one.
    enum class Side : std::uint8_t { oldest, newest };
    /// At most two messages wait for each error; see add_waiting().
    static constexpr std::size_t pending_capacity = 2U * max_errors;

    void send_pending(Instant now) noexcept;
    void announce(std::size_t error, bool cured, Instant now) noexcept;
    void add_waiting(const Pending& told, Side side) noexcept;
    std::uint32_t cob_id_entry() const noexcept;
    void forget(std::size_t position) noexcept;
    Frame message(const Pending& told) const noexcept;
    void enter_into_list(std::uint32_t entry) noexcept;
    void remove_from_list(std::uint32_t entry) noexcept;
    bool is_active(const std::size_t error) const noexcept { return ((active_ >> error) & 1U) != 0U; }
    std::uint32_t list_entry(std::size_t error) const noexcept;
    std::uint8_t active_register() const noexcept;
    void show_register() noexcept;
    void clear_list() noexcept;
    void forget_when_switched_off() noexcept;
    std::uint8_t list_capacity() const noexcept;

    ObjectDictionary& objects_;
    TransmitQueue& queue_;
    const ErrorTable& errors_;
    ErrorList list_;
    EmcyContent content_;
    std::uint8_t node_id_{0U};
    bool enabled_{false};
    bool register_changed_{false};
    std::uint8_t shown_register_{0U};
    std::size_t pending_count_{0U};
    std::uint32_t queued_count_{0U};  ///< number of messages that went to the queue since reset()
    std::uint32_t queued_id_{0U};     ///< identifier of the last of them
    Instant may_send_at_{};
    std::uint64_t active_{0U};  ///< bit n is set while error n is active
    std::array<std::uint8_t, max_errors> channel_{};
    std::array<Pending, pending_capacity> pending_{};
    /// The latest messages that went to the transmit queue: a ring, because the queue sends them in this order.
    std::array<Pending, TransmitQueue::capacity> queued_{};
};

}  // namespace canproof
