// SPDX-License-Identifier: Apache-2.0
// The common part of receive and transmit PDOs: the communication parameters 14xxh and 18xxh, and the order in which a
// PDO is re-mapped (CiA 301, 7.5.2.35 to 7.5.2.38).
#pragma once

#include <array>

#include "firmware/base/time.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "firmware/canopen/pdo_mapping.hpp"
#include "generated/canopen/index.hpp"
#include "generated/canopen/tables.hpp"

namespace canproof {

enum class PdoDirection : std::uint8_t { receive, transmit };

/// PDO1…PDO8 of each direction: 1400h…1407h, 1800h…1807h. The devices here have at most four PDOs of a direction.
constexpr std::size_t max_pdos = 8U;

/// Distance from the index of a PDO's communication parameters to that of its mapping: 14xxh to 16xxh, 18xxh to 1Axxh.
constexpr std::uint32_t mapping_offset =
    generated::canopen::index::rpdo_mapping - generated::canopen::index::rpdo_communication;

/// Returns the communication parameter object of PDO `number` (0…max_pdos - 1); mapping_object() returns its mapping
/// object.
constexpr std::uint16_t communication_object(const PdoDirection direction, const std::size_t number) noexcept {
    namespace index = generated::canopen::index;
    const std::size_t first =
        (direction == PdoDirection::receive) ? index::rpdo_communication : index::tpdo_communication;
    return static_cast<std::uint16_t>(first + number);
}
constexpr std::uint16_t mapping_object(const PdoDirection direction, const std::size_t number) noexcept {
    return static_cast<std::uint16_t>(communication_object(direction, number) + mapping_offset);
}

/// Returns the right that an entry needs to be mapped into a PDO.
constexpr std::uint32_t mapping_right(const PdoDirection direction) noexcept {
    return (direction == PdoDirection::receive) ? rights::rpdo : rights::tpdo;
}

/// Returns the number (0…max_pdos - 1) of the PDO of `direction` to whose communication parameters or mapping the
/// object `index` belongs; max_pdos when it belongs to none.
constexpr std::size_t pdo_number(const PdoDirection direction, const std::uint16_t index) noexcept {
    constexpr std::uint32_t number_bits = max_pdos - 1U;
    const bool belongs = (index & ~(mapping_offset | number_bits)) == communication_object(direction, 0U);
    return belongs ? (index & number_bits) : max_pdos;
}

/// The meaning of a transmission type: when a receive PDO takes effect, and when a transmit PDO is sent.
using PdoApplied = generated::canopen::transmission_type::Applied;
using PdoSent = generated::canopen::transmission_type::Sent;

/// The values of one communication parameter object, read once after each change.
struct PdoParameters {
    std::uint32_t identifier{0U};
    bool valid{false};           ///< bit 31 of the COB-ID is clear
    bool remote_allowed{false};  ///< bit 30 of the COB-ID is clear
    std::uint8_t type{0U};
    std::uint8_t sync_start{0U};  ///< counter value of the SYNC from which SYNCs are counted; zero: any SYNC
    PdoApplied applied{PdoApplied::refused};
    PdoSent sent{PdoSent::refused};
    Duration inhibit{};  ///< least time between two transmissions
    Duration event{};    ///< longest time between two transmissions or receptions; zero: no limit
};

/// Returns the highest PDO number of a direction in a dictionary, counted from 1; 0 when there is no PDO. PDOs with
/// lower numbers count even where they are absent.
constexpr std::size_t pdo_count(const DictionaryTables& tables, const PdoDirection direction) noexcept {
    const std::size_t first = communication_object(direction, 0U);
    std::size_t count{0U};
    for (const ObjectRow& object : tables.objects) {
        if ((object.index >= first) && (object.index < (first + max_pdos))) {
            count = (object.index - first) + 1U;
        }
    }
    return count;
}
/// Returns the greatest sub-index of all PDO objects, at most max_pdo_lines. It is an upper bound for the entries of a
/// mapping; communication parameters with more sub-indices count as well.
constexpr std::size_t pdo_lines(const DictionaryTables& tables) noexcept {
    std::size_t most{0U};
    for (const ObjectRow& object : tables.objects) {
        const bool maps = (pdo_number(PdoDirection::receive, object.index) < max_pdos) ||
                          (pdo_number(PdoDirection::transmit, object.index) < max_pdos);
        const std::size_t highest = tables.entries[(object.first_entry + std::size_t{object.count}) - 1U].subindex;
        most = (maps && (highest > most)) ? highest : most;
    }
    return (most < max_pdo_lines) ? most : max_pdo_lines;
}

/// Reads the communication parameters of PDO `number`; "not valid" when there is no such PDO.
void read_pdo_parameters(const ObjectDictionary& objects, PdoDirection direction, std::size_t number,
                         PdoParameters& read) noexcept;

/// Returns AbortCode::none when an entry of a PDO's communication parameters (14xxh, 18xxh) or mapping (16xxh, 1Axxh)
/// may be set to this value now, otherwise the reason.
AbortCode check_pdo_write(const ObjectDictionary& objects, const EntryRef& entry, std::uint32_t value) noexcept;

}  // namespace canproof
