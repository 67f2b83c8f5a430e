// SPDX-License-Identifier: Apache-2.0
#include "host/assess/inject/injection_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host {

namespace {

using Json = nlohmann::ordered_json;

double percent(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::size_t memory_size(const InjectionCampaign& campaign) {
    return std::accumulate(campaign.regions.begin(), campaign.regions.end(), std::size_t{0},
                           [](std::size_t sum, const RegionSize& region) { return sum + region.bytes; });
}

/// Returns a row of the table: a name, one number for each memory region, and the number for all regions.
std::string row(const std::string& name, const std::vector<std::size_t>& numbers) {
    std::string text = fmt::format("{:<22}", name);
    for (const std::size_t number : numbers) {
        text += fmt::format("{:>10}", number);
    }
    return text + "\n";
}

Json json_of(const EffectCounts& counts) {
    Json made = Json::object();
    for (std::size_t i = 0; i < fault_effects; ++i) {
        made[name_of(static_cast<FaultEffect>(i))] = counts.of.at(i);
    }
    return made;
}

Json json_of(const std::vector<RegionSize>& regions) {
    Json made = Json::array();
    for (const RegionSize& region : regions) {
        made.push_back({{"name", region.name}, {"bytes", region.bytes}});
    }
    return made;
}

Json head(const std::string& device, const InjectionOptions& options, const InjectionCampaign& campaign) {
    return Json{{"device", device},
                {"seed", options.seed},
                {"faults", options.faults},
                {"calls", campaign.calls},
                {"regions", json_of(campaign.regions)}};
}

/// The content of a shard's file; a shard is the part of a campaign for one of several machines.
struct ShardFile {
    Shard shard;
    std::string name;
    std::string sources;
    Json head;
    InjectionCampaign campaign;
};

ShardFile read_shard(const std::filesystem::path& path) {
    try {
        const Json all = Json::parse(read_file(path));
        ShardFile file{parse_shard(all.at("shard").get<std::string>()),
                       path.string(),
                       all.at("sources").get<std::string>(),
                       all.at("campaign"),
                       {}};
        file.campaign.calls = file.head.at("calls").get<std::size_t>();
        for (const Json& region : file.head.at("regions")) {
            file.campaign.regions.push_back(
                {region.at("name").get<std::string>(), region.at("bytes").get<std::size_t>()});
        }
        for (const Json& one : all.at("runs")) {
            const auto numbers = one.get<std::array<std::size_t, 5>>();
            if (numbers[4] >= fault_effects || numbers[1] >= file.campaign.regions.size()) {
                throw InputError{fmt::format(
                    "{}: a run has an unknown effect or region; write this file again with `canproof inject --shard`",
                    path.string())};
            }
            file.campaign.runs.push_back({{numbers[0], numbers[1], numbers[2], static_cast<unsigned>(numbers[3])},
                                          static_cast<FaultEffect>(numbers[4])});
        }
        return file;
    } catch (const Json::exception& error) {
        throw InputError{fmt::format("{} is no file of `canproof inject --shard` ({}); write this file again",
                                     path.string(), error.what())};
    }
}

}  // namespace

std::size_t EffectCounts::all() const {
    return std::accumulate(of.begin(), of.end(), std::size_t{0});
}

std::size_t EffectCounts::effective() const {
    return all() - of.at(static_cast<std::size_t>(FaultEffect::masked));
}

std::size_t EffectCounts::detected() const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < fault_effects; ++i) {
        sum += is_detected(static_cast<FaultEffect>(i)) ? of.at(i) : 0;
    }
    return sum;
}

std::size_t EffectCounts::silent() const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < fault_effects; ++i) {
        sum += is_silent(static_cast<FaultEffect>(i)) ? of.at(i) : 0;
    }
    return sum;
}

EffectCounts count_effects(const InjectionCampaign& campaign) {
    EffectCounts counts;
    for (const InjectedRun& run : campaign.runs) {
        ++counts.of.at(static_cast<std::size_t>(run.effect));
    }
    return counts;
}

EffectCounts count_effects(const InjectionCampaign& campaign, std::size_t region) {
    EffectCounts counts;
    for (const InjectedRun& run : campaign.runs) {
        if (run.fault.region == region) {
            ++counts.of.at(static_cast<std::size_t>(run.effect));
        }
    }
    return counts;
}

std::string injection_table(const std::string& device, const InjectionOptions& options,
                            const InjectionCampaign& campaign) {
    std::string text = fmt::format(
        "{}: {} runs; each run inverts one bit in the {} bytes of memory before one of the {} calls of the device; "
        "seed {}\n\n",
        device, campaign.runs.size(), memory_size(campaign), campaign.calls, options.seed);
    std::vector<EffectCounts> counts;
    text += fmt::format("{:<22}", "");
    for (std::size_t i = 0; i < campaign.regions.size(); ++i) {
        counts.push_back(count_effects(campaign, i));
        text += fmt::format("{:>10}", campaign.regions[i].name);
    }
    counts.push_back(count_effects(campaign));
    text += fmt::format("{:>10}\n", "all");
    for (std::size_t i = 0; i < fault_effects; ++i) {
        std::vector<std::size_t> numbers;
        for (const EffectCounts& one : counts) {
            numbers.push_back(one.of.at(i));
        }
        text += row(name_of(static_cast<FaultEffect>(i)), numbers);
    }
    const EffectCounts& all = counts.back();
    text += fmt::format(
        "\n{} of {} have an effect ({:.1f} %); of these {:.1f} % are detected, {:.1f} % lead to the safe state, "
        "{:.1f} % send or output a wrong value silently\n",
        all.effective(), all.all(), percent(all.effective(), all.all()), percent(all.detected(), all.effective()),
        percent(all.of.at(static_cast<std::size_t>(FaultEffect::safe_state)), all.effective()),
        percent(all.silent(), all.effective()));
    return text;
}

std::string injection_json(const std::string& device, const InjectionOptions& options,
                           const InjectionCampaign& campaign) {
    Json made = head(device, options, campaign);
    made["effects"] = json_of(count_effects(campaign));
    Json by_region = Json::object();
    for (std::size_t i = 0; i < campaign.regions.size(); ++i) {
        by_region[campaign.regions[i].name] = json_of(count_effects(campaign, i));
    }
    made["by_region"] = by_region;
    Json silent = Json::array();
    for (const InjectedRun& run : campaign.runs) {
        if (is_silent(run.effect)) {
            silent.push_back({{"call", run.fault.call},
                              {"region", campaign.regions[run.fault.region].name},
                              {"byte", run.fault.byte},
                              {"bit", run.fault.bit},
                              {"effect", name_of(run.effect)}});
        }
    }
    made["silent"] = silent;
    return made.dump(1) + "\n";
}

std::string injection_shard_name(const std::string& device, const Shard& shard) {
    return fmt::format("inject-{}-{}-of-{}.json", device, shard.number, shard.count);
}

std::string write_injection_shard(const std::string& device, const InjectionOptions& options,
                                  const InjectionCampaign& campaign) {
    Json runs = Json::array();
    for (const InjectedRun& run : campaign.runs) {
        runs.push_back(
            {run.fault.call, run.fault.region, run.fault.byte, run.fault.bit, static_cast<std::size_t>(run.effect)});
    }
    return Json{{"shard", options.shard.text()},
                {"sources", options.sources},
                {"campaign", head(device, options, campaign)},
                {"runs", runs}}
               .dump() +
           "\n";
}

InjectionCampaign merge_injection_shards(const std::filesystem::path& folder, const std::string& device,
                                         InjectionOptions& options) {
    std::vector<ShardFile> files;
    const std::string start = "inject-" + device + "-";
    for (const auto& entry : open_folder(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.rfind(start, 0) == 0 && entry.path().extension() == ".json") {
            files.push_back(read_shard(entry.path()));
        }
    }
    if (files.empty()) {
        throw InputError{
            fmt::format("{}: there is no file {}I-of-N.json; `canproof inject {} --shard I/N` writes these files",
                        folder.string(), start, device)};
    }
    sort_shards(files);
    require_all_shards(files);
    InjectionCampaign merged = files.front().campaign;
    merged.runs.clear();
    std::size_t count = 0;
    for (const ShardFile& file : files) {
        if (file.head != files.front().head) {
            throw InputError{
                fmt::format("{} and {} belong to different campaigns; write all shards with the same device, seed, "
                            "faults and workload",
                            file.name, files.front().name)};
        }
        count += file.campaign.runs.size();
    }
    for (std::size_t place = 0; place < count; ++place) {
        const auto& runs = files[place % files.size()].campaign.runs;
        if (place / files.size() >= runs.size()) {
            throw InputError{fmt::format("{}: runs are missing; write this file again with `canproof inject --shard`",
                                         files[place % files.size()].name)};
        }
        merged.runs.push_back(runs[place / files.size()]);
    }
    options.seed = files.front().head.at("seed").get<std::uint64_t>();
    options.faults = files.front().head.at("faults").get<std::size_t>();
    return merged;
}

}  // namespace canproof::host
