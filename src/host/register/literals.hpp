// SPDX-License-Identifier: Apache-2.0
// Compares values of the register with CiA types.
#pragma once

#include <optional>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns whether the type is REAL32 or REAL64.
bool is_real_type(const std::string& type);
/// Returns a number or a boolean as double; nothing for words.
std::optional<double> number_of(const Value& value);
/// Returns whether a number or boolean is a value of the type: a whole number within the limits of an integer type;
/// true, false, 0 or 1 for BOOLEAN.
bool fits_type(const Value& value, const std::string& type);
/// Returns a description of the type's values for a remedy: "a whole number from 0 to 255".
std::string type_words(const std::string& type);
/// Returns whether the text is usable as a name in the generated C++: letters, digits, underscores, no C++ keyword.
bool is_cpp_name(const std::string& name);
/// Returns a word of the register as an enumerator in snake_case. A keyword gets a trailing underscore, a leading digit
/// the prefix `n`.
std::string cpp_word(const std::string& word);

}  // namespace canproof::host
