// SPDX-License-Identifier: Apache-2.0
// Turns inputs that ended a run into findings: one for each bug, with a minimised input and the files to replay it.
#include "host/assess/fuzz/sort_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "host/assess/fuzz/campaign_display.hpp"
#include "host/assess/fuzz/campaign_files.hpp"
#include "host/assess/fuzz/finding_store.hpp"

namespace canproof::host {

namespace {

/// greatest number of crashing inputs examined per target; a frequent bug can leave thousands of them
constexpr std::size_t most_inputs = 40;
constexpr double reproduction_limit = 30.0;
constexpr double least_shrinking = 2.0;  ///< seconds
constexpr double most_shrinking = 15.0;

/// An input that ended a run, and the result of a second run with this input.
struct Crash {
    const FuzzTarget* target{nullptr};
    std::filesystem::path input;
    Failure failure;
    bool reproduces{false};
};

/// Returns whether the artifact (an input that libFuzzer saved) shows a failure; `slow-unit-…` is only a remark of
/// libFuzzer.
bool is_failure(const std::filesystem::path& artifact) {
    return artifact.filename().string().rfind("slow-unit-", 0) != 0;
}

bool can_shrink(const Crash& crash) {
    const std::string name = crash.input.filename().string();
    return crash.reproduces && name.rfind("timeout-", 0) != 0 && name.rfind("oom-", 0) != 0;
}

std::vector<Crash> collect(const CampaignContext& context) {
    std::vector<Crash> crashes;
    for (const FuzzTarget& target : context.targets) {
        auto inputs = files_in(context.files.artifacts(target.name));
        inputs.erase(std::remove_if(inputs.begin(), inputs.end(), [](const auto& one) { return !is_failure(one); }),
                     inputs.end());
        std::sort(inputs.begin(), inputs.end(), [](const auto& a, const auto& b) {
            return std::filesystem::file_size(a) < std::filesystem::file_size(b);
        });
        if (inputs.size() > most_inputs) {
            context.state.remarks.push_back(fmt::format("{}: {} inputs ended a run; only the {} smallest were examined",
                                                        target.name, inputs.size(), most_inputs));
            inputs.resize(most_inputs);
        }
        for (const auto& input : inputs) {
            crashes.push_back({&target, input, {}, false});
        }
    }
    return crashes;
}

/// Returns the task that runs one crashing input once with the sanitizers.
Task reproduction(const CampaignContext& context, Crash& crash, const std::filesystem::path& log) {
    Task task;
    task.command = {crash.target->program.string(), "-timeout=10", "-rss_limit_mb=2048", crash.input.string()};
    task.environment = fuzzer_environment(context.files);
    task.log = log;
    task.limit_seconds = reproduction_limit;
    task.ended = [&crash, log](const TaskEnd& end) {
        if (end.interrupted) {
            return;
        }
        crash.reproduces = end.status != 0;
        crash.failure = parse_failure(read_text(log));
        if (!crash.reproduces) {
            crash.failure = {"ended a run once and not again", "", {}};
        } else if (end.timed_out) {
            crash.failure.kind = "timeout";
        }
    };
    return task;
}

std::filesystem::path output_of(const CampaignContext& context, const Crash& crash) {
    return context.files.log("crash-" + crash.target->name + "-" + crash.input.filename().string());
}

bool reproduce(const CampaignContext& context, std::vector<Crash>& crashes) {
    std::vector<Task> tasks;
    for (Crash& crash : crashes) {
        tasks.push_back(reproduction(context, crash, output_of(context, crash)));
    }
    return run_tasks(std::move(tasks), context.options.jobs, context.interrupted, [] {});
}

/// Returns a tenth of the fuzzing time in seconds, but at least `least_shrinking` and at most `most_shrinking`.
double shrinking_seconds(const CampaignContext& context) {
    return std::clamp(context.state.minutes * 6.0, least_shrinking, most_shrinking);
}

std::filesystem::path smaller_of(const Crash& crash) {
    return crash.input.string() + ".smaller";
}

/// Lets libFuzzer shrink each crashing input within a time limit. Returns false when interrupted.
bool shrink(const CampaignContext& context, std::vector<Crash>& crashes) {
    std::vector<Task> tasks;
    for (Crash& crash : crashes) {
        if (!can_shrink(crash)) {
            continue;
        }
        Task task;
        task.command = {crash.target->program.string(), "-minimize_crash=1",
                        fmt::format("-max_total_time={:.0f}", shrinking_seconds(context)),
                        "-exact_artifact_path=" + smaller_of(crash).string(), crash.input.string()};
        task.environment = fuzzer_environment(context.files);
        task.log = context.files.log("shrink-" + crash.target->name + "-" + crash.input.filename().string());
        task.limit_seconds = 2.0 * shrinking_seconds(context);
        tasks.push_back(std::move(task));
    }
    return run_tasks(std::move(tasks), context.options.jobs, context.interrupted, [] {});
}

/// Replaces each crashing input by its smaller version if that shows the same bug. Returns false when interrupted.
bool take_smaller(const CampaignContext& context, std::vector<Crash>& crashes) {
    std::vector<Crash> smaller = crashes;
    for (Crash& crash : smaller) {
        const auto shrunk = smaller_of(crash);
        crash.input = std::filesystem::exists(shrunk) ? shrunk : crash.input;
    }
    if (!reproduce(context, smaller)) {
        return false;
    }
    for (std::size_t i = 0; i < crashes.size(); ++i) {
        if (smaller[i].reproduces && smaller[i].failure.title() == crashes[i].failure.title()) {
            crashes[i] = smaller[i];
        }
    }
    return true;
}

/// Returns the first crash of each bug. If `crashes` is sorted by size, this crash has the smallest input of the bug.
/// Sets `times` to the number of crashes of each bug.
std::vector<Crash> distinct(const std::vector<Crash>& crashes, std::map<std::string, std::size_t>& times) {
    std::vector<Crash> first;
    for (const Crash& crash : crashes) {
        if (++times[crash.target->name + crash.failure.signature()] == 1) {
            first.push_back(crash);
        }
    }
    return first;
}

}  // namespace

bool sort_findings(const CampaignContext& context) {
    std::vector<Crash> crashes = collect(context);
    if (crashes.empty()) {
        return true;
    }
    context.display.say(fmt::format("{} input(s) ended a run; sorting them", crashes.size()));
    std::map<std::string, std::size_t> times;
    if (!reproduce(context, crashes)) {
        return false;
    }
    std::vector<Crash> first = distinct(crashes, times);
    if (!shrink(context, first) || !take_smaller(context, first)) {
        return false;
    }
    for (const Crash& crash : first) {
        store_finding(context, {crash.target, crash.input, output_of(context, crash), crash.failure, crash.reproduces,
                                "libFuzzer with sanitizers", times[crash.target->name + crash.failure.signature()]});
    }
    for (const FuzzTarget& target : context.targets) {
        std::filesystem::remove_all(context.files.artifacts(target.name));
    }
    context.save();
    return true;
}

}  // namespace canproof::host
