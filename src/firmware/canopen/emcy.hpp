// Errors: the error register 1001h, the error list 1003h and the emergency messages that announce both (CiA
// 301, 7.2.7).
#pragma once

#include <array>

#include "firmware/base/time.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

/// The errors that a node can notice. Those up to `internal` are common to the devices; a device adds its own behind
/// them.
enum class ErrorId : std::uint8_t {
    can_overrun = 0U,
    error_passive = 1U,
    guard_or_heartbeat = 2U,
    bus_off_recovered = 3U,
    sync_length = 4U,
    stored_set_checksum = 5U,
    internal_software = 6U,
    rpdo_length = 7U,
    rpdo_timeout = 8U,
    first_of_device = 9U
};
constexpr std::size_t max_errors = 32U;

/// How one error is told. A row with code 0 says that the device does not know the error: it is then passed over in
/// silence.
struct ErrorRow {
    std::uint16_t code{0U};          ///< emergency error code
    std::uint8_t register_bits{0U};  ///< set in 1001h while the error lasts
    bool sent{false};                ///< announced by an emergency message
    bool listed{false};              ///< entered into 1003h
};
using ErrorTable = std::array<ErrorRow, max_errors>;

/// What 1003h keeps.
enum class ErrorList : std::uint8_t {
    history,  ///< every error that occurred, cured or not (CAN-CBX-AO412)
    active    ///< an error leaves the list when it is cured (Axiomatic)
};

class Emcy {
  public:
    Emcy(ObjectDictionary& objects, TransmitQueue& queue, const ErrorTable& errors, ErrorList list) noexcept
        : objects_{objects}, queue_{queue}, errors_{errors}, list_{list} {}

    /// Nothing active, nothing listed, nothing pending: the state after power-on and NMT reset node.
    void reset() noexcept;
    /// 1001h and 1003h were set to their defaults by a reset of the communication area: what is active shows again.
    void refresh() noexcept;
    /// A lasting error begins or ends. Telling the same twice does nothing.
    void set(ErrorId error, bool present, Instant now) noexcept;
    /// An error that is over when it is noticed: listed and sent, never active.
    void report(ErrorId error, Instant now) noexcept;
    bool is_active(ErrorId error) const noexcept;

    /// Emergency messages go out in pre-operational and operational only; what arises elsewhere waits.
    void enable(bool enabled, Instant now) noexcept;
    void advance(Instant now) noexcept;
    Instant next_deadline() const noexcept;

    AbortCode before_write(const EntryRef& entry, ByteView value) const noexcept;
    void after_write(const EntryRef& entry) noexcept;

  private:
    /// One message for each error that can be active, twice over: it occurred and was cured within one inhibit time.
    static constexpr std::size_t pending_capacity = 16U;

    void announce(std::uint16_t code, std::uint8_t register_value, Instant now) noexcept;
    void enter_into_list(std::uint16_t code) noexcept;
    void remove_from_list(std::uint16_t code) noexcept;
    std::uint8_t active_register() const noexcept;
    void clear_list() noexcept;
    std::uint8_t list_capacity() const noexcept;

    ObjectDictionary& objects_;
    TransmitQueue& queue_;
    const ErrorTable& errors_;
    ErrorList list_;
    std::array<bool, max_errors> active_{};
    std::array<Frame, pending_capacity> pending_{};
    std::size_t pending_count_{0U};
    Instant may_send_at_{};
    bool enabled_{false};
};

}  // namespace canproof
