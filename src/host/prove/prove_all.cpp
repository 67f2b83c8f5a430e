// SPDX-License-Identifier: Apache-2.0
#include "host/prove/prove_all.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"
#include "host/prove/code_hash.hpp"
#include "host/prove/contracts.hpp"
#include "host/prove/kept_verdicts.hpp"
#include "host/prove/results.hpp"

namespace canproof::host::prove {

namespace {

const std::string area_of_base = "base";  ///< folder of the theorems about src/firmware/base

bool is_long(const std::string& folder) {
    const std::string ending = "_long";
    return folder.size() > ending.size() && folder.substr(folder.size() - ending.size()) == ending;
}

/// Returns all files of theorems.
std::vector<std::filesystem::path> harnesses(const std::filesystem::path& proofs) {
    std::vector<std::filesystem::path> all;
    if (!std::filesystem::is_directory(proofs)) {
        return all;
    }
    for (const auto& one : std::filesystem::recursive_directory_iterator(proofs)) {
        if (one.path().extension() == ".cpp" && one.path().parent_path().filename() != "support") {
            all.push_back(one.path());
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// Returns whether a folder belongs to the selected ones. A folder of long proofs does when the options name it, or the
/// only theorem.
bool is_selected(const std::string& folder, const ProveOptions& options) {
    if (!options.area.empty()) {
        return folder == options.area;
    }
    return options.takes_long || !options.theorem.empty() || !is_long(folder);
}

/// Returns the files that may contain the selected theorems: all files of the selected folders, or only the files that
/// define the selected theorem.
std::vector<std::filesystem::path> proof_files(const ProveOptions& options) {
    std::vector<std::filesystem::path> all = harnesses(options.proofs);
    const auto is_other = [&options](const std::filesystem::path& file) {
        return !is_selected(file.parent_path().filename(), options) ||
               (!options.theorem.empty() &&
                read_file(file).find("void " + options.theorem + "()") == std::string::npos);
    };
    all.erase(std::remove_if(all.begin(), all.end(), is_other), all.end());
    return all;
}

/// Makes the kernel end this process with SIGXCPU after `seconds` of its own processor time, however busy the machine
/// is.
void bound_processor_time(rlim_t seconds) {
    rlimit bound{};
    if (getrlimit(RLIMIT_CPU, &bound) == 0) {
        bound.rlim_cur = std::min(seconds, bound.rlim_max);
        setrlimit(RLIMIT_CPU, &bound);
    }
}

/// Returns the processor time of this process so far, in seconds.
double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Decides one theorem in a separate process, so that a crash ends that process only.
class Task {
  public:
    Task(const Program& program, TheoremResult result, const std::filesystem::path& place)
        : program_{&program}, result_{std::move(result)}, place_{place} {}

    /// Looks for the result of an earlier run. Takes it, if all code of the theorem is the same, and returns true.
    bool take_kept(const KeptVerdicts& kept, const std::set<std::string>& covered, const std::string& theory) {
        if (!kept.is_used()) {
            return false;
        }
        code_ = reached_code(*program_, result_.name, covered, theory);
        if (const auto same = kept.find(code_.whole)) {
            result_ = *same;
            return true;
        }
        if (result_.area != area_of_base) {
            same_outside_base_ = kept.find(code_.outer);
        }
        return false;
    }
    bool is_about_base() const { return result_.area == area_of_base; }
    std::set<std::string> reached_base() const { return prove::reached_base(*program_, result_.name); }
    bool is_same_outside_base() const { return same_outside_base_.has_value(); }
    /// Takes the result of an earlier run, if only functions of src/firmware/base have changed since, and the proven
    /// theorems about them executed each of them (`proven`). Returns whether it did.
    bool take_outer(const std::set<std::string>& proven) {
        if (!std::includes(proven.begin(), proven.end(), code_.left_out.begin(), code_.left_out.end())) {
            return false;
        }
        result_ = *same_outside_base_;
        result_.rests_on_base = true;
        return true;
    }
    const TheoremResult& result() const { return result_; }
    void keep(const KeptVerdicts& kept, const TheoremResult& result) const {
        kept.keep(code_.whole, result);
        kept.keep(code_.outer, result);
    }

    pid_t start(Compiler& compiler, const ProveOptions& options) {
        process_ = fork();
        if (process_ < 0) {
            throw InputError{"no process can be started; close other programs"};
        }
        if (process_ == 0) {
            run(compiler, options);
        }
        return process_;
    }
    pid_t process() const { return process_; }

    TheoremResult finish(int status, unsigned seconds) {
        if (std::filesystem::exists(place_)) {
            result_ = result_of(nlohmann::json::parse(read_file(place_)));
        }
        if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
            const bool late = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
            result_.verdict = Verdict::unknown;
            result_.seconds = late ? seconds : 0.0;
            result_.reason = late ? fmt::format("not decided in {} s of processor time{}", seconds, result_.reason)
                                  : fmt::format("the process that decides the theorem ended with status {}", status);
        }
        return result_;
    }

  private:
    void save() const { write_file(place_, json_of(result_).dump()); }

    /// Does the work of the child process and ends it.
    [[noreturn]] void run(Compiler& compiler, const ProveOptions& options) {
        try {
            bound_processor_time(options.seconds);
            decide(*program_, Limits{}, result_, [this] { save(); });
            result_.seconds = processor_seconds();
            bound_processor_time(RLIM_INFINITY);
            if (result_.verdict == Verdict::refuted && options.replays && !result_.inputs.empty()) {
                replay(compiler, options.scratch, options.seeds, result_);
            }
            save();
            _exit(0);
        } catch (const std::exception& error) {
            const std::string text = fmt::format("canproof-prove: {}: {}\n", result_.name, error.what());
            _exit(write(STDERR_FILENO, text.data(), text.size()) < 0 ? 3 : 2);
        }
    }

    const Program* program_;
    TheoremResult result_;
    std::filesystem::path place_;
    ReachedCode code_{};                                ///< the theorem's code; empty when verdicts are not kept
    std::optional<TheoremResult> same_outside_base_{};  ///< result of an earlier run, which may still hold
    pid_t process_{-1};
};

/// Starts the tasks in order, at most `jobs` at the same time, and collects their results.
class Queue {
  public:
    Queue(Compiler& compiler, const ProveOptions& options) : compiler_{compiler}, options_{options} {}

    void add(const Program& program, const TheoremResult& theorem) {
        const auto place = options_.scratch / fmt::format("result_{}.json", tasks_.size());
        tasks_.emplace_back(program, theorem, place);
    }

    std::vector<TheoremResult> run() {
        const KeptVerdicts kept{options_.kept};
        const std::string theory = kept.is_used() ? text_about_base() : "";
        const std::set<std::string> covered = kept.is_used() ? covered_base() : std::set<std::string>{};
        const bool has_all = options_.area.empty() && options_.theorem.empty() && !options_.shard;
        results_.resize(tasks_.size());
        std::vector<std::size_t> open;
        std::vector<std::size_t> later;
        for (std::size_t i = 0; i < tasks_.size(); ++i) {
            if (tasks_[i].take_kept(kept, covered, theory)) {
                results_[i] = tasks_[i].result();
            } else {
                (has_all && tasks_[i].is_same_outside_base() ? later : open).push_back(i);
            }
        }
        decide_each(open, kept);
        const std::set<std::string> proven = proven_base();
        open.clear();
        for (const std::size_t i : later) {
            if (tasks_[i].take_outer(proven)) {
                results_[i] = tasks_[i].result();
            } else {
                open.push_back(i);
            }
        }
        decide_each(open, kept);
        return std::move(results_);
    }

  private:
    /// Returns the text of the theorems about src/firmware/base, and of what all harnesses share.
    std::string text_about_base() const {
        std::string text;
        for (const std::string& folder : {area_of_base, std::string{"support"}}) {
            std::vector<std::filesystem::path> files;
            std::error_code none;
            for (const auto& one : std::filesystem::directory_iterator{options_.proofs / folder, none}) {
                files.push_back(one.path());
            }
            std::sort(files.begin(), files.end());
            for (const auto& file : files) {
                text += read_file(file);
            }
        }
        return text;
    }

    /// Returns the names of the functions of src/firmware/base that the theorems about it reach.
    std::set<std::string> covered_base() const {
        std::set<std::string> names;
        for (const Task& one : tasks_) {
            if (one.is_about_base()) {
                const std::set<std::string> reached = one.reached_base();
                names.insert(reached.begin(), reached.end());
            }
        }
        return names;
    }

    /// Returns the names of the functions that the theorems about src/firmware/base executed; none, unless all these
    /// theorems are proven.
    std::set<std::string> proven_base() const {
        std::set<std::string> names;
        for (const TheoremResult& one : results_) {
            if (one.area == area_of_base) {
                if (one.verdict != Verdict::proven) {
                    return {};
                }
                names.insert(one.functions.begin(), one.functions.end());
            }
        }
        return names;
    }

    /// Decides these theorems, several at the same time.
    void decide_each(const std::vector<std::size_t>& chosen, const KeptVerdicts& kept) {
        std::size_t next = 0;
        std::size_t running = 0;
        while (next < chosen.size() || running > 0) {
            if (next < chosen.size() && running < options_.jobs) {
                tasks_[chosen[next++]].start(compiler_, options_);
                ++running;
                continue;
            }
            int status = 0;
            const pid_t ended = waitpid(-1, &status, 0);
            for (std::size_t at = 0; at < next; ++at) {
                Task& task = tasks_[chosen[at]];
                if (task.process() == ended) {
                    TheoremResult& result = results_[chosen[at]];
                    result = task.finish(status, options_.seconds);
                    task.keep(kept, result);
                    std::cerr << fmt::format("{:<9} {:5.1f} s  {}\n", name_of(result.verdict), result.seconds,
                                             result.name);
                    --running;
                }
            }
        }
    }

    Compiler& compiler_;
    const ProveOptions& options_;
    std::vector<Task> tasks_;
    std::vector<TheoremResult> results_;
};

}  // namespace

std::vector<std::string> long_files_left_out(const ProveOptions& options) {
    std::vector<std::string> names;
    for (const auto& file : harnesses(options.proofs)) {
        if (options.area.empty() && !is_selected(file.parent_path().filename(), options)) {
            names.push_back(file.string());
        }
    }
    return names;
}

std::vector<TheoremResult> prove_all(const ProveOptions& options) {
    const std::vector<std::filesystem::path> files = proof_files(options);
    Compiler compiler{{options.generated, options.scratch, options.overlay, options.jobs}};
    compiler.compile(files);
    std::vector<std::unique_ptr<Program>> programs;
    Queue queue{compiler, options};
    std::size_t count = 0;
    for (const auto& file : files) {
        programs.push_back(std::make_unique<Program>(compiler.bitcode(file)));
        for (const std::string& name : programs.back()->theorems()) {
            if (!options.theorem.empty() && options.theorem != name) {
                continue;
            }
            if (!options.shard || options.shard->holds(count)) {
                TheoremResult result;
                result.name = name;
                result.file = file.string();
                result.area = file.parent_path().filename().string();
                queue.add(*programs.back(), result);
            }
            ++count;
        }
    }
    if (count == 0) {
        throw InputError{fmt::format("no theorem below {} matches the options; correct --only or --theorem",
                                     options.proofs.string())};
    }
    std::vector<TheoremResult> results = queue.run();
    if (!options.shard) {  // merge_shards() checks the contracts when it has all results
        check_contracts(results, options.area.empty() && options.theorem.empty());
    }
    return results;
}

}  // namespace canproof::host::prove
