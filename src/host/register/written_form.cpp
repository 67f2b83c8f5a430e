// SPDX-License-Identifier: Apache-2.0
#include "host/register/written_form.hpp"

#include <algorithm>
#include <array>

namespace canproof::host {

namespace {

/// Returns whether each `d` of the pattern is a digit in the text, and each other character is the same.
bool matches(const std::string& text, const std::string& pattern) {
    return text.size() == pattern.size() &&
           std::equal(text.begin(), text.end(), pattern.begin(),
                      [](char one, char as) { return as == 'd' ? one >= '0' && one <= '9' : one == as; });
}

}  // namespace

bool is_date(const std::string& text) {
    if (!matches(text, "dddd-dd-dd")) {
        return false;
    }
    const int year = std::stoi(text.substr(0, 4));
    const int month = std::stoi(text.substr(5, 2));
    const int day = std::stoi(text.substr(8, 2));
    const bool leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    const std::array<int, 12> days{31, leap ? 29 : 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    return month >= 1 && month <= 12 && day >= 1 && day <= days.at(static_cast<std::size_t>(month) - 1);
}

bool is_hash(const std::string& text) {
    constexpr std::size_t length = 8;
    return text.size() == length && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

bool is_printable_ascii(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char one) { return one >= ' ' && one <= '~'; });
}

}  // namespace canproof::host
