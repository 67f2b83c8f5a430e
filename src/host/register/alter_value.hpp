// What a cell becomes when `canproof mutate` alters it: the nearest wrong value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// The next word of the domain, the first after the last; nothing when there is no other.
std::optional<std::string> other_word(const std::string& word, const std::vector<std::string>& words);
/// A boolean becomes its opposite, a whole number the next one of the type (the one before at its end), a real number
/// a hundredth more (0: 0.01). `type` is CiA's word. Texts give nothing.
Value other_value(const Value& value, const std::string& type);
/// As other_value(), one step up or down; nothing where the type ends, or for what is no number.
std::optional<Value> neighbour(const Value& value, const std::string& type, int step);
/// The bit pattern of a number or boolean in a C++ type: `float`, `double`, anything else as a whole number.
std::uint64_t bit_pattern(const Value& value, const std::string& cpp_type_name);

}  // namespace canproof::host
