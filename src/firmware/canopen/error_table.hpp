// The errors of a node and how each is told: what the tables of a device fill (CiA 301, 7.2.7).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace canproof {

/// The errors that a node can notice by itself, named as in the tables of the register; a device adds its own from
/// `first_of_device` on. A device knows either guard_or_heartbeat, or life_guarding and the four consumers apart.
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
    heartbeat = 10U,  ///< of the producer of 1016h:1; those of the next three follow it
    heartbeat_1 = heartbeat,
    heartbeat_2 = 11U,
    heartbeat_3 = 12U,
    heartbeat_4 = 13U,
    rpdo_value = 14U,
    first_of_device = 15U
};
constexpr std::size_t max_errors = 48U;  ///< at most 64: what is active are the bits of one number

/// Error number `offset` behind `first`, such as the same fault of another channel.
constexpr ErrorId error_after(const ErrorId first, const std::size_t offset) noexcept {
    return static_cast<ErrorId>(static_cast<std::size_t>(first) + offset);
}

/// How one error is told. A row with code 0 says that the device does not know the error: it is then passed over in
/// silence.
struct ErrorRow {
    std::uint16_t code{0U};          ///< emergency error code
    std::uint8_t register_bits{0U};  ///< set in 1001h while the error lasts
    bool sent{false};                ///< announced by an emergency message
    bool listed{false};              ///< entered into 1003h
    std::uint16_t detail{0U};        ///< upper half of the entry in 1003h: Axiomatic's description << 8 | channel
};
using ErrorTable = std::array<ErrorRow, max_errors>;

constexpr std::size_t heartbeat_producers = 4U;  ///< those that ErrorId tells apart

/// Enters how one error is told. A lost heartbeat is told alike for each producer.
constexpr void put_error(ErrorTable& table, const ErrorId error, const ErrorRow& row) noexcept {
    const std::size_t copies = (error == ErrorId::heartbeat) ? heartbeat_producers : 1U;
    for (std::size_t i = 0U; i < copies; ++i) {
        table[static_cast<std::size_t>(error_after(error, i))] = row;
    }
}

}  // namespace canproof
