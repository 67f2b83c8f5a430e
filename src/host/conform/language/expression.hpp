// Expressions of the case language: compiled once, evaluated each time the step runs.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "host/conform/language/scanner.hpp"
#include "host/conform/language/value.hpp"

namespace canproof::host::conform {

using Expression = std::function<Value(const Scope&)>;

/// How numbers without a mark are read.
enum class Radix { decimal, hexadecimal };

/// Reads as much as is an expression: `$cob | 0x80000000`, `600+N`. Throws LanguageError.
Expression parse_expression(Scanner& line, Radix radix);
/// A time or a sum: ends before a comparison, as in `for 2 s >= 5`.
Expression parse_sum(Scanner& line);
/// One operand with its unit: `5`, `100 ms`, `$x`, `($a + 1)`.
Expression parse_operand(Scanner& line, Radix radix);
/// `$name` or `$name.field`, without operators.
Expression parse_variable(Scanner& line);
/// The same, or a byte of it: `$a[0]`.
Expression parse_indexed_variable(Scanner& line);
/// A name behind `->`, `as` or `let`. Fails when there is none.
std::string parse_name(Scanner& line);

/// A number of microseconds, not negative. Throws BrokenCase.
std::uint64_t microseconds_of(const Expression& expression, const Scope& scope);

}  // namespace canproof::host::conform
