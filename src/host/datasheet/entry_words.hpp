// SPDX-License-Identifier: Apache-2.0
// Describes an entry of the object dictionary as text: limits, range, index and sub-index.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the text of a limit that depends on another object: `4020h:1 - 100`.
std::string limit_name(const Entry& entry, const Limit& limit);
/// Returns the range of an entry as text: `0 … 10`, `2, 8` or `0, 10 … 65535`. Returns an empty text when only the type
/// limits the value.
std::string range_words(const Entry& entry);
/// Returns `VAR`, `ARRAY` or `RECORD`.
const char* kind_name(const Object& object);
/// Returns index and sub-index: `6411h:02`; for a VAR only the index: `1001h`.
std::string place_words(const Object& object, const Entry& entry);
/// Returns the length in bits of the entry's value in a PDO; 0 for a variable length.
unsigned mapped_bits(const Entry& entry);

}  // namespace canproof::host
