// SPDX-License-Identifier: Apache-2.0
// The errors of a node and how each is reported. The tables of a device define this (CiA 301, 7.2.7).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace canproof {

/// The errors that a node detects itself, named as in the tables of the requirements register. A device adds its own
/// errors from `first_of_device` on. A device uses either guard_or_heartbeat, or life_guarding and heartbeat_1 to
/// heartbeat_4.
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
    life_guarding = 9U,
    heartbeat = 10U,  ///< lost heartbeat of the producer in 1016h:1; the next three belong to 1016h:2…4
    heartbeat_1 = heartbeat,
    heartbeat_2 = 11U,
    heartbeat_3 = 12U,
    heartbeat_4 = 13U,
    rpdo_value = 14U,
    first_of_device = 15U
};
/// Number of rows of an error table. It must not exceed 64, because a 64-bit number has a bit for each row.
constexpr std::size_t max_errors = 48U;

/// Returns the error `offset` numbers after `first`, for example the same fault of another channel.
constexpr ErrorId error_after(const ErrorId first, const std::size_t offset) noexcept {
    return static_cast<ErrorId>(static_cast<std::size_t>(first) + offset);
}

/// How one error is reported. Code 0 means that the device does not have this error: Emcy then ignores it.
struct ErrorRow {
    std::uint16_t code{0U};          ///< emergency error code
    std::uint8_t register_bits{0U};  ///< set in 1001h (error register) while the error lasts
    bool sent{false};                ///< reported by an emergency message
    bool listed{false};              ///< entered into 1003h (error list)
    /// Upper half of the entry in 1003h (error list). Axiomatic's devices: description << 8 | channel.
    std::uint16_t detail{0U};
};
using ErrorTable = std::array<ErrorRow, max_errors>;

constexpr std::size_t heartbeat_producers = 4U;  ///< number of heartbeat producers with an ErrorId of their own

/// Sets how one error is reported. The row of ErrorId::heartbeat is copied to the errors of all four producers.
constexpr void put_error(ErrorTable& table, const ErrorId error, const ErrorRow& row) noexcept {
    const std::size_t copies = (error == ErrorId::heartbeat) ? heartbeat_producers : 1U;
    for (std::size_t i = 0U; i < copies; ++i) {
        table[static_cast<std::size_t>(error_after(error, i))] = row;
    }
}

}  // namespace canproof
