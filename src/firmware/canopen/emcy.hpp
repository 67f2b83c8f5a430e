// Errors: the error register 1001h, the error list 1003h and the emergency messages that announce both (CiA
// 301, 7.2.7).
#pragma once

#include <array>

#include "firmware/base/time.hpp"
#include "firmware/canopen/error_table.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

/// What 1003h keeps.
enum class ErrorList : std::uint8_t {
    history,  ///< every error that occurred, cured or not (CAN-CBX-AO412)
    active    ///< an error leaves the list when it is cured (Axiomatic)
};

/// What an emergency message holds behind the error register.
enum class EmcyContent : std::uint8_t {
    listed_errors,  ///< byte 3: the number of errors in 1003h (CAN-CBX-AO412, 7.9.4)
    detail          ///< bytes 3 and 4: the upper half of the entry in 1003h, as it stands there (Axiomatic)
};

class Emcy {
  public:
    Emcy(ObjectDictionary& objects, TransmitQueue& queue, const ErrorTable& errors, const ErrorList list,
         const EmcyContent content) noexcept
        : objects_{objects}, queue_{queue}, errors_{errors}, list_{list}, content_{content} {}

    /// The node boots with this node-ID: where there is no 1014h it decides the identifier.
    void set_node_id(const std::uint8_t node_id) noexcept { node_id_ = node_id; }
    /// Nothing active, nothing listed, nothing pending: the state after power-on and NMT reset node. Messages wait for
    /// enable(), since the boot-up message empties the queue.
    void reset() noexcept;
    /// A reset of the communication area set 1001h and 1014h to their defaults: what is active shows again. A list of
    /// active errors stays as it is; a history begins anew. Messages wait for enable() here as well.
    void refresh() noexcept;
    /// A lasting error begins or ends. Telling the same twice does nothing. `channel` is added to the detail of the row
    /// when the error begins: the node-ID of a lost heartbeat.
    void set(ErrorId error, bool present, Instant now, std::uint8_t channel = 0U) noexcept;
    /// An error that is over when it is noticed: listed and sent, never active.
    void report(ErrorId error, Instant now) noexcept;
    bool is_active(const ErrorId error) const noexcept { return is_active(static_cast<std::size_t>(error)); }

    /// Emergency messages go out in pre-operational and operational only; what arises elsewhere waits.
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
    /// Whether 1001h has changed since the last call: it may be mapped into a TPDO.
    bool take_register_change() noexcept {
        const bool changed = register_changed_;
        register_changed_ = false;
        return changed;
    }

    AbortCode before_write(const EntryRef& entry, std::uint32_t value) const noexcept;
    void after_write(const EntryRef& entry) noexcept;

  private:
    /// A message that waits. Its COB-ID, 1001h, the number of listed errors and the detail are those of the moment when
    /// it is sent.
    struct Pending {
        std::uint8_t error{0U};
        bool cured{false};
    };
    /// For no error more than two messages wait, see announce().
    static constexpr std::size_t pending_capacity = 2U * max_errors;

    void send_pending(Instant now) noexcept;
    void announce(std::size_t error, bool cured, Instant now) noexcept;
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
    std::uint64_t active_{0U};  ///< bit n: error n
    std::array<std::uint8_t, max_errors> channel_{};
    std::array<Pending, pending_capacity> pending_{};
    std::size_t pending_count_{0U};
    Instant may_send_at_{};
    std::uint8_t node_id_{0U};
    bool enabled_{false};
    bool register_changed_{false};
    std::uint8_t shown_register_{0U};
};

}  // namespace canproof
