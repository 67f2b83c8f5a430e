// SPDX-License-Identifier: Apache-2.0
// COB-ID entries: the identifier of a communication object and the flags beside it (CiA 301, 7.5.2).
#pragma once

#include <cstdint>

#include "firmware/canopen/vocabulary.hpp"

namespace canproof::cob_id {

constexpr std::uint32_t not_valid = 0x80000000U;      ///< bit 31: the communication object does not exist
constexpr std::uint32_t no_remote = 0x40000000U;      ///< bit 30 of a PDO's COB-ID: no RTR on this identifier
constexpr std::uint32_t produces_sync = 0x40000000U;  ///< bit 30 of 1005h (COB-ID SYNC)
constexpr std::uint32_t identifier_mask = 0x7FFU;

constexpr std::uint32_t identifier(const std::uint32_t entry) noexcept {
    return entry & identifier_mask;
}
constexpr bool is_valid(const std::uint32_t entry) noexcept {
    return (entry & not_valid) == 0U;
}

/// Returns whether no configurable object may use the identifier: CiA 301 (Table 40) restricts it, for example for NMT,
/// SDO, error control or LSS, or it is above 7FFh. `identifier` must be at most FFFFh.
bool is_restricted(std::uint32_t identifier) noexcept;

/// Checks a new value of 1005h COB-ID SYNC or 1014h COB-ID EMCY. Returns 06090030h if the identifier is restricted, or
/// if `wanted` sets a bit that is neither in `flags` nor in the 11-bit identifier. Returns 08000022h if `wanted`
/// changes the identifier of an object in use; this is allowed only if `wanted` also sets bit 31 and `flags` contains
/// this bit. Returns AbortCode::none otherwise.
AbortCode check_change(std::uint32_t current, std::uint32_t wanted, std::uint32_t flags, bool in_use) noexcept;

}  // namespace canproof::cob_id
