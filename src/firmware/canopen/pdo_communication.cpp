#include "firmware/canopen/pdo_communication.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "firmware/canopen/cob_id.hpp"
#include "firmware/canopen/pdo_mapping.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

namespace transmission = generated::canopen::t_co_t_transmission_type;

constexpr std::uint32_t cob_id_subindex = 1U;
constexpr std::uint32_t type_subindex = 2U;
constexpr std::uint32_t inhibit_subindex = 3U;
constexpr std::uint32_t event_subindex = 5U;
constexpr std::uint32_t sync_start_subindex = 6U;

constexpr std::uint16_t numbered(const std::uint16_t index, const std::size_t number) noexcept {
    return static_cast<std::uint16_t>(index + number);
}

/// The COB-ID entry; "not valid" where there is no such PDO.
std::uint32_t cob_id_entry(const ObjectDictionary& objects, const PdoDirection direction,
                           const std::size_t number) noexcept {
    const EntryRef found = objects.lookup(communication_object(direction, number), cob_id_subindex);
    return found.exists() ? static_cast<std::uint32_t>(objects.bits(found)) : cob_id::not_valid;
}

/// Whether another valid PDO of that direction has this identifier.
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

static_assert(implements<req::CO_PDO_006> && implements<req::CO_PDO_007> && implements<req::CO_PDO_026>);
AbortCode check_cob_id(const ObjectDictionary& objects, const PdoDirection direction, const std::uint16_t index,
                       const std::uint32_t current, const std::uint32_t wanted) noexcept {
    const std::uint32_t identifier = cob_id::identifier(wanted);
    constexpr std::uint32_t meant = cob_id::not_valid | cob_id::no_remote | cob_id::identifier_mask;
    if ((wanted & ~meant) != 0U) {
        return AbortCode::value_range;
    }
    if (!cob_id::is_valid(wanted)) {
        return AbortCode::none;  // an identifier that is not in use may be anything
    }
    if (cob_id::is_restricted(identifier)) {
        return AbortCode::value_range;
    }
    if (cob_id::is_valid(current) && (identifier != cob_id::identifier(current))) {
        return AbortCode::device_state;
    }
    // One identifier has one sender on the bus (ISO 11898-1), so that only receive PDOs can share theirs.
    const bool transmits = direction == PdoDirection::transmit;
    const bool collides = is_taken(objects, PdoDirection::transmit, identifier, index) ||
                          (transmits && is_taken(objects, PdoDirection::receive, identifier, index));
    return collides ? AbortCode::parameter_incompatible : AbortCode::none;
}

static_assert(implements<req::CO_PDO_008> && implements<req::CO_T_TRANSMISSION_TYPE>);
AbortCode check_type(const PdoDirection direction, const std::uint8_t type) noexcept {
    const auto* const row = transmission::find(type);
    const bool refused = (direction == PdoDirection::receive)
                             ? (cell_or(row, &transmission::Row::applied, PdoApplied::refused) == PdoApplied::refused)
                             : (cell_or(row, &transmission::Row::sent, PdoSent::refused) == PdoSent::refused);
    return refused ? AbortCode::value_range : AbortCode::none;
}

static_assert(implements<req::CO_PDO_023> && implements<req::CO_PDO_024>);
AbortCode check_communication_write(const ObjectDictionary& objects, const PdoDirection direction,
                                    const std::size_t number, const EntryRef& entry, const ByteView value) noexcept {
    constexpr std::uint32_t max_sync_counter{240U};
    const std::uint32_t current = cob_id_entry(objects, direction, number);
    const AbortCode locked = cob_id::is_valid(current) ? AbortCode::device_state : AbortCode::none;
    switch (entry.row->subindex) {
        case cob_id_subindex:
            return check_cob_id(objects, direction, entry.index, current, read_u32(value, 0U));
        case type_subindex:
            return check_type(direction, value[0]);
        case inhibit_subindex:
            return locked;
        case sync_start_subindex:
            return (value[0] > max_sync_counter) ? AbortCode::value_range : locked;
        default:
            return AbortCode::none;
    }
}

static_assert(implements<req::CO_PDO_009>);
AbortCode check_mapping_write(const ObjectDictionary& objects, const PdoDirection direction, const std::size_t number,
                              const EntryRef& entry, const ByteView value) noexcept {
    // CiA 301, 7.5.2.36: disable the PDO, set sub 0 to 0, write the entries, set sub 0, enable the PDO.
    const std::uint8_t right = family_of(direction).right;
    if (cob_id::is_valid(cob_id_entry(objects, direction, number))) {
        return AbortCode::device_state;
    }
    if (entry.row->subindex == 0U) {
        return check_mapping_count(objects, right, entry.index, value[0]);
    }
    return (objects.read(entry.index, 0U) != 0U) ? AbortCode::device_state
                                                 : check_mapping_entry(objects, right, read_u32(value, 0U));
}

}  // namespace

std::uint16_t communication_object(const PdoDirection direction, const std::size_t number) noexcept {
    return numbered(family_of(direction).communication, number);
}

std::uint16_t mapping_object(const PdoDirection direction, const std::size_t number) noexcept {
    return numbered(family_of(direction).mapping, number);
}

PdoParameters read_pdo_parameters(const ObjectDictionary& objects, const PdoDirection direction,
                                  const std::size_t number) noexcept {
    const std::uint16_t index = communication_object(direction, number);
    const std::uint32_t entry = cob_id_entry(objects, direction, number);
    PdoParameters read{};
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
    return read;
}

AbortCode check_pdo_write(const ObjectDictionary& objects, const EntryRef& entry, const ByteView value) noexcept {
    constexpr std::array<PdoDirection, 2U> directions{PdoDirection::receive, PdoDirection::transmit};
    for (const PdoDirection direction : directions) {
        const std::size_t number = pdo_number(direction, entry.index);
        if (number == max_pdos) {
            continue;
        }
        const bool communicates = std::uint32_t{entry.index} == communication_object(direction, number);
        return communicates ? check_communication_write(objects, direction, number, entry, value)
                            : check_mapping_write(objects, direction, number, entry, value);
    }
    return AbortCode::none;
}

}  // namespace canproof
