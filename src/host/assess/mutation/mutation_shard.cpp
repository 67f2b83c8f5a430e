// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/mutation_shard.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <tuple>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host {

namespace {

using Json = nlohmann::ordered_json;

/// The content of the file of one shard (the part for one of several machines).
struct ReadShard {
    Shard shard;
    std::string name;
    std::string sources;
    std::vector<MutationOutcome> outcomes;
};

std::string stem_of(bool code) {
    return code ? "code_mutation-" : "mutation-";
}

MutationOutcome outcome_of(const Json& one) {
    return {{one.at("number").get<std::size_t>(), one.at("item").get<std::string>(), one.at("cell").get<std::string>(),
             one.at("change").get<std::string>()},
            one.at("killed_by").get<std::string>(),
            one.at("claimed").get<bool>(),
            nullptr,
            one.at("killer_file").get<std::string>()};
}

ReadShard read_shard(const std::filesystem::path& file) {
    try {
        const Json document = Json::parse(read_file(file));
        ReadShard read{parse_shard(document.at("shard").get<std::string>()),
                       file.string(),
                       document.at("sources").get<std::string>(),
                       {}};
        for (const Json& one : document.at("outcomes")) {
            read.outcomes.push_back(outcome_of(one));
        }
        return read;
    } catch (const nlohmann::json::exception&) {
        throw InputError{
            fmt::format("{} is no result of `canproof mutate --shard`; run this shard again", file.string())};
    }
}

std::vector<ReadShard> read_shards(const std::filesystem::path& folder, bool code) {
    std::vector<ReadShard> all;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator{folder, none}) {
        const std::string name = entry.path().filename().string();
        if (name.rfind(stem_of(code), 0) == 0 && entry.path().extension() == ".json") {
            all.push_back(read_shard(entry.path()));
        }
    }
    sort_shards(all);
    return all;
}

bool is_of(const MutationOutcome& outcome, const AlteredCell& cell) {
    return std::tie(outcome.cell.number, outcome.cell.item, outcome.cell.cell, outcome.cell.change) ==
           std::tie(cell.number, cell.item, cell.cell, cell.change);
}

}  // namespace

std::string mutation_shard_name(bool code, const Shard& shard) {
    return fmt::format("{}{}-of-{}.json", stem_of(code), shard.number, shard.count);
}

std::string write_mutation_shard(const Shard& shard, const std::string& sources,
                                 const std::vector<MutationOutcome>& outcomes) {
    Json all = Json::array();
    for (const MutationOutcome& one : outcomes) {
        all.push_back({{"number", one.cell.number},
                       {"item", one.cell.item},
                       {"cell", one.cell.cell},
                       {"change", one.cell.change},
                       {"killed_by", one.killed_by},
                       {"claimed", one.claimed},
                       {"killer_file", one.killer_file}});
    }
    return Json{{"shard", shard.text()}, {"sources", sources}, {"outcomes", all}}.dump(1) + "\n";
}

std::vector<MutationOutcome> merge_mutation_shards(const std::filesystem::path& folder, bool code,
                                                   const std::vector<AlteredCell>& cells) {
    const std::vector<ReadShard> read = read_shards(folder, code);
    require_all_shards(read);
    std::vector<MutationOutcome> outcomes;
    for (std::size_t place = 0; place < cells.size(); ++place) {
        const ReadShard& from = read[place % read.size()];
        const std::size_t at = place / read.size();
        const bool is_sized = from.outcomes.size() == size_of_share(cells.size(), from.shard);
        if (!is_sized || !is_of(from.outcomes[at], cells[place])) {
            throw InputError{fmt::format(
                "{} has outcomes of other alterations; run `--shard {}` with the programs and options of this merge",
                from.name, from.shard.text())};
        }
        outcomes.push_back(from.outcomes[at]);
    }
    return outcomes;
}

}  // namespace canproof::host
