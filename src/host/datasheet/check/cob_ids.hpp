// COB-ID entries of CiA 301.
#pragma once

#include <cstdint>

#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Bit 31: the service is switched off.
bool is_off(std::uint64_t cob_id);
/// Bit 29: an identifier of 29 bits.
bool is_extended(std::uint64_t cob_id);
/// The identifier of 11 bits at this node-ID.
unsigned identifier(const EdsNumber& cob_id, unsigned node_id);
/// CiA 301: identifiers that no PDO, SYNC, TIME or EMCY may take.
bool is_reserved(unsigned identifier);

}  // namespace canproof::host
