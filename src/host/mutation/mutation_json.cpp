#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "host/bus/candump.hpp"
#include "host/mutation/mutation.hpp"

namespace canproof::host {

std::string write_mutation_json(const std::vector<MutationOutcome>& outcomes) {
    using Json = nlohmann::ordered_json;
    std::map<std::string, MutationCount> counts;
    MutationCount all;
    Json survivors = Json::array();
    for (const MutationOutcome& outcome : outcomes) {
        for (MutationCount* count : {&counts[outcome.cell.item], &all}) {
            ++count->altered;
            count->noticed += outcome.killed_by.empty() ? 0 : 1;
            count->justified += outcome.record == nullptr ? 0 : 1;
        }
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
                {"survivors", survivors}}
               .dump(1) +
           "\n";
}

std::map<std::string, MutationCount> read_mutation_json(const std::filesystem::path& file) {
    std::map<std::string, MutationCount> counts;
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
        throw InputError{fmt::format("{} is not what `canproof mutate` writes; run it again", file.string())};
    }
    return counts;
}

}  // namespace canproof::host
