// SPDX-License-Identifier: Apache-2.0
// Describes an entry of a dictionary in words: its limits and its range.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns `4020h:1 - 100` for a limit that depends on another object.
std::string limit_name(const Entry& entry, const Limit& limit);
/// Returns `0 … 10`, `2, 8` or `0, 10 … 65535`; empty when only the type limits the value.
std::string range_words(const Entry& entry);
/// Returns `VAR`, `ARRAY` or `RECORD`.
const char* kind_name(const Object& object);
/// Returns `6411h:02`; for a VAR `1001h`.
std::string place_words(const Object& object, const Entry& entry);
/// Returns the bits of a value in a PDO; 0 for a variable length.
unsigned mapped_bits(const Entry& entry);

}  // namespace canproof::host
