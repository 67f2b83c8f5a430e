// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/pdo_communication.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "firmware/canopen/cob_id.hpp"
#include "firmware/canopen/pdo_mapping.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

namespace transmission = generated::canopen::transmission_type;

constexpr std::uint32_t cob_id_subindex = 1U;
constexpr std::uint32_t type_subindex = 2U;
constexpr std::uint32_t inhibit_subindex = 3U;
constexpr std::uint32_t event_subindex = 5U;
constexpr std::uint32_t sync_start_subindex = 6U;

/// Returns the COB-ID entry of PDO `number`; "not valid" when there is no such PDO.
std::uint32_t cob_id_entry(const ObjectDictionary& objects, const PdoDirection direction,
                           const std::size_t number) noexcept {
    const EntryRef found = objects.lookup(communication_object(direction, number), cob_id_subindex);
    return found.exists() ? static_cast<std::uint32_t>(objects.bits(*found.row)) : cob_id::not_valid;
}

/// Returns whether a valid PDO of `direction`, other than the one with object `but_index`, has this identifier.
bool is_taken(const ObjectDictionary& objects, const PdoDirection direction, const std::uint32_t identifier,
              const std::uint32_t but_index) noexcept {
    bool taken{false};
    for (std::size_t number = 0U; number < max_pdos; ++number) {
        const std::uint32_t entry = cob_id_entry(objects, direction, number);
        const bool other = communication_object(direction, number) != but_index;
        taken = taken || (other && cob_id::is_valid(entry) && (cob_id::identifier(entry) == identifier));
    }
    return taken;
}

static_assert(implements<req::CO_PDO_007> && implements<req::CO_PDO_026>);
AbortCode check_cob_id(const ObjectDictionary& objects, const PdoDirection direction, const std::uint16_t index,
                       const std::uint32_t current, const std::uint32_t wanted) noexcept {
    const std::uint32_t identifier = cob_id::identifier(wanted);
    constexpr std::uint32_t meant = cob_id::not_valid | cob_id::no_remote | cob_id::identifier_mask;
    static_assert(implements<req::CO_PDO_054>);
    if ((wanted & ~meant) != 0U) {
        return AbortCode::value_range;
    }
    if (!cob_id::is_valid(wanted)) {
        return AbortCode::none;  // the identifier of an invalid PDO is not restricted
    }
    static_assert(implements<req::CO_PDO_055>);
    if (cob_id::is_restricted(identifier)) {
        return AbortCode::value_range;
    }
    if (cob_id::is_valid(current) && (identifier != cob_id::identifier(current))) {
        return AbortCode::device_state;
    }
    // An identifier has only one sender on the bus (ISO 11898-1), so only receive PDOs may share one.
    const bool transmits = direction == PdoDirection::transmit;
    const bool collides = is_taken(objects, PdoDirection::transmit, identifier, index) ||
                          (transmits && is_taken(objects, PdoDirection::receive, identifier, index));
    return collides ? AbortCode::parameter_incompatible : AbortCode::none;
}

static_assert(implements<req::CO_PDO_008> && implements<req::CO_T_TRANSMISSION_TYPE>);
AbortCode check_type(const PdoDirection direction, const std::uint32_t type) noexcept {
    const auto* const row = transmission::find(type);
    const bool refused = (direction == PdoDirection::receive)
                             ? (cell_or(row, &transmission::Row::applied, PdoApplied::refused) == PdoApplied::refused)
                             : (cell_or(row, &transmission::Row::sent, PdoSent::refused) == PdoSent::refused);
    return refused ? AbortCode::value_range : AbortCode::none;
}

static_assert(implements<req::CO_PDO_023> && implements<req::CO_PDO_024> && implements<req::CO_PDO_058>);
AbortCode check_communication_write(const ObjectDictionary& objects, const PdoDirection direction,
                                    const std::uint32_t current, const EntryRef& entry,
                                    const std::uint32_t value) noexcept {
    constexpr std::uint32_t max_sync_counter{240U};
    const AbortCode locked = cob_id::is_valid(current) ? AbortCode::device_state : AbortCode::none;
    switch (entry.row->subindex) {
        case cob_id_subindex:
            return check_cob_id(objects, direction, entry.index, current, value);
        case type_subindex:
            return check_type(direction, value);
        case inhibit_subindex:
            return locked;
        case sync_start_subindex:
            return (value > max_sync_counter) ? AbortCode::value_range : locked;
        default:
            return AbortCode::none;
    }
}

static_assert(implements<req::CO_PDO_009> && implements<req::CO_PDO_056>);
AbortCode check_mapping_write(const ObjectDictionary& objects, const PdoDirection direction,
                              const std::uint32_t current, const EntryRef& entry, const std::uint32_t value) noexcept {
    // The order by CiA 301, 7.5.2.36: disable the PDO, set sub-index 0 to 0, write the entries, set sub-index 0 to
    // their number, enable the PDO.
    const std::uint32_t right = mapping_right(direction);
    if (cob_id::is_valid(current)) {
        return AbortCode::device_state;
    }
    if (entry.row->subindex == 0U) {
        return check_mapping_count(objects, right, entry.index, value & 0xFFU);
    }
    return (objects.read(entry.index, 0U) != 0U) ? AbortCode::device_state : check_mapping_entry(objects, right, value);
}

}  // namespace

void read_pdo_parameters(const ObjectDictionary& objects, const PdoDirection direction, const std::size_t number,
                         PdoParameters& read) noexcept {
    const std::uint16_t index = communication_object(direction, number);
    const std::uint32_t entry = cob_id_entry(objects, direction, number);
    read.identifier = cob_id::identifier(entry);
    read.valid = cob_id::is_valid(entry);
    read.remote_allowed = (entry & cob_id::no_remote) == 0U;
    read.type = static_cast<std::uint8_t>(objects.read(index, type_subindex));
    read.sync_start = static_cast<std::uint8_t>(objects.read(index, sync_start_subindex));
    read.inhibit = hundreds_of_microseconds(objects.read(index, inhibit_subindex));
    read.event = milliseconds(objects.read(index, event_subindex));
    const auto* const row = transmission::find(read.type);
    read.applied = cell_or(row, &transmission::Row::applied, PdoApplied::refused);
    read.sent = cell_or(row, &transmission::Row::sent, PdoSent::refused);
}

AbortCode check_pdo_write(const ObjectDictionary& objects, const EntryRef& entry, const std::uint32_t value) noexcept {
    const bool transmits = pdo_number(PdoDirection::transmit, entry.index) < max_pdos;
    const PdoDirection direction = transmits ? PdoDirection::transmit : PdoDirection::receive;
    const std::size_t number = pdo_number(direction, entry.index);
    if (number == max_pdos) {
        return AbortCode::none;
    }
    const std::uint32_t current = cob_id_entry(objects, direction, number);
    return ((entry.index & mapping_offset) == 0U) ? check_communication_write(objects, direction, current, entry, value)
                                                  : check_mapping_write(objects, direction, current, entry, value);
}

}  // namespace canproof
