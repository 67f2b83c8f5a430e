// A relay of the RC-22.
#pragma once

#include <cstdint>

#include "firmware/canopen/nmt.hpp"

namespace canproof::relay_counter {

/// Whether a contact with this command (2000h: 0 or 1) is closed in this state (RC:4).
bool contact_is_closed(std::uint8_t command, NmtState state) noexcept;

}  // namespace canproof::relay_counter
