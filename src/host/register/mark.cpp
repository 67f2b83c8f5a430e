// SPDX-License-Identifier: Apache-2.0
#include "host/register/mark.hpp"

#include <algorithm>

#include "host/base/sha256.hpp"

namespace canproof::host {

namespace {

bool is_digit(const char c) {
    return c >= '0' && c <= '9';
}

bool is_hexadecimal_digit(const char c) {
    return is_digit(c) || (c >= 'a' && c <= 'f');
}

}  // namespace

std::string reduced(const std::string& passage) {
    std::string kept;
    for (const char c : passage) {
        if (c >= 'A' && c <= 'Z') {
            kept += static_cast<char>(c - 'A' + 'a');
        } else if ((c >= 'a' && c <= 'z') || is_digit(c)) {
            kept += c;
        }
    }
    return kept;
}

Mark mark_of(const std::string& passage) {
    const std::string kept = reduced(passage);
    return {kept.size(), sha256(kept).substr(0, Mark::hash_digits)};
}

std::optional<Mark> read_mark(const std::string& text) {
    const std::size_t colon = text.find(':');
    const std::string digits = text.substr(0, colon);
    constexpr std::size_t most_digits = 5;  // number of decimal digits of Mark::longest
    const bool is_number = !digits.empty() && digits.size() <= most_digits && digits.front() != '0' &&
                           std::all_of(digits.begin(), digits.end(), is_digit);
    const std::string hash = colon == std::string::npos ? "" : text.substr(colon + 1);
    if (!is_number || hash.size() != Mark::hash_digits ||
        !std::all_of(hash.begin(), hash.end(), is_hexadecimal_digit)) {
        return std::nullopt;
    }
    return Mark{std::stoul(digits), hash};
}

}  // namespace canproof::host
