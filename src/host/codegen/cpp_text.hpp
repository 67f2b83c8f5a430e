// SPDX-License-Identifier: Apache-2.0
// The C++ spelling of the register's types, values and comments.
#pragma once

#include <cstdint>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Whether a running program can alter the generated cells. Only the test programs of `canproof mutate` can.
enum class Cells { constant, changeable };
/// Returns `inline constexpr`; `inline` for changeable cells.
const char* storage_words(Cells cells);

/// Returns the first lines of a generated file, with the source files in the register.
std::string heading(const Part& part);
/// Returns a value as a literal of a type that cpp_type() returns: `12U`, `-3`, `4.096F`. With `hexadecimal`, an
/// unsigned value is `0x1FFU`.
std::string cpp_literal(const Value& value, const std::string& cpp_type_name, bool hexadecimal = false);
/// Returns the narrowest standard integer type that represents both values.
std::string cpp_integer_type(std::int64_t low, std::int64_t high);
/// Returns the comment above an item in generated code: text, id, sources, unit.
std::string item_comment(const Item& item, const std::string& unit);
/// Returns the C++ type of a CiA type: `std::uint16_t` for UNSIGNED16 …
std::string cpp_type(const std::string& cia_type);

}  // namespace canproof::host
