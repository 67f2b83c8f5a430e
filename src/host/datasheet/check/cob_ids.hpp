// SPDX-License-Identifier: Apache-2.0
// The bits of COB-ID entries (CiA 301).
#pragma once

#include <cstdint>

#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Returns whether bit 31 is set, which switches the service off.
bool is_off(std::uint64_t cob_id);
/// Returns whether bit 29 is set, which means an identifier of 29 bits.
bool is_extended(std::uint64_t cob_id);
/// Returns the 11-bit identifier that the entry gives for this node-ID.
unsigned identifier(const EdsNumber& cob_id, unsigned node_id);
/// Returns whether CiA 301 reserves the identifier: no PDO, SYNC, TIME or EMCY may use it.
bool is_reserved(unsigned identifier);

}  // namespace canproof::host
