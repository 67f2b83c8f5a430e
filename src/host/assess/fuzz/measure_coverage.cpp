// SPDX-License-Identifier: Apache-2.0
// Measures which lines of the firmware the corpora reach, and how this number grew during the campaign. The
// modification time of an input shows when the campaign found it.
#include "host/assess/fuzz/measure_coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "host/assess/fuzz/campaign_display.hpp"
#include "host/assess/fuzz/campaign_files.hpp"
#include "host/assess/fuzz/lcov.hpp"

namespace canproof::host {

namespace {

/// number of equal parts (steps) of the campaign's time; step 0 is the state before the campaign
constexpr std::size_t steps = 4;
constexpr std::size_t most_arguments = 1000;
constexpr double run_limit = 900.0;

using Inputs = std::vector<std::filesystem::path>;

/// One run of a program that measures coverage, and the step of the campaign in which its inputs were found.
struct Run {
    const FuzzTarget* target{nullptr};
    std::size_t step{0};
    Inputs inputs;
    std::filesystem::path profile;
};

std::filesystem::path program(const CampaignContext& context, const FuzzTarget& target) {
    return std::filesystem::absolute(std::filesystem::path{context.options.coverage_build} / (target.name + "_fuzz"));
}

/// Returns the step in which the campaign found the input: 1 to `steps`. Returns 0 for an input from before the
/// campaign.
std::size_t step_of(const std::filesystem::path& input, std::filesystem::file_time_type begin,
                    std::filesystem::file_time_type end) {
    const auto time = std::filesystem::last_write_time(input);
    if (time <= begin) {
        return 0;
    }
    const double share = end > begin ? std::chrono::duration<double>(time - begin).count() /
                                           std::chrono::duration<double>(end - begin).count()
                                     : 1.0;
    return std::clamp<std::size_t>(static_cast<std::size_t>(share * steps) + 1, 1, steps);
}

std::vector<Run> runs_of(const CampaignContext& context) {
    const auto begin = std::filesystem::last_write_time(context.files.work() / "began");
    const auto end = std::filesystem::file_time_type::clock::now();
    const auto folder = context.files.scratch() / "profiles";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::vector<Run> runs;
    for (const FuzzTarget& target : context.targets) {
        std::vector<Inputs> inputs(steps + 1);
        for (const auto& input : files_in(context.files.inputs(target.name))) {
            inputs[step_of(input, begin, end)].push_back(input);
        }
        if (const Inputs seeds = files_in(target.seeds); !seeds.empty()) {
            runs.push_back({&target, 0, seeds, folder / fmt::format("{}.profraw", runs.size())});
        }
        for (std::size_t step = 0; step <= steps; ++step) {
            for (std::size_t from = 0; from < inputs[step].size(); from += most_arguments) {
                const auto at = inputs[step].begin() + static_cast<std::ptrdiff_t>(from);
                const auto to = std::min(inputs[step].size(), from + most_arguments);
                runs.push_back({&target, step, Inputs(at, inputs[step].begin() + static_cast<std::ptrdiff_t>(to)),
                                folder / fmt::format("{}.profraw", runs.size())});
            }
        }
    }
    return runs;
}

bool run_all(const CampaignContext& context, const std::vector<Run>& runs) {
    std::vector<Task> tasks;
    for (const Run& run : runs) {
        Task task;
        task.command = {program(context, *run.target).string()};
        for (const auto& input : run.inputs) {
            task.command.push_back(std::filesystem::absolute(input).string());
        }
        task.environment = {{"LLVM_PROFILE_FILE", run.profile.string()}};
        task.log = context.files.log(fmt::format("coverage-{}-{}", run.target->name, run.profile.stem().string()));
        task.limit_seconds = run_limit;
        task.ended = [&context, &run, log = task.log](const TaskEnd& end) {
            if (end.status != 0 && !end.interrupted) {
                context.state.remarks.push_back(
                    fmt::format("{}: a replay failed, so lines that it reached may be missing; see {}",
                                run.target->name, log.string()));
            }
        };
        tasks.push_back(std::move(task));
    }
    return run_tasks(std::move(tasks), context.options.jobs, context.interrupted,
                     [&] { context.display.draw(context.state); });
}

/// Runs one LLVM tool. Returns its output; returns an empty text when the tool fails or is interrupted.
std::string output_of(const CampaignContext& context, std::vector<std::string> command, const std::string& name) {
    Task task;
    task.command = std::move(command);
    task.log = context.files.log(name);
    bool done = false;
    task.ended = [&done](const TaskEnd& end) { done = end.status == 0; };
    run_tasks({task}, 1, context.interrupted, [] {});
    if (!done && !context.interrupted()) {
        context.state.remarks.push_back(fmt::format("{} failed; see {}", task.command[0], task.log.string()));
    }
    return done ? read_text(task.log) : "";
}

/// Returns the lines that were reached by the inputs which the campaign found up to step `step`.
std::vector<FileLines> lines_until(const CampaignContext& context, const std::vector<Run>& runs, std::size_t step) {
    const auto merged = context.files.scratch() / fmt::format("{}.profdata", step);
    std::vector<std::string> merge{"llvm-profdata-19", "merge", "-sparse", "-o", merged.string()};
    for (const Run& run : runs) {
        if (run.step <= step && std::filesystem::exists(run.profile)) {
            merge.push_back(run.profile.string());
        }
    }
    output_of(context, merge, "profdata");
    std::vector<std::string> read{"llvm-cov-19", "export", "--format=lcov", "--instr-profile=" + merged.string(),
                                  program(context, context.targets[0]).string()};
    for (std::size_t i = 1; i < context.targets.size(); ++i) {
        read.push_back("--object=" + program(context, context.targets[i]).string());
    }
    return std::filesystem::exists(merged) ? read_lcov(output_of(context, read, "lcov")) : std::vector<FileLines>{};
}

}  // namespace

bool measure_coverage(const CampaignContext& context) {
    const std::vector<Run> runs = runs_of(context);
    if (!run_all(context, runs)) {
        return false;
    }
    LineCoverage coverage;
    for (std::size_t step = 0; step <= steps && !context.interrupted(); ++step) {
        coverage.files = lines_until(context, runs, step);
        coverage.over_time.push_back({static_cast<double>(step) / steps, coverage.hit()});
    }
    coverage.measured = coverage.lines() > 0;
    std::filesystem::remove_all(context.files.scratch() / "profiles");
    if (context.interrupted()) {
        return false;
    }
    context.state.coverage = coverage;
    context.save();
    return true;
}

}  // namespace canproof::host
