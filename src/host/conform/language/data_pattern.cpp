// SPDX-License-Identifier: Apache-2.0
#include "host/conform/language/data_pattern.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "host/conform/language/expression.hpp"
#include "host/conform/language/object_reference.hpp"

namespace canproof::host::conform {

namespace {

const char* const forms_of_bytes =
    "write bytes such as 40, ??, 4?, C2|C6, %100xx000, $x:u32, @1017:00, ->name:u16 or ...";

struct BytePattern {
    unsigned mask{0};
    unsigned value{0};
};

/// Parses a byte in hexadecimal: `40`, `4?` or `??`. Returns whether the text has this form.
bool read_nibbles(const std::string& text, BytePattern& pattern) {
    if (text.size() != 2) {
        return false;
    }
    for (const char c : text) {
        const bool digit = std::isxdigit(static_cast<unsigned char>(c)) != 0;
        if (!digit && c != '?') {
            return false;
        }
        pattern.mask = (pattern.mask << 4U) | (digit ? 0xFU : 0U);
        pattern.value =
            (pattern.value << 4U) | (digit ? static_cast<unsigned>(std::stoul(std::string{c}, nullptr, 16)) : 0U);
    }
    return true;
}

/// Parses a byte in binary: `%100xx000`. Returns whether the text has this form.
bool read_bits(const std::string& text, BytePattern& pattern) {
    if (text.size() != 9 || text.front() != '%' || text.find_first_not_of("01x", 1) != std::string::npos) {
        return false;
    }
    for (const char c : text.substr(1)) {
        pattern.mask = (pattern.mask << 1U) | (c == 'x' ? 0U : 1U);
        pattern.value = (pattern.value << 1U) | (c == '1' ? 1U : 0U);
    }
    return true;
}

/// Parses alternatives separated by `|`. Returns an empty list when one of them is not a byte.
std::vector<BytePattern> read_byte(const std::string& text) {
    std::vector<BytePattern> all;
    std::size_t start = 0;
    while (start <= text.size()) {
        const std::size_t end = std::min(text.find('|', start), text.size());
        BytePattern one;
        const std::string part = text.substr(start, end - start);
        if (!read_nibbles(part, one) && !read_bits(part, one)) {
            return {};
        }
        all.push_back(one);
        start = end + 1;
    }
    return all;
}

DataPart byte_part(const std::vector<BytePattern>& all) {
    DataPart part;
    if (all.size() == 1 && all.front().mask == 0xFFU) {
        part.bytes = [value = all.front().value](const Scope&) { return Bytes{static_cast<std::uint8_t>(value)}; };
    }
    part.matches = [all](const Scope&, const Bytes& data, std::size_t at, Captures&) {
        return std::any_of(all.begin(), all.end(),
                           [&](const BytePattern& one) { return (data[at] & one.mask) == one.value; });
    };
    return part;
}

/// Returns a part of `width` bytes, which `bytes` computes each time the step runs.
DataPart computed_part(std::size_t width, std::function<Bytes(const Scope&)> bytes) {
    DataPart part;
    part.width = width;
    part.bytes = bytes;
    part.matches = [bytes](const Scope& scope, const Bytes& data, std::size_t at, Captures&) {
        const Bytes wanted = bytes(scope);
        return at + wanted.size() <= data.size() &&
               std::equal(wanted.begin(), wanted.end(), data.begin() + static_cast<std::ptrdiff_t>(at));
    };
    return part;
}

/// Returns the width in bytes of `u8`, `u16`, `u24` … `u64`; 0 for any other word.
std::size_t width_of(const std::string& word) {
    constexpr std::array<std::pair<const char*, std::size_t>, 8> widths{
        {{"u8", 1}, {"u16", 2}, {"u24", 3}, {"u32", 4}, {"u40", 5}, {"u48", 6}, {"u56", 7}, {"u64", 8}}};
    for (const auto& [name, width] : widths) {
        if (word == name) {
            return width;
        }
    }
    return 0;
}

DataPart value_part(Scanner& token) {
    const Expression value = token.peek() == '(' ? parse_operand(token, Radix::decimal) : parse_indexed_variable(token);
    token.want(":", "give the width: $x:u8, $x:u16, $x:u32, $E:mux or $b:all");
    const std::string word = token.word();
    token.finish();
    if (word == "mux") {
        Scanner whole{token.line(), token.place()};
        const std::string name = whole.up_to(":mux");
        Scanner object{name, token.place()};
        const ObjectReference place = parse_object(object);
        return computed_part(3, [place](const Scope& scope) { return multiplexer(place(scope)); });
    }
    if (word == "all") {
        return computed_part(0, [value](const Scope& scope) { return bytes_of(value(scope)); });
    }
    const std::size_t width = width_of(word);
    if (width == 0) {
        token.fail(fmt::format("`{}` is no width", word), "write u8, u16, u24, u32, u64, mux or all");
    }
    return computed_part(width,
                         [value, width](const Scope& scope) { return little_endian(number_of(value(scope)), width); });
}

DataPart object_part(Scanner& token) {
    token.take("@");
    const ObjectReference place = parse_object(token);
    token.finish();
    return computed_part(3, [place](const Scope& scope) { return multiplexer(place(scope)); });
}

DataPart capture_part(Scanner& token) {
    token.take("->");
    const std::string name = parse_name(token);
    token.want(":", "give the width: ->name:u32 or ->name:all");
    const std::string word = token.word();
    token.finish();
    DataPart part;
    part.width = word == "all" ? 0 : width_of(word);
    if (part.width == 0 && word != "all") {
        token.fail(fmt::format("`{}` is no width", word), "write u8, u16, u24, u32, u64 or all");
    }
    part.matches = [name, width = part.width](const Scope&, const Bytes& data, std::size_t at, Captures& captures) {
        const auto first = data.begin() + static_cast<std::ptrdiff_t>(at);
        captures[name] = width == 0 ? Value{Bytes(first, data.end())} : Value{from_little_endian(data, at, width)};
        return true;
    };
    return part;
}

}  // namespace

Bytes data_of(const Frame& frame) {
    return Bytes(frame.data.begin(), frame.data.begin() + frame.length);
}

DataPattern DataPattern::any() {
    DataPattern all;
    all.rest_ = true;
    return all;
}

DataPattern DataPattern::parse(Scanner& line) {
    DataPattern pattern;
    bool another_follows = false;  // whether a comma ends the pattern: `silence 700+N: 05, 180+N for 1 s`
    while (!line.at_end() && !pattern.rest_ && !another_follows) {
        std::string text = line.peek_token();
        another_follows = text.size() > 1 && text.back() == ',';
        if (another_follows) {
            text.pop_back();
        }
        Scanner token{text, line.place()};
        const auto byte = read_byte(text);
        if (text == "...") {
            pattern.rest_ = true;
        } else if (!byte.empty()) {
            pattern.parts_.push_back(byte_part(byte));
        } else if (text.rfind("->", 0) == 0 && text.size() > 2) {
            pattern.parts_.push_back(capture_part(token));
        } else if (text.front() == '@') {
            pattern.parts_.push_back(object_part(token));
        } else if (text.front() == '$' || text.front() == '(') {
            pattern.parts_.push_back(value_part(token));
        } else if (std::isalpha(static_cast<unsigned char>(text.front())) != 0 || text == "->") {
            break;  // a word such as `within` or `every`, or the arrow of `-> f`, ends the pattern
        } else {
            line.fail(fmt::format("`{}` is no byte", text), forms_of_bytes);
        }
        line.take(text);
    }
    return pattern;
}

Bytes DataPattern::to_send(const Scope& scope) const {
    Bytes all;
    for (const DataPart& one : parts_) {
        if (!one.bytes) {
            throw BrokenCase{"a frame with open bytes such as ?? cannot be sent; write the value of every byte"};
        }
        const Bytes bytes = one.bytes(scope);
        all.insert(all.end(), bytes.begin(), bytes.end());
    }
    if (all.size() > max_frame_length) {
        throw BrokenCase{fmt::format("{} bytes do not fit a frame; write at most {}", all.size(), max_frame_length)};
    }
    if (rest_) {
        all.resize(max_frame_length);
    }
    return all;
}

bool DataPattern::matches(const Scope& scope, const Bytes& data, Captures& captures) const {
    std::size_t at = 0;
    for (const DataPart& one : parts_) {
        if (at + one.width > data.size() || !one.matches(scope, data, at, captures)) {
            return false;
        }
        at += one.width != 0 ? one.width : one.bytes ? one.bytes(scope).size() : data.size() - at;
    }
    return rest_ ? at <= data.size() : at == data.size();
}

DataPattern DataPattern::with_values_of(const Scope& scope) const {
    DataPattern fixed = *this;
    for (DataPart& one : fixed.parts_) {
        if (one.bytes) {
            one = computed_part(one.width, [bytes = one.bytes(scope)](const Scope&) { return bytes; });
        }
    }
    return fixed;
}

}  // namespace canproof::host::conform
