// SPDX-License-Identifier: Apache-2.0
// Expressions of the language of conformance cases. Each expression is parsed once and evaluated each time its step
// runs.
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

/// Parses an expression up to the first word that does not belong to it: `$cob | 0x80000000`, `600+N`. Throws
/// LanguageError.
Expression parse_expression(Scanner& line, Radix radix);
/// Parses a time or a sum. Stops before a comparison: parses `2 s` of `2 s >= 5`.
Expression parse_sum(Scanner& line);
/// Parses one operand with its unit: `5`, `100 ms`, `$x`, `($a + 1)`.
Expression parse_operand(Scanner& line, Radix radix);
/// Parses `$name` or `$name.field`, without operators.
Expression parse_variable(Scanner& line);
/// Parses `$name` or `$name.field`, or one byte of it: `$a[0]`.
Expression parse_indexed_variable(Scanner& line);
/// Parses the name after `->`, `as` or `let`. Throws LanguageError when there is none.
std::string parse_name(Scanner& line);

/// Returns the value of the expression as a number of microseconds. Throws BrokenCase when the number is negative.
std::uint64_t microseconds_of(const Expression& expression, const Scope& scope);

}  // namespace canproof::host::conform
