// SPDX-License-Identifier: Apache-2.0
// Expressions of the case language: compiled once, evaluated each time the step runs.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "host/conform/language/scanner.hpp"
#include "host/conform/language/value.hpp"

namespace canproof::host::conform {

using Expression = std::function<Value(const Scope&)>;

/// The base of numbers without a prefix or suffix.
enum class Radix { decimal, hexadecimal };

/// Reads an expression as far as it goes: `$cob | 0x80000000`, `600+N`. Throws LanguageError.
Expression parse_expression(Scanner& line, Radix radix);
/// Reads a time or a sum; stops before a comparison, as in `for 2 s >= 5`.
Expression parse_sum(Scanner& line);
/// Reads one operand with its unit: `5`, `100 ms`, `$x`, `($a + 1)`.
Expression parse_operand(Scanner& line, Radix radix);
/// Reads `$name` or `$name.field`, without operators.
Expression parse_variable(Scanner& line);
/// Reads the same, or a byte of it: `$a[0]`.
Expression parse_indexed_variable(Scanner& line);
/// Reads a name after `->`, `as` or `let`. Fails when there is none.
std::string parse_name(Scanner& line);

/// Returns a number of microseconds, not negative. Throws BrokenCase.
std::uint64_t microseconds_of(const Expression& expression, const Scope& scope);

}  // namespace canproof::host::conform
