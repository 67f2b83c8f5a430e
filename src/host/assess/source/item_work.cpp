// SPDX-License-Identifier: Apache-2.0
#include "host/assess/source/item_work.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string_view>

#include "host/assess/source/cpp_text.hpp"
#include "host/assess/source/linked_function.hpp"
#include "host/base/lines.hpp"
#include "host/base/read_file.hpp"
#include "host/base/sha256.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t mark_digits = 8;

std::string mark_of(const std::set<std::string>& texts) {
    return texts.empty() ? "" : sha256(fmt::format("{}", fmt::join(texts, "\n"))).substr(0, mark_digits);
}

bool belongs_to_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ':' || c == '~';
}

/// Returns the name before the first parenthesis of a function's code. Returns an empty text for statements.
std::string name_of(const std::string& function) {
    constexpr std::array<std::string_view, 6> statements{"if", "for", "while", "switch", "return", "static_assert"};
    const auto end = std::min(function.find('('), function.size());
    auto begin = end;
    while (begin != 0 && belongs_to_name(function[begin - 1])) {
        --begin;
    }
    const std::string name = function.substr(begin, end - begin);
    return std::find(statements.begin(), statements.end(), name) == statements.end() ? name : "";
}

}  // namespace

std::string WorkMarks::of_code(const std::vector<std::string>& places) {
    std::set<std::string> functions;
    for (const auto& place : places) {
        functions.insert(without_layout(code_at(place)));
    }
    return mark_of(functions);
}

std::string WorkMarks::of_tests(const std::vector<std::pair<std::string, std::string>>& tests) {
    std::set<std::string> hashes;
    for (const auto& [file, test] : tests) {
        hashes.insert(bodies_.hash(file, test));
    }
    return mark_of(hashes);
}

std::vector<WorkPart> WorkMarks::functions(const std::vector<std::string>& places) {
    std::vector<WorkPart> parts;
    for (const auto& place : places) {
        const std::string function = code_at(place);
        parts.push_back({place, name_of(function), mark_of({without_layout(function)})});
    }
    return parts;
}

std::vector<WorkPart> WorkMarks::bodies(const std::vector<std::pair<std::string, std::string>>& tests) {
    std::vector<WorkPart> parts;
    for (const auto& [file, test] : tests) {
        parts.push_back({file, test, bodies_.hash(file, test)});
    }
    return parts;
}

std::string WorkMarks::code_at(const std::string& place) {
    const auto colon = place.rfind(':');
    const std::string file = place.substr(0, colon);
    Source& source = sources_[file];
    if (source.lines.empty()) {
        const std::string text = read_file(root_ / file);
        source = {split_lines(text), split_lines(code_only(text))};
    }
    const auto [first, last] = function_below(source.code, std::stoul(place.substr(colon + 1)));
    std::string function;
    for (std::size_t line = first; line != 0 && line <= last; ++line) {
        function += source.lines[line - 1] + "\n";
    }
    return function;
}

}  // namespace canproof::host
