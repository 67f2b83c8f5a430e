// SPDX-License-Identifier: Apache-2.0
// Compares values of the register with CiA types.
#pragma once

#include <optional>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns whether the type is REAL32 or REAL64.
bool is_real_type(const std::string& type);
/// Returns a number or a boolean as double; nothing for a text.
std::optional<double> number_of(const Value& value);
/// Returns whether a value is of the type. An integer type requires a whole number within its limits, a real type a
/// finite number within its limits, and BOOLEAN requires true, false, 0 or 1. Returns false for every other type.
bool fits_type(const Value& value, const std::string& type);
/// Returns the values of the type in words for the fix of a fault: "a whole number from 0 to 255".
std::string type_words(const std::string& type);
/// Returns whether the text can be a name in the generated C++: it begins with a letter, consists of letters, digits
/// and underscores, and is no C++ keyword.
bool is_cpp_name(const std::string& name);
/// Returns a word of the register as an enumerator in snake_case. A keyword gets an underscore at its end; a word that
/// begins with a digit gets the prefix `n`.
std::string cpp_word(const std::string& word);

}  // namespace canproof::host
