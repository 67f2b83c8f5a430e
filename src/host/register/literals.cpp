// SPDX-License-Identifier: Apache-2.0
#include "host/register/literals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cfloat>
#include <cmath>
#include <set>
#include <string_view>

namespace canproof::host {

bool is_real_type(const std::string& type) {
    const std::string_view word{type};  // std::string_view compares the lengths first, which is fast
    return word == "REAL32" || word == "REAL64";
}

std::optional<double> number_of(const Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return static_cast<double>(*whole);
    }
    if (const auto* real = std::get_if<double>(&value)) {
        return *real;
    }
    if (const auto* truth = std::get_if<bool>(&value)) {
        return *truth ? 1.0 : 0.0;
    }
    return std::nullopt;
}

bool fits_type(const Value& value, const std::string& type) {
    if (std::holds_alternative<bool>(value)) {
        return type == "BOOLEAN";
    }
    if (is_real_type(type)) {
        const auto number = number_of(value);
        return number && std::isfinite(*number) && (type == "REAL64" || std::abs(*number) <= double{FLT_MAX});
    }
    const auto* whole = std::get_if<std::int64_t>(&value);
    const auto limits = integer_limits(type);
    return whole != nullptr && limits && *whole >= limits->first && *whole <= limits->second;
}

std::string type_words(const std::string& type) {
    if (type == "BOOLEAN") {
        return "true or false";
    }
    if (is_real_type(type)) {
        return "a finite number";
    }
    const auto limits = integer_limits(type);
    return limits ? fmt::format("a whole number from {} to {}", limits->first, limits->second) : "a text";
}

namespace {

const std::set<std::string>& keywords() {
    // The keywords of C++17 and C++20, and the alternative spellings of operators.
    static const std::set<std::string> words{
        "alignas",     "alignof",  "and",        "and_eq",    "asm",       "auto",         "bitand",
        "bitor",       "bool",     "break",      "case",      "catch",     "char",         "char16_t",
        "char32_t",    "char8_t",  "class",      "co_await",  "co_return", "co_yield",     "compl",
        "concept",     "const",    "const_cast", "consteval", "constexpr", "constinit",    "continue",
        "decltype",    "default",  "delete",     "do",        "double",    "dynamic_cast", "else",
        "enum",        "explicit", "export",     "extern",    "false",     "float",        "for",
        "friend",      "goto",     "if",         "inline",    "int",       "long",         "mutable",
        "namespace",   "new",      "noexcept",   "not",       "not_eq",    "nullptr",      "operator",
        "or",          "or_eq",    "private",    "protected", "public",    "register",     "reinterpret_cast",
        "requires",    "return",   "short",      "signed",    "sizeof",    "static",       "static_assert",
        "static_cast", "struct",   "switch",     "template",  "this",      "thread_local", "throw",
        "true",        "try",      "typedef",    "typeid",    "typename",  "union",        "unsigned",
        "using",       "virtual",  "void",       "volatile",  "wchar_t",   "while",        "xor",
        "xor_eq"};
    return words;
}

}  // namespace

bool is_cpp_name(const std::string& name) {
    const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    const auto inner = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    return !name.empty() && letter(name.front()) && std::all_of(name.begin(), name.end(), inner) &&
           keywords().count(name) == 0;
}

std::string cpp_word(const std::string& word) {
    const std::string snake = snake_case(word);
    if (!snake.empty() && snake.front() >= '0' && snake.front() <= '9') {
        return "n" + snake;
    }
    return keywords().count(snake) == 0 ? snake : snake + "_";
}

}  // namespace canproof::host
