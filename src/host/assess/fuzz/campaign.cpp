// SPDX-License-Identifier: Apache-2.0
#include "host/assess/fuzz/campaign.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include "host/assess/fuzz/campaign_display.hpp"
#include "host/assess/fuzz/campaign_files.hpp"
#include "host/assess/fuzz/campaign_report.hpp"
#include "host/assess/fuzz/campaign_shards.hpp"
#include "host/assess/fuzz/fuzz_all.hpp"
#include "host/assess/fuzz/measure_coverage.hpp"
#include "host/assess/fuzz/minimise_corpora.hpp"
#include "host/assess/fuzz/second_pass.hpp"
#include "host/assess/fuzz/sort_findings.hpp"
#include "host/base/input_error.hpp"
#include "host/base/source_hash.hpp"
#include "host/report/markup.hpp"

namespace canproof::host {

namespace {

constexpr int found_something = 1;
constexpr int was_broken = 2;
constexpr int was_interrupted = 130;
constexpr double slice_minutes = 1.0;
constexpr unsigned most_rounds = 8;

struct Phase {
    const char* name;
    bool (*run)(const CampaignContext& context);
};

constexpr std::array<Phase, 5> phases{{{"fuzzing", fuzz_all},
                                       {phase_after_fuzzing, sort_findings},
                                       {"measuring coverage", measure_coverage},
                                       {"minimising corpora", minimise_corpora},
                                       {"second pass with valgrind", look_again_with_valgrind}}};

void require_programs(const CampaignOptions& options, const std::vector<FuzzTarget>& targets) {
    const auto need = [&](const std::string& build, const char* option, const char* preset) {
        for (const FuzzTarget& target : targets) {
            const auto program = std::filesystem::path{build} / (target.name + "_fuzz");
            if (!std::filesystem::exists(program)) {
                throw InputError{
                    fmt::format("{} is missing; build it with `cmake --preset {} && cmake --build --preset {} --target "
                                "fuzz_targets`, name another folder with --{}-build, or skip this phase with --no-{}",
                                program.string(), preset, preset, option,
                                std::string{option} == "replay" ? "second-pass" : "coverage")};
            }
        }
    };
    if (options.second_pass) {
        need(options.replay_build, "replay", "release");
    }
    if (options.coverage) {
        need(options.coverage_build, "coverage", "fuzz-coverage");
    }
}

/// Returns the number of slices into which the fuzzing time of each target is divided: one for each full
/// `slice_minutes`, at least 1 and at most `most_rounds`.
unsigned rounds_for(const CampaignOptions& options, std::size_t targets) {
    const double share = options.minutes * options.jobs / static_cast<double>(targets);
    return static_cast<unsigned>(std::clamp(share / slice_minutes, 1.0, static_cast<double>(most_rounds)));
}

std::string shard_of(const CampaignOptions& options) {
    return options.shard ? options.shard->text() : "";
}

CampaignState new_state(const CampaignOptions& options, const std::vector<FuzzTarget>& targets,
                        const CampaignFiles& files) {
    CampaignState state;
    state.started = utc_now();
    state.minutes = options.minutes;
    state.seed = options.seed != 0
                     ? options.seed
                     : static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
    state.jobs = options.jobs;
    state.rounds = rounds_for(options, targets.size());
    state.sources = source_hash(options.root);
    state.shard = shard_of(options);
    state.phase = phases[0].name;
    for (const FuzzTarget& target : targets) {
        TargetRecord record;
        record.name = target.name;
        record.inputs_before = files_in(files.inputs(target.name)).size();
        state.targets.push_back(record);
    }
    std::filesystem::remove_all(files.work());
    std::filesystem::create_directories(files.work());
    write_text(files.work() / "began", state.started + "\n");
    return state;
}

bool has_targets(const CampaignState& state, const std::vector<FuzzTarget>& targets) {
    return state.targets.size() == targets.size() &&
           std::equal(targets.begin(), targets.end(), state.targets.begin(),
                      [](const FuzzTarget& target, const TargetRecord& record) { return target.name == record.name; });
}

/// Returns the state of the unfinished campaign. If there is none, or with --restart, returns the state of a new
/// campaign. Throws InputError if another command or another version of canproof started the unfinished campaign.
CampaignState begin_or_go_on(const CampaignOptions& options, const std::vector<FuzzTarget>& targets,
                             const CampaignFiles& files, CampaignDisplay& display) {
    const auto kept = options.restart ? nlohmann::json{} : read_json(files.state());
    if (kept.is_object() && kept.value("phase", "done") != "done") {
        CampaignState state;
        try {
            state = kept.get<CampaignState>();
        } catch (const nlohmann::json::exception& error) {
            throw InputError{fmt::format("another version of canproof wrote {} ({}); --restart starts a new campaign",
                                         files.state().string(), error.what())};
        }
        const bool same =
            state.minutes == options.minutes && state.shard == shard_of(options) && has_targets(state, targets);
        if (!same) {
            throw InputError{fmt::format(
                "{} contains an unfinished campaign with another duration, shard or set of targets ({}, "
                "{}started {}); give the command that started it to continue it, or add --restart to start a new "
                "campaign",
                files.work().string(), minutes_text(state.minutes),
                state.shard.empty() ? "" : "shard " + state.shard + ", ", state.started)};
        }
        state.jobs = options.jobs;
        state.remarks.push_back(
            fmt::format("the campaign was stopped during “{}” and continued at {}", state.phase, utc_now()));
        display.say(fmt::format("continuing the campaign of {}: {}", state.started, state.phase));
        return state;
    }
    CampaignState state = new_state(options, targets, files);
    display.say(fmt::format("{} target(s), {} on {} job(s), seed {}", targets.size(), minutes_text(state.minutes),
                            state.jobs, state.seed));
    return state;
}

std::optional<Night> last_night(const CampaignFiles& files) {
    const auto nights = read_json(files.history());
    return nights.is_array() && !nights.empty() ? std::optional{nights.back().get<Night>()} : std::nullopt;
}

void write_report(const CampaignContext& context, const std::optional<Night>& last) {
    const std::filesystem::path folder{context.options.out};
    std::filesystem::create_directories(folder);
    write_json(folder / "report.json", write_campaign_json(context.state, last));
    write_json(folder / "exhibit.json", write_campaign_exhibit(context.state));
    write_text(folder / "index.html", write_campaign_html(context.state, last));
    context.display.say(fmt::format("report: {}", (folder / "index.html").string()));
}

bool is_wanted(const Phase& phase, const CampaignOptions& options) {
    return (phase.run != measure_coverage || options.coverage) &&
           (phase.run != look_again_with_valgrind || options.second_pass);
}

/// Returns whether a slice (a part of a target's fuzzing time) ended before its time and without a finding.
bool is_broken(const CampaignState& state) {
    return std::any_of(state.targets.begin(), state.targets.end(),
                       [](const TargetRecord& one) { return one.broken_slices > 0; });
}

bool is_fuzzed(const CampaignState& state) {
    return state.phase != phases[0].name;
}

/// Fuzzes the targets of one shard (the part for one of several machines). `--merge` runs the later phases of the
/// campaign. Returns the exit status.
int run_shard(const CampaignContext& context) {
    if (!is_fuzzed(context.state)) {
        context.display.say(phases[0].name);
        const bool done = phases[0].run(context);
        context.display.leave(context.state);
        context.state.phase = done ? phase_after_fuzzing : phases[0].name;
        context.save();
        if (!done) {
            context.display.say("interrupted; the same command without --restart continues the campaign");
            return was_interrupted;
        }
    }
    context.display.say(fmt::format("shard {} has fuzzed {} target(s); give --merge the folder that contains {}",
                                    context.state.shard, context.targets.size(), context.options.corpus));
    return is_broken(context.state) ? was_broken : 0;
}

/// Runs the phases of the campaign, beginning with the phase that its saved state names. Returns false when
/// interrupted.
bool run_phases(const CampaignContext& context) {
    const auto first = std::find_if(phases.begin(), phases.end(),
                                    [&](const Phase& phase) { return context.state.phase == phase.name; });
    for (auto phase = first; phase != phases.end(); ++phase) {
        context.state.phase = phase->name;
        context.save();
        if (is_wanted(*phase, context.options)) {
            context.display.say(phase->name);
            const bool done = phase->run(context);
            context.display.leave(context.state);
            if (!done) {
                context.save();
                return false;
            }
        }
    }
    context.state.phase = "done";
    return true;
}

void add_night(const CampaignContext& context) {
    auto nights = read_json(context.files.history());
    if (!nights.is_array()) {
        nights = nlohmann::json::array();
    }
    nights.push_back(night_of(context.state));
    write_json(context.files.history(), nights);
    context.save();
}

/// Prints the result of the campaign. Returns the exit status of the command.
int verdict(const CampaignState& state, bool finished, CampaignDisplay& display) {
    if (!state.findings.empty()) {
        display.say(fmt::format("{} finding(s)", state.findings.size()));
        return found_something;
    }
    if (!finished) {
        display.say("interrupted; the same command without --restart continues the campaign");
        return was_interrupted;
    }
    const bool broken = is_broken(state);
    display.say(fmt::format("no finding in {} executions{}", grouped(state.executions()),
                            broken ? ", but not every target ran for its full time" : ""));
    return broken ? was_broken : 0;
}

}  // namespace

int run_campaign(CampaignOptions options, const Interrupted& interrupted) {
    options.jobs = options.jobs != 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
    const auto targets = share_of(find_fuzz_targets(options.build, options.targets), options.shard.value_or(Shard{}));
    const CampaignFiles files{options.corpus};
    CampaignDisplay display{stdout, !options.plain && isatty(STDOUT_FILENO) != 0};
    if (options.shard) {
        if (options.seed == 0) {
            throw InputError{"all shards need the same --seed, which must not be 0; write --seed 1 for each"};
        }
        CampaignState state = begin_or_go_on(options, targets, files, display);
        return run_shard({options, targets, files, state, display, interrupted});
    }
    require_programs(options, targets);
    CampaignState state = options.merge.empty() ? begin_or_go_on(options, targets, files, display)
                                                : merge_shards(options.merge, targets, files);
    const CampaignContext context{options, targets, files, state, display, interrupted};
    const auto last = last_night(files);
    const bool finished = run_phases(context);
    if (finished) {
        add_night(context);
    }
    write_report(context, last);
    std::filesystem::remove_all(files.scratch());
    return verdict(state, finished, display);
}

}  // namespace canproof::host
