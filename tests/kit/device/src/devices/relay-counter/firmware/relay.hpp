// SPDX-License-Identifier: Apache-2.0
// A relay of the RC-22.
#pragma once

#include <cstdint>

namespace canproof::relay_counter {

/// Returns whether a contact with this command (object 2000h: 0 or 1) is closed (RC:5).
bool contact_is_closed(std::uint8_t command, bool operational) noexcept;

}  // namespace canproof::relay_counter
