// SPDX-License-Identifier: Apache-2.0
#include "host/prove/prove_shards.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"
#include "host/prove/contracts.hpp"
#include "host/prove/results.hpp"

namespace canproof::host::prove {

namespace {

struct ReadShard {
    Shard shard;
    std::string name;
    std::string sources;
    std::vector<TheoremResult> results;
};

ReadShard read_shard(const std::filesystem::path& file) {
    try {
        const auto document = nlohmann::json::parse(read_file(file));
        ReadShard read{parse_shard(document.at("shard").get<std::string>()),
                       file.string(),
                       document.at("sources").get<std::string>(),
                       {}};
        for (const auto& one : document.at("theorems")) {
            read.results.push_back(result_of(one));
        }
        return read;
    } catch (const nlohmann::json::exception&) {
        throw InputError{fmt::format(
            "{} is no result of `canproof prove --shard I/N --json FILE`; run this shard again", file.string())};
    }
}

std::vector<ReadShard> read_shards(const std::filesystem::path& folder) {
    std::vector<ReadShard> all;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator{folder, none}) {
        if (entry.path().extension() == ".json") {
            all.push_back(read_shard(entry.path()));
        }
    }
    sort_shards(all);
    return all;
}

}  // namespace

std::string shard_text(const Shard& shard, const std::string& sources, const std::vector<TheoremResult>& results) {
    nlohmann::json theorems = nlohmann::json::array();
    for (const TheoremResult& one : results) {
        theorems.push_back(json_of(one));
    }
    return nlohmann::json{{"shard", shard.text()}, {"sources", sources}, {"theorems", theorems}}.dump(1) + "\n";
}

std::vector<TheoremResult> merge_shards(const std::filesystem::path& folder) {
    const std::vector<ReadShard> read = read_shards(folder);
    require_all_shards(read);
    std::size_t all = 0;
    for (const ReadShard& one : read) {
        all += one.results.size();
    }
    for (const ReadShard& one : read) {
        if (one.results.size() != size_of_share(all, one.shard)) {
            throw InputError{
                fmt::format("{} has {} of {} theorems, which is no shard {}; run all shards with the same "
                            "options and sources",
                            one.name, one.results.size(), all, one.shard.text())};
        }
    }
    std::vector<TheoremResult> merged;
    for (std::size_t place = 0; place < all; ++place) {
        merged.push_back(read[place % read.size()].results[place / read.size()]);
    }
    check_contracts(merged, true);
    return merged;
}

}  // namespace canproof::host::prove
