// Values of the register measured against CiA types.
#pragma once

#include <optional>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// REAL32 or REAL64.
bool is_real_type(const std::string& type);
/// A number or a boolean as double; nothing for words.
std::optional<double> number_of(const Value& value);
/// Whether a number or boolean is a value of the type: whole for integers, within its limits, true/false/0/1 for
/// BOOLEAN.
bool fits_type(const Value& value, const std::string& type);
/// "a whole number from 0 to 255": what `type` can hold, in words for a fix.
std::string type_words(const std::string& type);
/// May stand as a name in the generated C++: letters, digits, underscores, no C++ keyword.
bool is_cpp_name(const std::string& name);
/// A word of the register as an enumerator: snake_case; a keyword gets a trailing underscore, a leading digit an `n`.
std::string cpp_word(const std::string& word);

}  // namespace canproof::host
