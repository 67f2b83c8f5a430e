// SPDX-License-Identifier: Apache-2.0
// Describes entries of an object dictionary as text: their names and values.
#pragma once

#include <cstdint>
#include <string>

#include "firmware/base/bytes.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns an entry of the device `part` in the requirements register; nullptr when `part` is nullptr or has no such
/// entry.
const Entry* entry_at(const Part* part, std::uint16_t index, std::uint8_t subindex);

/// Returns the entry as text: `4020h:1 TC 1 High Shutdown Threshold`. For an unknown entry, returns only index and
/// sub-index. For an object with one value, leaves out `:0`.
std::string entry_words(const Part* part, std::uint16_t index, std::uint8_t subindex);

/// Returns little-endian bytes as a value of the entry's type. Returns hexadecimal digits when the type is unknown or
/// has another length.
std::string value_words(const Entry* entry, ByteView bytes);

}  // namespace canproof::host
