// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/mutation_json.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "host/assess/mutation/mutation_counts.hpp"
#include "host/assess/mutation/mutation_outcome.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::vector<MutationOutcome>& outcomes) {
    const CountsByItem counts = count_by_item(outcomes);
    const MutationCount all = total(counts);
    Json survivors = Json::array();
    for (const MutationOutcome& outcome : outcomes) {
        if (outcome.killed_by.empty()) {
            survivors.push_back({{"item", outcome.cell.item},
                                 {"cell", outcome.cell.cell},
                                 {"change", outcome.cell.change},
                                 {"claimed", outcome.claimed},
                                 {"reason", outcome.record == nullptr ? "" : outcome.record->reason}});
        }
    }
    Json items = Json::object();
    for (const auto& [id, count] : counts) {
        items[id] = {{"altered", count.altered}, {"noticed", count.noticed}, {"justified", count.justified}};
    }
    return Json{{"altered", all.altered},
                {"noticed", all.noticed},
                {"justified", all.justified},
                {"items", items},
                {"survivors", survivors}};
}

}  // namespace

std::string write_mutation_json(const std::vector<MutationOutcome>& outcomes) {
    return json_of(outcomes).dump(1) + "\n";
}

std::string write_mutation_run_json(const std::vector<MutationOutcome>& outcomes,
                                    const std::vector<std::string>& faults) {
    Json json = json_of(outcomes);
    json["faults"] = faults;
    return json.dump(1) + "\n";
}

CountsByItem read_mutation_json(const std::filesystem::path& file) {
    CountsByItem counts;
    std::ifstream in{file};
    if (!in) {
        return counts;
    }
    try {
        const auto document = nlohmann::json::parse(in);
        for (const auto& [id, count] : document.at("items").items()) {
            counts[id] = {count.at("altered").get<std::size_t>(), count.at("noticed").get<std::size_t>(),
                          count.at("justified").get<std::size_t>()};
        }
    } catch (const nlohmann::json::exception&) {
        throw InputError{
            fmt::format("{} is no result of `canproof mutate`; run `canproof mutate` again", file.string())};
    }
    return counts;
}

}  // namespace canproof::host
