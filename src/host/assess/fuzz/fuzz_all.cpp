// SPDX-License-Identifier: Apache-2.0
// The fuzzing phase of a campaign. The targets take turns in slices of their fuzzing time, so that an interrupted
// campaign has run every target for some time.
#include "host/assess/fuzz/fuzz_all.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "host/assess/fuzz/campaign_display.hpp"
#include "host/assess/fuzz/campaign_files.hpp"
#include "host/assess/fuzz/fuzzer_output.hpp"

namespace canproof::host {

namespace {

constexpr double seconds_to_end = 60.0;  // time in seconds for libFuzzer to end its last job and merge the corpora

/// Returns the number of cores that one target may use.
unsigned forks(const CampaignContext& context) {
    return std::max(1U, context.options.jobs / static_cast<unsigned>(context.targets.size()));
}

/// Returns the duration of the next slice in seconds: the target's remaining time divided by the number of its
/// remaining slices.
double slice_seconds(const CampaignContext& context, const TargetRecord& record) {
    const double width = std::min<double>(context.options.jobs, static_cast<double>(context.targets.size()));
    const double share = context.state.minutes * 60.0 * width / static_cast<double>(context.targets.size());
    const auto left = static_cast<double>(context.state.rounds - record.slices);
    return std::max(1.0, (share - record.seconds) / left);
}

/// Records the progress of one slice, a part of a target's fuzzing time.
class Slice {
  public:
    Slice(const CampaignContext& context, TargetRecord& record) : context_{context}, record_{record} {}

    void began() {
        executions_ = record_.executions;
        seconds_ = record_.seconds;
        start_ = Clock::now();
    }
    void line(const std::string& text) {
        const auto progress = parse_progress(text);
        if (!progress) {
            return;
        }
        record_.seconds = seconds_ + std::chrono::duration<double>(Clock::now() - start_).count();
        record_.executions = executions_ + progress->executions;
        const std::uint64_t edges = std::max(record_.edges(), progress->edges);
        record_.samples.push_back({record_.seconds, record_.executions, edges, progress->features});
        context_.display.news(record_, crashes());
    }
    void ended(const TaskEnd& end) {
        record_.seconds = seconds_ + end.seconds;
        record_.inputs_found = files_in(context_.files.inputs(record_.name)).size();
        if (!end.interrupted) {
            ++record_.slices;  // an interrupted slice is not counted: it runs again for the remaining time
        }
        if (!end.interrupted && end.status != 0 && crashes() == 0) {
            ++record_.broken_slices;
            context_.state.remarks.push_back(fmt::format("{} ended with status {} before its time; see {}",
                                                         record_.name, end.status,
                                                         context_.files.log("fuzz-" + record_.name).string()));
            context_.display.say(context_.state.remarks.back());
        }
        context_.save();
    }

  private:
    using Clock = std::chrono::steady_clock;

    std::size_t crashes() const { return files_in(context_.files.artifacts(record_.name)).size(); }

    const CampaignContext& context_;
    TargetRecord& record_;
    std::uint64_t executions_{0};
    double seconds_{0.0};
    Clock::time_point start_{};
};

Task slice(const CampaignContext& context, const FuzzTarget& target) {
    const TargetRecord& record = context.record(target.name);
    const double seconds = slice_seconds(context, record);
    const auto artifacts = context.files.artifacts(target.name);
    const auto inputs = context.files.inputs(target.name);
    std::filesystem::create_directories(artifacts);
    std::filesystem::create_directories(inputs);
    Task task;
    task.command = {target.program.string(),
                    fmt::format("-fork={}", forks(context)),
                    "-ignore_crashes=1",
                    "-ignore_timeouts=1",
                    "-ignore_ooms=1",
                    "-timeout=10",
                    "-rss_limit_mb=2048",
                    "-entropic_scale_per_exec_time=1",  // mutates quick inputs more often than slow ones
                    fmt::format("-max_total_time={:.0f}", seconds),
                    fmt::format("-seed={}", (context.state.seed + record.slices) % 0x7FFFFFFFU + 1U),
                    "-artifact_prefix=" + artifacts.string() + "/"};
    task.command.insert(task.command.end(), target.options.begin(), target.options.end());
    if (!target.dictionary.empty()) {
        task.command.push_back("-dict=" + std::filesystem::absolute(target.dictionary).string());
    }
    task.command.push_back(inputs.string());
    if (std::filesystem::is_directory(target.seeds)) {
        task.command.push_back(std::filesystem::absolute(target.seeds).string());
    }
    task.environment = fuzzer_environment(context.files);
    task.log = context.files.log("fuzz-" + target.name);
    task.limit_seconds = seconds + seconds_to_end;
    return task;
}

/// Runs one slice of each target that has not yet run its slice of this round. Returns false when interrupted.
bool fuzz_round(const CampaignContext& context, unsigned round) {
    std::vector<Task> tasks;
    for (const FuzzTarget& target : context.targets) {
        if (context.record(target.name).slices <= round) {
            const auto follower = std::make_shared<Slice>(context, context.record(target.name));
            Task task = slice(context, target);
            task.began = [follower] { follower->began(); };
            task.line = [follower](const std::string& line) { follower->line(line); };
            task.ended = [follower](const TaskEnd& end) { follower->ended(end); };
            tasks.push_back(std::move(task));
        }
    }
    return run_tasks(std::move(tasks), context.options.jobs, context.interrupted,
                     [&] { context.display.draw(context.state); });
}

}  // namespace

bool fuzz_all(const CampaignContext& context) {
    for (unsigned round = 0; round < context.state.rounds; ++round) {
        if (!fuzz_round(context, round)) {
            return false;
        }
    }
    return true;
}

}  // namespace canproof::host
