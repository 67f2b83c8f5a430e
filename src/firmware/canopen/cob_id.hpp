// COB-ID entries: the identifier of a communication object and what else its 32 bits say (CiA 301, 7.5.2).
#pragma once

#include <cstdint>

#include "firmware/canopen/vocabulary.hpp"

namespace canproof::cob_id {

constexpr std::uint32_t not_valid = 0x80000000U;      ///< bit 31: the object does not exist
constexpr std::uint32_t no_remote = 0x40000000U;      ///< bit 30 of a PDO: no RTR on this identifier
constexpr std::uint32_t produces_sync = 0x40000000U;  ///< bit 30 of 1005h
constexpr std::uint32_t identifier_mask = 0x7FFU;

constexpr std::uint32_t identifier(const std::uint32_t entry) noexcept {
    return entry & identifier_mask;
}
constexpr bool is_valid(const std::uint32_t entry) noexcept {
    return (entry & not_valid) == 0U;
}

/// Identifiers that CiA 301 keeps for NMT, SDO, error control and LSS: no configurable object may take them (Table 40).
bool is_restricted(std::uint32_t identifier) noexcept;

/// The common rule for a new value of 1005h, 1014h, 14xxh:1 and 18xxh:1: only the bits of `flags` beside an
/// unrestricted 11-bit identifier (06090030h), and no other identifier while the object is in use (08000022h).
AbortCode check_change(std::uint32_t current, std::uint32_t wanted, std::uint32_t flags, bool in_use) noexcept;

}  // namespace canproof::cob_id
