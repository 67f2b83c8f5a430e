// SPDX-License-Identifier: Apache-2.0
// Theorems on writes to the mapping of a PDO, for the dictionary of the AX188001 with any values.
#include "firmware/canopen/pdo_mapping.hpp"

#include "firmware/canopen/pdo_communication.hpp"
#include "generated/ax188001/objects.hpp"
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

namespace {

namespace device = generated::ax188001;

/// The dictionary of the AX188001, which has receive and transmit PDOs. The prover considers all values of its entries.
struct AnyDictionary {
    std::array<std::uint8_t, device::image_size> image{any<std::array<std::uint8_t, device::image_size>>()};
    ObjectDictionary objects{device::tables, MutableBytes{image}, LimitAbort::range};
};

/// Returns the index of an object of RPDO1 or TPDO1; the prover proves the theorem for both. `offset` is counted from
/// the communication parameters (1400h or 1800h).
std::uint16_t any_pdo_object(const std::uint32_t offset) {
    const auto direction = static_cast<PdoDirection>(each(2U));
    return static_cast<std::uint16_t>(communication_object(direction, 0U) + offset);
}

}  // namespace

void a_mapping_entry_names_an_entry_that_may_be_mapped() {
    shows(
        "a mapping entry other than 0 is taken exactly when it is a dummy with the length of its type in an RPDO, or "
        "an existing entry with this right and its own length");
    proves<req::CO_PDO_010, req::CO_PDO_057>();
    AnyDictionary dictionary{};
    const auto entry = any<std::uint32_t>();
    const bool receives = each(2U) == 0U;
    const std::uint32_t right = receives ? rights::rpdo : rights::tpdo;
    const AbortCode code = check_mapping_entry(dictionary.objects, right, entry);
    const std::uint32_t index = entry >> 16U;
    const std::uint32_t bits = entry & 0xFFU;
    if (index <= 7U) {
        const std::array<std::uint32_t, 8U> of_type{0U, 1U, 8U, 16U, 32U, 8U, 16U, 32U};
        const bool is_dummy = receives && (((entry >> 8U) & 0xFFU) == 0U) && (bits != 0U) && (bits == of_type[index]);
        claim((code == AbortCode::none) == (is_dummy || (entry == 0U)));
        claim((code == AbortCode::none) || (code == AbortCode::not_mappable));
    } else {
        const EntryRef found = dictionary.objects.lookup(static_cast<std::uint16_t>(index),
                                                         static_cast<std::uint8_t>((entry >> 8U) & 0xFFU));
        const bool exists = found.exists();
        const bool fits =
            exists && found.may(right) &&
            (bits == ((found.row->type == DataType::boolean) ? 1U : (std::uint32_t{found.row->size} * 8U))) &&
            (bits != 0U);
        claim((code == AbortCode::none) == fits);
        claim(!exists || fits || (code == AbortCode::not_mappable));
        claim(exists || (code == AbortCode::object_missing) || (code == AbortCode::subindex_missing));
    }
}

void the_mapping_of_a_valid_pdo_is_locked() {
    shows("while a PDO is valid, each write to its mapping gets 08000022h, for any value and any dictionary values");
    proves<req::CO_PDO_009>();
    AnyDictionary dictionary{};
    const std::uint16_t communication = any_pdo_object(0U);
    const auto mapping = static_cast<std::uint16_t>(communication + mapping_offset);
    const std::uint8_t subindex = each(5U);
    const EntryRef entry = dictionary.objects.lookup(mapping, subindex);
    assume(entry.exists() && ((dictionary.objects.read(communication, 1U) & 0x80000000U) == 0U));
    claim(check_pdo_write(dictionary.objects, entry, any<std::uint32_t>()) == AbortCode::device_state);
}

void the_entries_of_a_mapping_in_use_are_locked() {
    shows("while sub-index 0 of a mapping is not 0, each write to its entries gets 08000022h");
    proves<req::CO_PDO_056>();
    AnyDictionary dictionary{};
    const std::uint16_t mapping = any_pdo_object(mapping_offset);
    const auto subindex = static_cast<std::uint8_t>(each(4U) + 1U);
    const EntryRef entry = dictionary.objects.lookup(mapping, subindex);
    assume(entry.exists() && (dictionary.objects.read(mapping, 0U) != 0U));
    claim(check_pdo_write(dictionary.objects, entry, any<std::uint32_t>()) == AbortCode::device_state);
}

void a_mapping_is_no_longer_than_a_frame() {
    shows("sub-index 0 of a mapping takes only a count of at most 64 bits, with up to two entries");
    proves<req::CO_PDO_011>();
    AnyDictionary dictionary{};
    const std::uint16_t mapping = any_pdo_object(mapping_offset);
    const std::uint32_t count = each(3U);
    const AbortCode code = check_mapping_count(dictionary.objects, rights::rpdo, mapping, count);
    std::uint32_t bits{0U};
    for (std::uint32_t line = 1U; line <= count; ++line) {
        bits += dictionary.objects.read(mapping, static_cast<std::uint8_t>(line)) & 0xFFU;
    }
    claim((code != AbortCode::none) || (bits <= 64U));
}

}  // namespace canproof::proofs
