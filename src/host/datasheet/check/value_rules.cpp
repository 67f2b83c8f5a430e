// SPDX-License-Identifier: Apache-2.0
// Checks DefaultValue, LowLimit and HighLimit against the data type and each other.
#include "host/datasheet/check/value_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "host/datasheet/eds_numbers.hpp"

namespace canproof::host {

namespace {

constexpr auto error = EdsSeverity::error;
constexpr auto warning = EdsSeverity::warning;
constexpr const char* default_source = "CiA 306, DefaultValue";
constexpr const char* limit_source = "CiA 306, LowLimit and HighLimit";
constexpr const char* number_source = "CiA 306, numbers";

using Kind = EdsDataType::Kind;

/// A number of any type. Whole numbers have a sign and a magnitude of 64 bits.
struct Number {
    bool negative{false};
    std::uint64_t magnitude{0};
    double real{0.0};
    bool is_real{false};

    bool operator<(const Number& other) const {
        if (is_real || other.is_real) {
            return as_real() < other.as_real();
        }
        if (negative != other.negative) {
            return negative;
        }
        return negative ? magnitude > other.magnitude : magnitude < other.magnitude;
    }
    double as_real() const { return is_real ? real : (negative ? -1.0 : 1.0) * static_cast<double>(magnitude); }
};

std::string without_blanks(std::string_view given) {
    std::string text{given};
    text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\t'; }), text.end());
    return text;
}

/// Parses any whole number. Returns nothing for any other text.
std::optional<Number> whole(std::string_view given) {
    const std::string text = without_blanks(given);
    const bool negative = !text.empty() && text.front() == '-';
    const auto magnitude = eds_unsigned(negative ? text.substr(1) : text);
    return magnitude ? std::optional{Number{negative && *magnitude != 0, *magnitude, 0.0, false}} : std::nullopt;
}

/// Returns the whole number as a value of the type; nothing when it does not fit. A hexadecimal number can be the bit
/// pattern of a negative value.
std::optional<Number> fitted(Number number, const EdsDataType& type, bool hexadecimal) {
    const std::uint64_t top = type.bits == 64 ? UINT64_MAX : (std::uint64_t{1} << type.bits) - 1;
    if (type.kind != Kind::integer) {
        return !number.negative && number.magnitude <= top ? std::optional{number} : std::nullopt;
    }
    const std::uint64_t half = top / 2 + 1;
    if (number.negative) {
        return number.magnitude <= half ? std::optional{number} : std::nullopt;
    }
    if (number.magnitude < half) {
        return number;
    }
    const std::uint64_t complement = top - number.magnitude + 1;
    return hexadecimal && number.magnitude <= top ? std::optional{Number{true, complement, 0.0, false}} : std::nullopt;
}

bool is_hexadecimal(std::string_view text) {
    return lower_case(without_blanks(text)).rfind("0x", 0) == 0;
}

class ValueCheck {
  public:
    ValueCheck(const EdsSheet& sheet, const EdsSheetEntry& entry, EdsFindings& findings)
        : sheet_{sheet}, entry_{entry}, type_{*entry.type}, findings_{findings} {}

    void check_default() {
        if (entry_.value == nullptr) {
            return;
        }
        const std::string_view text = entry_.value->text;
        switch (type_.kind) {
            case Kind::boolean:
                if (!eds_value(text, "BOOLEAN")) {
                    add("default-boolean", fmt::format("default {} of {} is neither 0 nor 1", text, entry_.title()));
                }
                return;
            case Kind::integer:
            case Kind::natural:
                check_whole_default(text);
                return;
            case Kind::real:
                if (!eds_value(text, type_.name)) {
                    add("default-real", fmt::format("default {} of {} is no {}", text, entry_.title(), type_.name));
                }
                check_spelling(*entry_.value);
                return;
            case Kind::octets:
                if (!eds_octets(text)) {
                    add("default-octets",
                        fmt::format("default of {} does not consist of pairs of hexadecimal digits", entry_.title()));
                }
                return;
            case Kind::text:
                if (text.find('"') == 0 && text.size() > 1 && text.back() == '"') {
                    add("default-quotes", fmt::format("default of {} is in quotation marks", entry_.title()));
                }
                return;
            default:
                return;
        }
    }

    void check_limits() {
        const auto low = limit("LowLimit");
        const auto high = limit("HighLimit");
        if (low && high && *high < *low) {
            findings_.add("limit-order", entry_.line_of("LowLimit"),
                          fmt::format("LowLimit of {} is above its HighLimit", entry_.title()));
            return;
        }
        const auto value = plain_default();
        if (value && ((low && *value < *low) || (high && *high < *value))) {
            findings_.add("default-outside-limits", entry_.value->line,
                          fmt::format("default {} of {} is outside its limits", entry_.value->text, entry_.title()));
        }
    }

  private:
    void add(const char* rule, std::string what) { findings_.add(rule, entry_.value->line, std::move(what)); }

    void check_whole_default(std::string_view text) {
        const auto term = split_node_id(text);
        if (!term) {
            add("default-node-id-form",
                fmt::format("default {} of {} contains $, but is no sum with $NODEID", text, entry_.title()));
            return;
        }
        const auto number = whole(term->rest);
        if (!number) {
            add("default-no-number", fmt::format("default {} of {} is not a number", text, entry_.title()));
            return;
        }
        if (!fitted(*number, type_, is_hexadecimal(term->rest))) {
            add("default-outside-type",
                fmt::format("default {} of {} does not fit {}", text, entry_.title(), type_.name));
        }
        if (!term->has_node_id) {
            check_spelling(*entry_.value);
            return;
        }
        const std::string plain = without_blanks(text);
        if (plain.front() != '$') {
            const std::size_t cut = plain.find('+');
            respell("default-node-id-order",
                    fmt::format("default {} of {} does not begin with $NODEID", text, entry_.title()),
                    "$NODEID+" + plain.substr(0, cut));
        } else if (plain.rfind("$NODEID", 0) != 0) {
            respell("default-node-id-case",
                    fmt::format("default {} of {} does not spell $NODEID in capital letters", text, entry_.title()),
                    "$NODEID" + plain.substr(std::string{"$NODEID"}.size()));
        }
    }

    /// Adds a finding about the spelling of the default. The fix of the finding replaces the default with `right`.
    void respell(const char* rule, std::string what, const std::string& right) {
        const EdsLine& line = sheet_.line(entry_.value->line);
        findings_.add(rule, entry_.value->line, std::move(what),
                      replace_line(entry_.value->line, line.name + "=" + right));
    }

    void check_spelling(const IniValue& value) {
        const std::string text = lower_case(without_blanks(value.text));
        const std::size_t sign = !text.empty() && text.front() == '-' ? 1 : 0;
        const bool digits = text.find_first_not_of("0123456789", sign) == std::string::npos;
        if (type_.is_whole() && digits && text.size() > sign + 1 && text[sign] == '0' &&
            text.find_first_not_of('0', sign) != std::string::npos) {
            findings_.add("number-octal", value.line,
                          fmt::format("the number {} of {} begins with 0, so it is octal", value.text, entry_.title()));
        }
        const auto last = text.find_last_not_of("ul");
        if (type_.is_whole() && last != std::string::npos && last + 1 < text.size() && whole(text)) {
            const EdsLine& line = sheet_.line(value.line);
            findings_.add("number-suffix", value.line,
                          fmt::format("the number {} of {} has a suffix of the C language", value.text, entry_.title()),
                          replace_line(value.line, line.name + "=" + without_blanks(value.text).substr(0, last + 1)));
        }
    }

    /// Returns the limit of this key as a number; nothing when the limit is absent, contains the node-ID, or does
    /// not fit the type. Reports a limit that is not a number of the type.
    std::optional<Number> limit(const char* key) {
        const IniValue* given = entry_.section->filled(key);
        if (given == nullptr) {
            return std::nullopt;
        }
        if (!type_.is_number()) {
            findings_.add("limit-type", given->line,
                          fmt::format("{} of {} has no meaning for a {}", key, entry_.title(), type_.name));
            return std::nullopt;
        }
        if (type_.kind == Kind::real) {
            const auto value = eds_value(given->text, type_.name);
            if (!value) {
                findings_.add("limit-no-number", given->line,
                              fmt::format("{} {} of {} is no {}", key, given->text, entry_.title(), type_.name));
                return std::nullopt;
            }
            return Number{false, 0, std::get<double>(*value), true};
        }
        const auto term = split_node_id(given->text);
        const auto number = term ? whole(term->rest) : std::nullopt;
        if (!number) {
            findings_.add("limit-no-number", given->line,
                          fmt::format("{} {} of {} is not a number", key, given->text, entry_.title()));
            return std::nullopt;
        }
        check_spelling(*given);
        const auto value = fitted(*number, type_, is_hexadecimal(given->text));
        if (!value) {
            findings_.add("limit-outside-type", given->line,
                          fmt::format("{} {} of {} does not fit {}", key, given->text, entry_.title(), type_.name));
        }
        return term->has_node_id ? std::nullopt : value;
    }

    /// Returns the default as a number. Returns nothing when the default is absent, is not a number of the type, or
    /// contains the node-ID.
    std::optional<Number> plain_default() const {
        if (entry_.value == nullptr || entry_.value->text.find('$') != std::string::npos) {
            return std::nullopt;
        }
        if (type_.kind == Kind::real) {
            const auto value = eds_value(entry_.value->text, type_.name);
            return value ? std::optional{Number{false, 0, std::get<double>(*value), true}} : std::nullopt;
        }
        const auto number = type_.is_whole() ? whole(entry_.value->text) : std::nullopt;
        return number ? fitted(*number, type_, is_hexadecimal(entry_.value->text)) : std::nullopt;
    }

    const EdsSheet& sheet_;
    const EdsSheetEntry& entry_;
    const EdsDataType& type_;
    EdsFindings& findings_;
};

}  // namespace

const std::vector<EdsRule>& value_rules() {
    static const std::vector<EdsRule> rules{
        {"default-no-number", error, "a default is not a number",
         "write a decimal number, or 0x and hexadecimal digits", default_source},
        {"default-outside-type", error, "a default does not fit its data type", "correct the value or the type",
         default_source},
        {"default-boolean", error, "the default of a BOOLEAN is neither 0 nor 1", "write 0 or 1", default_source},
        {"default-real", error, "the default of a real number is neither a decimal number nor its bits",
         "write a decimal number, or the bits of IEEE 754 as 0x and hexadecimal digits", default_source},
        {"default-octets", error, "the default of an OCTET_STRING does not consist of pairs of hexadecimal digits",
         "write two hexadecimal digits for each octet", default_source},
        {"default-quotes", warning, "the default of a text is in quotation marks",
         "remove the quotation marks: they are part of the value", default_source},
        {"default-node-id-form", error, "a default with $ is no sum of $NODEID and a number", "write $NODEID+0x…",
         "CiA 306, $NODEID"},
        {"default-node-id-order", warning, "$NODEID is not at the beginning of a sum", "write $NODEID+0x…",
         "CiA 306, $NODEID"},
        {"default-node-id-case", warning, "$NODEID is not in capital letters", "write $NODEID", "CiA 306, $NODEID"},
        {"default-outside-limits", error, "a default is outside the limits of its entry",
         "correct the default or the limits", limit_source},
        {"number-octal", warning, "a number begins with 0, so it is octal",
         "remove the leading zeros, unless you mean an octal number", number_source},
        {"number-suffix", warning, "a number has a suffix of the C language", "remove the suffix", number_source},
        {"limit-no-number", error, "a limit is not a number", "write a decimal number, or 0x and hexadecimal digits",
         limit_source},
        {"limit-outside-type", error, "a limit does not fit its data type", "correct the limit or the type",
         limit_source},
        {"limit-order", error, "LowLimit is above HighLimit", "exchange or correct the two limits", limit_source},
        {"limit-type", warning, "an entry has a limit, but its data type is not numeric", "remove the limit",
         limit_source}};
    return rules;
}

void check_value(const EdsSheet& sheet, EdsFindings& findings) {
    for (const auto& [index, object] : sheet.objects()) {
        const EdsSheetEntry* described = nullptr;
        for (const EdsSheetEntry& entry : object.entries) {
            const bool again = described != nullptr && described->compact && entry.value == described->value;
            described = entry.compact ? &entry : nullptr;
            if (entry.type == nullptr || again) {
                continue;
            }
            ValueCheck check{sheet, entry, findings};
            check.check_default();
            check.check_limits();
        }
    }
}

}  // namespace canproof::host
