// SPDX-License-Identifier: Apache-2.0
#include "host/assess/fuzz/campaign_shards.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/input_error.hpp"
#include "host/base/shard.hpp"

namespace canproof::host {

namespace {

namespace fs = std::filesystem;

/// The corpus folder of one machine and the state of the campaign that ran there.
struct ReadShard {
    CampaignFiles files;
    std::string name;
    std::string sources;
    Shard shard;
    CampaignState state;
};

ReadShard read_shard(const fs::path& folder) {
    const CampaignFiles files{folder};
    try {
        auto state = read_json(files.state()).get<CampaignState>();
        const Shard shard = parse_shard(state.shard);
        std::string sources = state.sources;
        return {files, folder.string(), std::move(sources), shard, std::move(state)};
    } catch (const nlohmann::json::exception&) {
        throw InputError{
            fmt::format("{} is no state that `canproof fuzz --shard` of this version wrote; run this shard "
                        "again",
                        files.state().string())};
    }
}

std::vector<ReadShard> read_shards(const fs::path& folder) {
    std::vector<ReadShard> all;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator{folder, none}) {
        if (fs::exists(CampaignFiles{entry.path()}.state())) {
            all.push_back(read_shard(entry.path()));
        }
    }
    sort_shards(all);
    return all;
}

void require_one_campaign(const std::vector<ReadShard>& all) {
    for (const ReadShard& one : all) {
        const CampaignState& first = all.front().state;
        if (one.state.minutes != first.minutes || one.state.seed != first.seed) {
            throw InputError{
                fmt::format("{} fuzzed {} with seed {}, {} fuzzed {} with seed {}; give "
                            "each shard the same --minutes and --seed",
                            all.front().name, minutes_text(first.minutes), first.seed, one.name,
                            minutes_text(one.state.minutes), one.state.seed)};
        }
        if (one.state.phase != phase_after_fuzzing) {
            throw InputError{fmt::format("{} has not finished fuzzing; give the command of shard {} again", one.name,
                                         one.state.shard)};
        }
    }
    require_all_shards(all);
}

/// Copies the files of a folder and keeps their modification times, which show when the campaign found each input.
void copy_files(const fs::path& from, const fs::path& to) {
    fs::create_directories(to);
    for (const fs::path& file : files_in(from)) {
        const fs::path copy = to / file.filename();
        fs::copy_file(file, copy, fs::copy_options::overwrite_existing);
        fs::last_write_time(copy, fs::last_write_time(file));
    }
}

/// Copies the start time of the shard that began first to the merged campaign.
void copy_beginning(const std::vector<ReadShard>& all, const CampaignFiles& files) {
    const auto began = [](const ReadShard& one) { return fs::last_write_time(one.files.work() / "began"); };
    const auto& first = *std::min_element(all.begin(), all.end(),
                                          [&](const ReadShard& a, const ReadShard& b) { return began(a) < began(b); });
    write_text(files.work() / "began", first.state.started + "\n");
    fs::last_write_time(files.work() / "began", began(first));
}

}  // namespace

CampaignState merge_shards(const fs::path& folder, const std::vector<FuzzTarget>& targets, const CampaignFiles& files) {
    const std::vector<ReadShard> all = read_shards(folder);
    require_one_campaign(all);
    CampaignState merged = all.front().state;
    merged.shard.clear();
    merged.jobs = 0;
    merged.targets.clear();
    merged.remarks.clear();
    for (const ReadShard& one : all) {
        merged.started = std::min(merged.started, one.state.started);
        merged.jobs += one.state.jobs;
        merged.rounds = std::max(merged.rounds, one.state.rounds);
        for (const std::string& remark : one.state.remarks) {
            merged.remarks.push_back(fmt::format("shard {}: {}", one.shard.text(), remark));
        }
    }
    for (std::size_t place = 0; place < targets.size(); ++place) {
        const ReadShard& from = all[place % all.size()];
        const std::size_t at = place / all.size();
        if (from.state.targets.size() != size_of_share(targets.size(), from.shard) ||
            from.state.targets[at].name != targets[place].name) {
            throw InputError{fmt::format("{} fuzzed other targets; run shard {} again with the targets of this build",
                                         from.name, from.shard.text())};
        }
        merged.targets.push_back(from.state.targets[at]);
    }
    fs::remove_all(files.work());
    fs::create_directories(files.work());
    copy_beginning(all, files);
    for (std::size_t place = 0; place < targets.size(); ++place) {
        const CampaignFiles& from = all[place % all.size()].files;
        copy_files(from.inputs(targets[place].name), files.inputs(targets[place].name));
        copy_files(from.artifacts(targets[place].name), files.artifacts(targets[place].name));
    }
    return merged;
}

}  // namespace canproof::host
