// SPDX-License-Identifier: Apache-2.0
// Replaces each corpus by a smaller set of inputs that reaches the same code.
#include "host/assess/fuzz/minimise_corpora.hpp"

#include <fmt/format.h>

#include "host/assess/fuzz/campaign_display.hpp"
#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

namespace {

/// Replaces the folder of a corpus by renaming folders. After an interruption at any point, one of the folders contains
/// the complete old or new set of inputs.
class Replacement {
  public:
    explicit Replacement(const std::filesystem::path& folder)
        : folder_{folder}, fresh_{folder.string() + ".new"}, old_{folder.string() + ".old"} {
        if (!std::filesystem::exists(folder_) && std::filesystem::exists(old_)) {
            std::filesystem::rename(old_, folder_);
        }
        std::filesystem::remove_all(old_);
        std::filesystem::remove_all(fresh_);
        std::filesystem::create_directories(fresh_);
        std::filesystem::create_directories(folder_);
    }
    const std::filesystem::path& fresh() const { return fresh_; }
    void take() {
        std::filesystem::rename(folder_, old_);
        std::filesystem::rename(fresh_, folder_);
        std::filesystem::remove_all(old_);
    }
    void drop() { std::filesystem::remove_all(fresh_); }

  private:
    std::filesystem::path folder_;
    std::filesystem::path fresh_;
    std::filesystem::path old_;
};

Task merge(const CampaignContext& context, const FuzzTarget& target) {
    Replacement replacement{context.files.inputs(target.name)};
    Task task;
    task.command = {target.program.string(), "-merge=1", "-timeout=10", "-rss_limit_mb=2048",
                    "-artifact_prefix=" + context.files.scratch().string() + "/"};
    task.command.insert(task.command.end(), target.options.begin(), target.options.end());
    task.command.push_back(replacement.fresh().string());
    task.command.push_back(context.files.inputs(target.name).string());
    if (std::filesystem::is_directory(target.seeds)) {
        task.command.push_back(std::filesystem::absolute(target.seeds).string());
    }
    task.environment = fuzzer_environment(context.files);
    task.log = context.files.log("merge-" + target.name);
    task.ended = [&context, &target, replacement](const TaskEnd& end) mutable {
        TargetRecord& record = context.record(target.name);
        const bool emptied = files_in(replacement.fresh()).empty() && record.inputs_found > 0;
        if (end.status == 0 && !end.interrupted && !emptied) {
            replacement.take();
        } else {
            replacement.drop();
            if (!end.interrupted) {
                context.state.remarks.push_back(fmt::format("{}: minimising failed, the corpus stays as it was; see {}",
                                                            target.name,
                                                            context.files.log("merge-" + target.name).string()));
                context.display.say(context.state.remarks.back());
            }
        }
        record.inputs_kept = files_in(context.files.inputs(target.name)).size();
    };
    return task;
}

}  // namespace

bool minimise_corpora(const CampaignContext& context) {
    std::vector<Task> tasks;
    for (const FuzzTarget& target : context.targets) {
        tasks.push_back(merge(context, target));
    }
    return run_tasks(std::move(tasks), context.options.jobs, context.interrupted,
                     [&] { context.display.draw(context.state); });
}

}  // namespace canproof::host
