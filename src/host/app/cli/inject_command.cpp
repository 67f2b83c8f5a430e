// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/inject_command.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "host/app/cli/progress.hpp"
#include "host/assess/inject/injection_report.hpp"
#include "host/base/files.hpp"
#include "host/base/fixed_addresses.hpp"
#include "host/base/input_error.hpp"
#include "host/base/source_hash.hpp"
#include "host/selection/chosen_devices.hpp"
#include "host/selection/own_stimuli.hpp"

namespace canproof::host {

namespace {

ChosenDevice made_device(const InjectOptions& options) {
    ChosenDevice chosen = choose_device(options.device);
    if (options.node) {
        set_node(chosen, *options.node);
    }
    return chosen;
}

/// Returns the frames and stimuli of the files that the user names; without such files, those of
/// tests/devices/NAME/workload.
ReplayInput workload(const InjectOptions& options, const ChosenDevice& chosen) {
    const auto folder = std::filesystem::path{options.root} / "tests" / "devices" / chosen.part->name / "workload";
    const bool own = options.log.empty();
    if (own && !std::filesystem::exists(folder / "bus.log")) {
        throw InputError{
            fmt::format("there is no {}; name a candump log of frames to the device", (folder / "bus.log").string())};
    }
    const std::string log = own ? (folder / "bus.log").string() : options.log;
    const std::string stimulus = own ? (folder / "inputs.csv").string() : options.stimulus;
    ReplayInput input;
    auto frames = open_input(log);
    input.frames = read_candump_log(frames, log);
    if (input.frames.empty()) {
        throw InputError{fmt::format("{} has no frame; name a candump log of frames to the device", log)};
    }
    if (!stimulus.empty()) {
        auto changes = open_input(stimulus);
        input.stimuli = own_stimuli(read_stimuli(changes, stimulus), chosen, options.node).stimuli;
    }
    return input;
}

}  // namespace

int inject(const InjectOptions& options) {
    InjectionOptions campaign_options = options.campaign;
    if (options.merge.empty()) {
        fix_addresses();  // without random addresses, a damaged pointer reads the same memory in every run
    }
    if (options.is_shard) {
        campaign_options.sources = source_hash(options.root);
    }
    InjectionCampaign campaign;
    if (options.merge.empty()) {
        const ReplayInput input = workload(options, made_device(options));
        const std::size_t count = size_of_share(campaign_options.faults, campaign_options.shard);
        campaign = run_faults([&options] { return std::move(made_device(options).device); }, input, campaign_options,
                              [count](std::size_t done) { show_progress(done, count); });
    } else {
        campaign = merge_injection_shards(options.merge, options.device, campaign_options);
    }
    if (options.is_shard) {
        const auto file =
            std::filesystem::path{options.out} / injection_shard_name(options.device, campaign_options.shard);
        write_file(file, write_injection_shard(options.device, campaign_options, campaign));
        fmt::print("shard {}: {} of {} faults judged: {}\n", campaign_options.shard.text(), campaign.runs.size(),
                   campaign_options.faults, file.string());
        return 0;
    }
    fmt::print("{}", options.json ? injection_json(options.device, campaign_options, campaign)
                                  : injection_table(options.device, campaign_options, campaign));
    return 0;
}

}  // namespace canproof::host
