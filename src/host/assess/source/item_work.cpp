// SPDX-License-Identifier: Apache-2.0
#include "host/assess/source/item_work.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

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

}  // namespace

std::string WorkMarks::of_code(const std::vector<std::string>& places) {
    std::set<std::string> functions;
    for (const auto& place : places) {
        functions.insert(function_at(place));
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

std::string WorkMarks::function_at(const std::string& place) {
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
    return without_layout(function);
}

}  // namespace canproof::host
