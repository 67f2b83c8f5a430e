// SPDX-License-Identifier: Apache-2.0
#include "host/register/alter_value.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "host/register/literals.hpp"

namespace canproof::host {

std::optional<std::string> other_word(const std::string& word, const std::vector<std::string>& words) {
    const auto found = std::find(words.begin(), words.end(), word);
    if (words.size() < 2 || found == words.end()) {
        return std::nullopt;
    }
    return found + 1 == words.end() ? words.front() : *(found + 1);
}

std::optional<Value> neighbour(const Value& value, const std::string& type, int step) {
    if (is_real_type(type)) {
        const auto number = number_of(value);
        if (!number) {
            return std::nullopt;
        }
        const double hundredth = *number == 0.0 ? 0.01 : std::abs(*number) / 100.0;
        return Value{*number + step * hundredth};
    }
    const auto* whole = std::get_if<std::int64_t>(&value);
    const auto limits = integer_limits(type);
    if (whole == nullptr || !limits || (step > 0 && *whole >= limits->second) ||
        (step < 0 && *whole <= limits->first)) {
        return std::nullopt;
    }
    return Value{*whole + step};
}

Value other_value(const Value& value, const std::string& type) {
    if (const auto* truth = std::get_if<bool>(&value)) {
        return Value{!*truth};
    }
    if (type == "BOOLEAN") {
        return Value{number_of(value).value_or(0.0) == 0.0};
    }
    if (const auto up = neighbour(value, type, 1)) {
        return *up;
    }
    return neighbour(value, type, -1).value_or(Value{});
}

std::uint64_t bit_pattern(const Value& value, const std::string& cpp_type_name) {
    const double number = number_of(value).value_or(0.0);
    std::uint64_t bits = 0;
    if (cpp_type_name == "double") {
        std::memcpy(&bits, &number, sizeof number);
    } else if (cpp_type_name == "float") {
        const auto narrow = static_cast<float>(number);
        std::uint32_t half = 0;
        std::memcpy(&half, &narrow, sizeof narrow);
        bits = half;
    } else if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        bits = static_cast<std::uint64_t>(*whole);
    } else {
        bits = number != 0.0 ? 1U : 0U;
    }
    return bits;
}

}  // namespace canproof::host
