// SPDX-License-Identifier: Apache-2.0
// The altered value of a cell for `canproof mutate`: the nearest wrong value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the next word of the domain, and the first word for the last one; nothing when there is no other word.
std::optional<std::string> other_word(const std::string& word, const std::vector<std::string>& words);
/// Returns an altered value. A boolean becomes its opposite, a whole number the next one of the type (the one before at
/// the upper limit), a real number grows by a hundredth (0 becomes 0.01). `type` is a CiA type. A text gives no value.
Value other_value(const Value& value, const std::string& type);
/// Returns a value one step above or below, with the steps of other_value(); nothing at a limit of the type, or for a
/// value that is not a number.
std::optional<Value> neighbour(const Value& value, const std::string& type, int step);
/// Returns the bit pattern of a number or boolean in a C++ type: `float`, `double`; any other type is a whole number.
std::uint64_t bit_pattern(const Value& value, const std::string& cpp_type_name);

}  // namespace canproof::host
