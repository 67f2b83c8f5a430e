// SPDX-License-Identifier: Apache-2.0
// Alters values of generated tables for `canproof mutate`: each value becomes a wrong one close to it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the word that follows `word` in the list; after the last word, the first. Returns nothing when the list has
/// no other word or does not contain `word`.
std::optional<std::string> other_word(const std::string& word, const std::vector<std::string>& words);
/// Returns an altered value. A boolean becomes its opposite. A whole number becomes the next number of the type, and
/// the highest number becomes the one before it. A real number becomes larger by a hundredth of its magnitude, and 0
/// becomes 0.01. `type` is a CiA type. Returns an empty value for a text.
Value other_value(const Value& value, const std::string& type);
/// Returns the value one step above (`step` 1) or below (-1). A step is as large as in other_value(). Returns nothing
/// when an integer is at the limit of its type, and for a value that is not a number.
std::optional<Value> neighbour(const Value& value, const std::string& type, int step);
/// Returns the bits of a number or boolean in a C++ type: as `float`, as `double`, or, for any other type, as a whole
/// number.
std::uint64_t bit_pattern(const Value& value, const std::string& cpp_type_name);

}  // namespace canproof::host
