// An entry of a dictionary in words: its limits, its range.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// `4020h:1 - 100` for a limit that another object gives.
std::string limit_name(const Entry& entry, const Limit& limit);
/// `0 … 10`, `2, 8` or `0, 10 … 65535`; empty where only the type limits the value.
std::string range_words(const Entry& entry);
/// `VAR`, `ARRAY` or `RECORD`.
const char* kind_name(const Object& object);
/// `6411h:02`, or `1001h` of a VAR.
std::string place_words(const Object& object, const Entry& entry);
/// Bits of a value in a PDO; 0 for a length that varies.
unsigned mapped_bits(const Entry& entry);

}  // namespace canproof::host
