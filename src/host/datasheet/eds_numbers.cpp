// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/eds_numbers.hpp"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstring>

#include "host/base/number_text.hpp"
#include "host/datasheet/ini.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

constexpr const char* node_id_word = "$nodeid";

/// Returns the text in lower case without its blanks.
std::string bare(std::string_view text) {
    std::string out{text};
    std::size_t length = 0;
    for (const char c : text) {
        if (c != ' ' && c != '\t') {
            out[length] = lower_case(c);
            ++length;
        }
    }
    out.resize(length);
    return out;
}

constexpr unsigned no_digit = 16;

/// The value of each hexadecimal digit, in upper or lower case, and `no_digit` for each other character.
constexpr std::array<std::uint8_t, 256> digit_values = [] {
    std::array<std::uint8_t, 256> values{};
    for (std::size_t c = 0; c < values.size(); ++c) {
        const bool decimal = c >= '0' && c <= '9';
        const char lower = lower_case(static_cast<char>(c));
        const bool letter = lower >= 'a' && lower <= 'f';
        values[c] = static_cast<std::uint8_t>(decimal  ? c - '0'
                                              : letter ? static_cast<unsigned>(lower - 'a') + 10U
                                                       : no_digit);
    }
    return values;
}();

unsigned digit_value(char c) {
    return digit_values[static_cast<unsigned char>(c)];
}

std::optional<unsigned> digit_of(char c, unsigned base) {
    const unsigned digit = digit_value(c);
    return digit < base ? std::optional{digit} : std::nullopt;
}

bool is_hexadecimal(std::string_view text) {
    return text.size() >= 2 && text[0] == '0' && lower_case(text[1]) == 'x';
}

/// Removes the suffixes of C, as in 10u and 0x10UL, because they have no meaning here. A text that consists of suffixes
/// gives an empty text.
std::string_view without_suffix(std::string_view text) {
    while (!text.empty() && (lower_case(text.back()) == 'u' || lower_case(text.back()) == 'l')) {
        text.remove_suffix(1);
    }
    return text;
}

std::optional<Value> real_value(const std::string& text, const std::string& type) {
    if (is_hexadecimal(text)) {
        const auto bits = eds_unsigned(text);
        if (!bits || (type == "REAL32" && *bits > UINT32_MAX)) {
            return std::nullopt;
        }
        double value = 0.0;
        if (type == "REAL32") {
            const auto narrow_bits = static_cast<std::uint32_t>(*bits);
            float narrow = 0.0F;
            std::memcpy(&narrow, &narrow_bits, sizeof narrow);
            value = double{narrow};
        } else {
            std::memcpy(&value, &*bits, sizeof value);
        }
        return std::isfinite(value) ? std::optional<Value>{value} : std::nullopt;
    }
    // removes the suffix of 1.5f
    const std::string number = text.size() > 1 && text.back() == 'f' ? text.substr(0, text.size() - 1) : text;
    const auto value = decimal_number(number);
    if (!value || (type == "REAL32" && std::abs(*value) > double{FLT_MAX})) {
        return std::nullopt;
    }
    return Value{*value};
}

using IntegerLimits = std::optional<std::pair<std::int64_t, std::int64_t>>;

std::optional<Value> integer_value(std::string_view text, const std::string& type, const IntegerLimits& limits) {
    const bool negative = !text.empty() && text.front() == '-';
    const auto magnitude = eds_unsigned(negative ? text.substr(1) : text);
    if (!magnitude) {
        return std::nullopt;
    }
    if (std::string_view{type} == "UNSIGNED64") {  // the requirements register stores the 64 bits in a signed number
        return negative ? std::nullopt : std::optional<Value>{static_cast<std::int64_t>(*magnitude)};
    }
    const bool pattern = !negative && limits && limits->first < 0 && is_hexadecimal(text);
    if (pattern && *magnitude > static_cast<std::uint64_t>(limits->second)) {
        const std::size_t bits = 8U * type_size(type);
        if (bits == 64U || (*magnitude >> bits) == 0U) {
            const std::uint64_t sign_extended = bits == 64U ? *magnitude : *magnitude | (~std::uint64_t{0} << bits);
            return Value{static_cast<std::int64_t>(sign_extended)};
        }
    }
    constexpr auto highest = static_cast<std::uint64_t>(INT64_MAX);
    if (*magnitude > highest) {
        const bool lowest = negative && *magnitude == highest + 1U && type == "INTEGER64";
        return lowest ? std::optional<Value>{std::int64_t{INT64_MIN}} : std::nullopt;
    }
    const auto value = static_cast<std::int64_t>(*magnitude) * (negative ? -1 : 1);
    return limits && value >= limits->first && value <= limits->second ? std::optional<Value>{value} : std::nullopt;
}

/// Returns whether the text is a decimal number of at most 18 digits, which always fits 64 bits with sign. Returns
/// false for a leading 0, which means an octal number.
bool is_short_decimal(std::string_view text) {
    constexpr std::size_t always_fit = 18;
    return !text.empty() && text.size() <= always_fit && (text.size() == 1 || text.front() != '0') &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::optional<std::uint64_t> number_of_digits(std::string_view digits, unsigned base) {
    constexpr std::size_t always_fit = 16;  // number of digits that fit 64 bits in base 8, 10 and 16
    const bool may_overflow = digits.size() > always_fit;
    std::uint64_t value = 0;
    for (const char c : digits) {
        const unsigned digit = digit_value(c);
        if (digit >= base || (may_overflow && value > (UINT64_MAX - digit) / base)) {
            return std::nullopt;
        }
        value = value * base + digit;
    }
    return digits.empty() ? std::nullopt : std::optional{value};
}

}  // namespace

std::optional<std::uint64_t> eds_unsigned(std::string_view text) {
    if (text.size() == 1) {  // most numbers of a data sheet have one digit
        return number_of_digits(text, 10U);
    }
    const std::string_view number = without_suffix(text);
    if (is_hexadecimal(number)) {
        return number_of_digits(number.substr(2), 16U);
    }
    const bool octal = number.size() > 1 && number.front() == '0';
    return number_of_digits(number, octal ? 8U : 10U);
}

std::optional<std::uint64_t> eds_hexadecimal(std::string_view digits) {
    return number_of_digits(without_suffix(digits), 16U);
}

std::optional<NodeIdTerm> split_node_id(std::string_view text) {
    if (text.find('$') == std::string_view::npos) {
        return NodeIdTerm{std::string{text}, false};
    }
    const std::string sum = bare(text);
    const std::string word = node_id_word;
    if (sum == word) {
        return NodeIdTerm{"0", true};
    }
    if (sum.rfind(word + "+", 0) == 0) {
        return NodeIdTerm{sum.substr(word.size() + 1), true};
    }
    const std::string tail = "+" + word;
    if (sum.size() > tail.size() && sum.compare(sum.size() - tail.size(), tail.size(), tail) == 0) {
        return NodeIdTerm{sum.substr(0, sum.size() - tail.size()), true};
    }
    return std::nullopt;
}

std::optional<Value> eds_value(std::string_view text, const std::string& type) {
    const bool is_boolean = std::string_view{type} == "BOOLEAN";
    const IntegerLimits limits = integer_limits(type);
    if (limits && !is_boolean && is_short_decimal(text)) {
        const auto whole = static_cast<std::int64_t>(number_of_digits(text, 10U).value_or(0U));
        return whole >= limits->first && whole <= limits->second ? std::optional<Value>{whole} : std::nullopt;
    }
    const std::string number = bare(text);
    if (is_boolean) {
        const auto truth = number == "true"    ? std::optional<std::uint64_t>{1}
                           : number == "false" ? std::optional<std::uint64_t>{0}
                                               : eds_unsigned(number);
        return truth && *truth <= 1U ? std::optional<Value>{*truth == 1U} : std::nullopt;
    }
    return is_real_type(type) ? real_value(number, type) : integer_value(number, type, limits);
}

std::optional<std::string> eds_octets(std::string_view text) {
    const std::string digits = bare(text);
    std::string out;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
        const auto high = digit_of(digits[i], 16U);
        const auto low = digit_of(digits[i + 1], 16U);
        if (!high || !low) {
            return std::nullopt;
        }
        out += static_cast<char>(static_cast<unsigned char>((*high << 4U) | *low));
    }
    return digits.size() % 2 == 0 ? std::optional{out} : std::nullopt;
}

}  // namespace canproof::host
