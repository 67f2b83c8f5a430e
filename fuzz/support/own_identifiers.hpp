// SPDX-License-Identifier: Apache-2.0
// Returns the identifiers on which a device may send, according to its present dictionary.
#pragma once

#include <bitset>

#include "firmware/canopen/object_dictionary.hpp"

namespace canproof::fuzz {

using Identifiers = std::bitset<0x800>;

/// Returns the identifiers on which the device may send. Bit n of `answers_remote` is set if the device answers a
/// remote frame for RPDO n + 1, on the identifier of this RPDO.
inline Identifiers own_identifiers(const ObjectDictionary& objects, std::uint8_t node_id, std::uint8_t answers_remote) {
    constexpr std::uint32_t not_valid = 0x80000000U;
    constexpr std::uint32_t produces = 0x40000000U;  // bit 30 of 1005h (COB-ID SYNC): the device sends SYNC
    Identifiers own;
    own.set(0x7E4);  // identifier of LSS answers
    if (node_id == 0 || node_id > 127) {
        return own;
    }
    const auto id = [&objects](std::uint16_t index, std::uint8_t sub) { return objects.read(index, sub) & 0x7FFU; };
    own.set(0x580U + node_id);
    own.set(objects.has(0x100E, 0) ? id(0x100E, 0) : 0x700U + node_id);
    const bool has_emcy = objects.has(0x1014, 0);
    if (!has_emcy || (objects.read(0x1014, 0) & not_valid) == 0) {
        own.set(has_emcy ? id(0x1014, 0) : 0x080U + node_id);
    }
    if ((objects.read(0x1005, 0) & produces) != 0) {
        own.set(id(0x1005, 0));
    }
    for (std::uint16_t number = 0; number < 8; ++number) {
        const auto transmit = static_cast<std::uint16_t>(0x1800U + number);
        if (objects.has(transmit, 1) && (objects.read(transmit, 1) & not_valid) == 0) {
            own.set(id(transmit, 1));
        }
        const auto receive = static_cast<std::uint16_t>(0x1400U + number);
        if (((answers_remote >> number) & 1U) != 0 && (objects.read(receive, 1) & not_valid) == 0) {
            own.set(id(receive, 1));
        }
    }
    return own;
}

}  // namespace canproof::fuzz
