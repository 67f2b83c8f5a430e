// SPDX-License-Identifier: Apache-2.0
// The altered value of a cell for `canproof mutate`: the nearest wrong value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the word that follows `word` in the list; after the last word, the first. Returns nothing when there is no
/// other word.
std::optional<std::string> other_word(const std::string& word, const std::vector<std::string>& words);
/// Returns an altered value. A boolean becomes its opposite. A whole number becomes the next number of the type, and
/// the highest number becomes the one before it. A real number becomes larger by a hundredth, and 0 becomes 0.01.
/// `type` is a CiA type. For a text, returns an empty value.
Value other_value(const Value& value, const std::string& type);
/// Returns the value one step above or below, with the steps of other_value(). Returns nothing at a limit of the type,
/// and for a value that is not a number.
std::optional<Value> neighbour(const Value& value, const std::string& type, int step);
/// Returns the bits of a number or boolean in a C++ type: `float`, `double`, or, for any other name, a whole number.
std::uint64_t bit_pattern(const Value& value, const std::string& cpp_type_name);

}  // namespace canproof::host
