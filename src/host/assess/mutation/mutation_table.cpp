// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/mutation_table.hpp"

#include "host/base/csv_line.hpp"

namespace canproof::host {

namespace {

constexpr const char* all = "all";
constexpr const char* host = "host";
constexpr const char* host_folder = "src/host/sim/";
constexpr std::array<const char*, 4> harnesses{"conformance", "units", "properties", "otherwise"};

bool begins(const std::string& text, const std::string& with) {
    return text.rfind(with, 0) == 0;
}

/// Returns the folder that follows the text `before` in a path, up to the next slash. Returns an empty text when the
/// path does not contain `before`.
std::string folder_after(const std::string& file, const std::string& before) {
    const auto at = file.find(before);
    if (at == std::string::npos) {
        return "";
    }
    const auto from = at + before.size();
    return file.substr(from, file.find('/', from) - from);
}

}  // namespace

std::string operator_of(const std::string& change) {
    static const std::string arrow = " -> ";
    const auto at = change.rfind(arrow);
    const std::string mutated = at == std::string::npos ? "" : change.substr(at + arrow.size());
    static const std::map<std::string, std::string> names{
        {"deleted", "statement"}, {"dropped", "assignment"}, {"[0]", "index"},       {"+1", "literal"},
        {"-1", "literal"},        {"true", "condition"},     {"false", "condition"}, {"<", "condition"},
        {"<=", "condition"},      {">", "condition"},        {">=", "condition"},    {"&&", "condition"},
        {"||", "condition"}};
    if (const auto found = names.find(mutated); found != names.end()) {
        return found->second;
    }
    if (change.find(" -> swapped with ") != std::string::npos) {
        return "order";
    }
    return begins(mutated, "variable ") ? "variable" : "operator";
}

bool is_host(const std::string& file) {
    return begins(file, host_folder);
}

std::string layer_of(const std::string& file) {
    if (is_host(file)) {
        return std::string{host} + "/" + folder_after(file, host_folder);
    }
    if (const std::string chip = folder_after(file, "src/target/"); !chip.empty()) {
        return "target/" + chip;
    }
    const std::string device = folder_after(file, "src/devices/");
    return device.empty() ? folder_after(file, "src/firmware/") : device;
}

std::string harness_of(const std::string& test_file) {
    const auto names = [&](const std::string& folder) {
        return begins(test_file, folder) || test_file.find("/" + folder) != std::string::npos;
    };
    return test_file.empty()             ? "otherwise"
           : names("properties/")        ? "properties"
           : names("tests/conformance/") ? "conformance"
                                         : "units";
}

std::map<std::pair<std::string, std::string>, OperatorCount> count_by_operator(
    const std::vector<MutationOutcome>& outcomes) {
    std::map<std::pair<std::string, std::string>, OperatorCount> counts;
    for (const MutationOutcome& outcome : outcomes) {
        const std::string layer = layer_of(outcome.cell.item);
        const std::string kind = operator_of(outcome.cell.change);
        const char* const sum = is_host(outcome.cell.item) ? host : all;
        for (const auto& key :
             {std::pair<std::string, std::string>{layer, kind}, {layer, all}, {sum, kind}, {sum, all}}) {
            OperatorCount& count = counts[key];
            ++count.mutants;
            count.justified += outcome.killed_by.empty() && outcome.record != nullptr ? 1U : 0U;
            count.open += outcome.open() ? 1U : 0U;
            if (!outcome.killed_by.empty()) {
                ++count.noticed[harness_of(outcome.killer_file)];
            }
        }
    }
    return counts;
}

std::string operators_csv(const std::vector<MutationOutcome>& outcomes) {
    std::vector<std::string> heading{"layer", "operator", "mutants"};
    heading.insert(heading.end(), harnesses.begin(), harnesses.end());
    heading.insert(heading.end(), {"with a reason", "open"});
    std::string text = csv_line(heading);
    for (const auto& [key, count] : count_by_operator(outcomes)) {
        std::vector<std::string> line{key.first, key.second, std::to_string(count.mutants)};
        for (const char* harness : harnesses) {
            const auto found = count.noticed.find(harness);
            line.push_back(std::to_string(found == count.noticed.end() ? 0U : found->second));
        }
        line.push_back(std::to_string(count.justified));
        line.push_back(std::to_string(count.open));
        text += csv_line(line);
    }
    return text;
}

}  // namespace canproof::host
