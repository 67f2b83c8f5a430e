// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/eds_check_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "host/base/files.hpp"
#include "host/base/read_file.hpp"
#include "host/datasheet/check/check_eds.hpp"
#include "host/datasheet/check/fix_eds.hpp"
#include "host/datasheet/read_eds.hpp"

namespace canproof::host {

namespace {

using Json = nlohmann::ordered_json;

/// Returns the text with each control character replaced by a question mark, so that a terminal can show it.
std::string printable(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7F'; }, '?');
    return text;
}

Json json_of(const EdsFinding& finding) {
    return {{"line", finding.line},           {"rule", finding.rule.id}, {"severity", to_text(finding.rule.severity)},
            {"what", finding.what},           {"fix", finding.fix},      {"source", finding.rule.source},
            {"fixable", finding.is_fixable()}};
}

Json json_of(const std::vector<EdsFinding>& findings) {
    Json all = Json::array();
    for (const EdsFinding& finding : findings) {
        all.push_back(json_of(finding));
    }
    return all;
}

std::size_t count(const std::vector<EdsFinding>& findings, EdsSeverity severity) {
    return static_cast<std::size_t>(std::count_if(
        findings.begin(), findings.end(), [severity](const EdsFinding& one) { return one.rule.severity == severity; }));
}

void print_text(const std::string& file, const std::vector<EdsFinding>& fixed, const std::vector<EdsFinding>& found) {
    for (const EdsFinding& one : fixed) {
        fmt::print("{}:{}: fixed {}: {}\n", file, one.line, one.rule.id, printable(one.what));
    }
    for (const EdsFinding& one : found) {
        fmt::print("{}:{}: {} {}: {}; {} ({})\n", file, one.line, to_text(one.rule.severity), one.rule.id,
                   printable(one.what), one.fix, one.rule.source);
    }
    const std::size_t errors = count(found, EdsSeverity::error);
    fmt::print("{} error(s), {} warning(s){}\n", errors, found.size() - errors,
               fixed.empty() ? "" : fmt::format(", {} fixed", fixed.size()));
}

int print_rules(const bool json) {
    if (json) {
        Json all = Json::array();
        for (const EdsRule& rule : eds_rules()) {
            all.push_back({{"rule", rule.id},
                           {"severity", to_text(rule.severity)},
                           {"what", rule.what},
                           {"fix", rule.fix},
                           {"source", rule.source}});
        }
        std::cout << Json{{"rules", all}}.dump(2) << "\n";
        return 0;
    }
    for (const EdsRule& rule : eds_rules()) {
        fmt::print("{} {}: {}; {} ({})\n", to_text(rule.severity), rule.id, rule.what, rule.fix, rule.source);
    }
    return 0;
}

std::string name_of(const std::string& file) {
    return std::filesystem::path{file}.filename().string();
}

bool name_differs(const std::vector<EdsFinding>& findings) {
    return std::any_of(findings.begin(), findings.end(),
                       [](const EdsFinding& one) { return std::string_view{one.rule.id} == "fileinfo-name-differs"; });
}

}  // namespace

int check_eds_file(const EdsCheckOptions& options) {
    if (options.rules) {
        return print_rules(options.json);
    }
    const std::string text = read_file(options.file, longest_eds_file);
    const std::string shown = options.fix.empty() ? options.file : options.fix;
    const std::string name = name_of(options.file);
    EdsFixed fixed{text, {}};
    if (!options.fix.empty()) {
        fixed = fix_eds(text, name);
        write_file(options.fix, fixed.text);
    }
    std::vector<EdsFinding> found = check_eds(fixed.text, name);
    if (name_differs(found)) {
        found = check_eds(fixed.text, name_of(shown));  // the sheet may have the name of the fixed file
    }
    if (options.json) {
        const Json json{{"file", shown},
                        {"errors", count(found, EdsSeverity::error)},
                        {"warnings", count(found, EdsSeverity::warning)},
                        {"fixed", json_of(fixed.done)},
                        {"findings", json_of(found)}};
        std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
    } else {
        print_text(shown, fixed.done, found);
    }
    const bool fails = count(found, EdsSeverity::error) != 0 || (options.strict && !found.empty());
    return fails ? 1 : 0;
}

}  // namespace canproof::host
