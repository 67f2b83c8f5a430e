// SPDX-License-Identifier: Apache-2.0
// The factory values of one simulated unit, by the keys of `--factory KEY=VALUE`.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <type_traits>

#include "host/base/input_error.hpp"

namespace canproof::host {

class FactoryValues {
  public:
    void set_number(const std::string& key, double value) { numbers_[key] = value; }
    void set_text(const std::string& key, const std::string& value) { texts_[key] = value; }

    /// Stores the value of the key in `into`. If the key has no value, `into` stays unchanged. Throws InputError for a
    /// value that does not fit the type.
    template <typename Number>
    void take(const std::string& key, Number& into) const {
        const auto found = numbers_.find(key);
        if (found == numbers_.end()) {
            return;
        }
        const double value = found->second;
        const bool fits = std::isfinite(value) && value >= static_cast<double>(std::numeric_limits<Number>::lowest()) &&
                          value <= static_cast<double>(std::numeric_limits<Number>::max());
        if (!fits || (std::is_integral_v<Number> && value != std::floor(value))) {
            throw InputError{
                fmt::format("{}={} does not fit the type of the key; `canproof signals` lists the ranges", key, value)};
        }
        into = static_cast<Number>(value);
    }
    template <typename Number>
    void take(const std::string& key, std::optional<Number>& into) const {
        if (numbers_.count(key) != 0) {
            Number value{};
            take(key, value);
            into = value;
        }
    }
    /// Stores the text of the key in `into` as ASCII, padded with zeros. Throws InputError for a text that is too long.
    template <std::size_t Length>
    void take(const std::string& key, std::array<std::uint8_t, Length>& into) const {
        const auto given = text(key);
        if (!given) {
            return;
        }
        if (given->size() > Length) {
            throw InputError{
                fmt::format("{}={} is longer than {} characters; write a shorter text", key, *given, Length)};
        }
        into.fill(0U);
        for (std::size_t i = 0; i < given->size(); ++i) {
            into[i] = static_cast<std::uint8_t>((*given)[i]);
        }
    }
    /// Sets the part number if the user named the unit by it; an empty text if the user gave the name of the device.
    void set_part_number(const std::string& number) { part_number_ = number; }
    const std::string& part_number() const { return part_number_; }
    std::optional<std::string> text(const std::string& key) const {
        const auto found = texts_.find(key);
        return found == texts_.end() ? std::nullopt : std::optional<std::string>{found->second};
    }

  private:
    std::map<std::string, double> numbers_;
    std::map<std::string, std::string> texts_;
    std::string part_number_;
};

}  // namespace canproof::host
