// How C++ spells the register's types, values and notes.
#pragma once

#include <cstdint>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Whether the written cells can be altered in a running program: only test programs of `canproof mutate` are built so.
enum class Cells { constant, changeable };
/// `inline constexpr`, or `inline` where cells are to be changeable.
const char* storage_words(Cells cells);

/// What opens a generated file: the files of the register that it was written from.
std::string heading(const Part& part);
/// `12U`, `-3`; `4.096F`: a value as a literal of a type that cpp_type() names; `0x1FFU` where it is unsigned and
/// hexadecimal is asked for.
std::string cpp_literal(const Value& value, const std::string& cpp_type_name, bool hexadecimal = false);
/// Narrowest standard integer type that holds both.
std::string cpp_integer_type(std::int64_t low, std::int64_t high);
/// What stands above an item in generated code: text, id, sources, unit.
std::string item_comment(const Item& item, const std::string& unit);
/// `std::uint16_t` for UNSIGNED16 …
std::string cpp_type(const std::string& cia_type);

}  // namespace canproof::host
