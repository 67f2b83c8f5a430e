// SPDX-License-Identifier: Apache-2.0
#include "host/base/time_text.hpp"

#include <fmt/format.h>

#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

constexpr std::uint64_t micros = 1000000;
constexpr std::size_t most_whole_digits = 12;
constexpr std::size_t most_decimals = 6;

/// Parses a decimal number of at most eighteen digits; the callers keep this limit. Returns nothing for an empty text
/// and when a character is no digit.
std::optional<std::uint64_t> decimal(std::string_view digits) {
    std::uint64_t value = 0;
    for (const char c : digits) {
        if (c < '0' || c > '9') {
            return std::nullopt;
        }
        value = 10U * value + static_cast<std::uint64_t>(c - '0');
    }
    return digits.empty() ? std::nullopt : std::optional{value};
}

}  // namespace

std::optional<Instant> seconds_of(std::string_view text) {
    const auto point = text.find('.');
    const std::string_view whole = text.substr(0, point);
    const std::string_view fraction = point == std::string_view::npos ? "0" : text.substr(point + 1);
    if (whole.size() > most_whole_digits || fraction.size() > most_decimals) {
        return std::nullopt;
    }
    const auto seconds = decimal(whole);
    auto rest = decimal(fraction);
    if (!seconds || !rest) {
        return std::nullopt;
    }
    for (std::size_t digits = fraction.size(); digits < most_decimals; ++digits) {
        *rest *= 10U;
    }
    return Instant{*seconds * micros + *rest};
}

Instant parse_seconds(const std::string& text, const std::string& where) {
    const std::optional<Instant> time = seconds_of(text);
    if (!time) {
        throw InputError{fmt::format(
            "{}: `{}` is no time in seconds with up to twelve digits and six decimals; write a time such as 12.345678",
            where, text)};
    }
    return *time;
}

void append_seconds(std::string& text, Instant time) {
    text += fmt::format_int{time.us / micros}.str();
    text += '.';
    // the sum puts a 1 before the six decimals, so that their leading zeros are kept
    const std::string decimals = fmt::format_int{micros + time.us % micros}.str();
    text.append(decimals, 1, most_decimals);
}

std::string format_seconds(Instant time) {
    std::string text;
    append_seconds(text, time);
    return text;
}

}  // namespace canproof::host
