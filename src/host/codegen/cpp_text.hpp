// SPDX-License-Identifier: Apache-2.0
// The C++ spelling of the register's types, values and comments.
#pragma once

#include <cstdint>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Whether a running program can alter the cells (values in generated tables). Only the test programs for `canproof
/// mutate` can.
enum class Cells { constant, changeable };
/// Returns the words before a generated table: `inline constexpr` for constant cells, `inline` for changeable cells.
const char* storage_words(Cells cells);

/// Returns the first lines of a generated file, with the names of the files in the requirements register.
std::string heading(const Part& part);
/// Returns a value as a C++ literal of the type `cpp_type_name`, which cpp_type() or cpp_integer_type() returned:
/// `12U`, `-3`, `4.096F`. With `hexadecimal`, an unsigned value has the form `0x1FFU`.
std::string cpp_literal(const Value& value, const std::string& cpp_type_name, bool hexadecimal = false);
/// Returns the narrowest standard integer type that represents both `low` and `high`; an unsigned type if `low` is not
/// negative.
std::string cpp_integer_type(std::int64_t low, std::int64_t high);
/// Returns the comment above an item in generated code: text, id, sources, unit.
std::string item_comment(const Item& item, const std::string& unit);
/// Returns the C++ type of a numeric CiA type: `std::uint16_t` for UNSIGNED16 …
std::string cpp_type(const std::string& cia_type);

}  // namespace canproof::host
