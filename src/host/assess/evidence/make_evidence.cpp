// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/make_evidence.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <chrono>

#include "host/base/child_process.hpp"
#include "host/base/descriptor.hpp"
#include "host/base/file_lock.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

using Clock = std::chrono::steady_clock;

/// A lock, so that only one `evidence --full` runs at a time. The commands that `evidence --full` starts inherit the
/// lock. If it is killed, a command that still runs keeps the lock, because two runs of one command would damage each
/// other's build.
class OnlyRun {
  public:
    explicit OnlyRun(const std::filesystem::path& file) : file_{open(file.c_str(), O_RDWR | O_CREAT, 0644)} {
        if (!file_.is_open()) {
            throw InputError{fmt::format(
                "cannot open {} for writing; check that its folder exists, and the access rights", file.string())};
        }
        if (!try_lock(file_.number())) {
            throw InputError{
                fmt::format("an earlier `evidence --full` or one of its commands still runs, started by {}; wait until "
                            "it ends, or end it",
                            lock_holder(file_.number()))};
        }
    }

  private:
    Descriptor file_;
};

std::string duration_words(const std::chrono::seconds time) {
    constexpr int sixty = 60;
    return fmt::format("{}:{:02}", time.count() / sixty, time.count() % sixty);
}

bool is_needed(const Exhibits& exhibits, const std::string& key) {
    const auto found = exhibits.find(key);
    return found == exhibits.end() || found->second.state == Exhibit::State::absent ||
           found->second.state == Exhibit::State::stale;
}

int run_in_shell(const std::filesystem::path& root, const std::string& command, const std::filesystem::path& log) {
    const pid_t process =
        start_process({"sh", "-c", "cd \"$1\" && eval \"$2\" >\"$3\" 2>&1", "sh", root.string(), command, log.string()},
                      {"CANPROOF=" + std::filesystem::read_symlink("/proc/self/exe").string()}, {});
    return wait_for_process(process);
}

}  // namespace

std::vector<ExpectedEvidence> makeable(const Argument& argument, const Exhibits& exhibits) {
    std::vector<ExpectedEvidence> wanted;
    for (const auto& one : argument.evidence) {
        const bool with_tests = one.key == "coverage" && is_needed(exhibits, "tests");
        if (!one.run.empty() && (with_tests || is_needed(exhibits, one.key))) {
            wanted.push_back(one);
        }
    }
    return wanted;
}

std::size_t make_evidence(const std::vector<ExpectedEvidence>& wanted, const std::filesystem::path& root,
                          const std::function<void(const std::string&)>& tell) {
    const auto logs = root / "build" / "log";
    std::filesystem::create_directories(logs);
    const OnlyRun only_run{logs / "evidence.lock"};
    std::int64_t left = 0;
    for (const auto& one : wanted) {
        left += one.minutes;
    }
    std::size_t failed = 0;
    std::size_t number = 0;
    for (const auto& one : wanted) {
        const auto log = logs / ("evidence-" + one.key + ".log");
        tell(fmt::format("[{}/{}] {}: about {} min; {} min for all remaining steps; its output is in {}", ++number,
                         wanted.size(), one.title, one.minutes, left, log.string()));
        const auto began = Clock::now();
        const int status = run_in_shell(root, one.run, log);
        const auto took = duration_words(std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - began));
        left -= one.minutes;
        failed += status == 0 ? 0U : 1U;
        tell(status == 0 ? fmt::format("[{}/{}] {}: done after {}", number, wanted.size(), one.title, took)
                         : fmt::format("[{}/{}] {}: failed with status {} after {}; its output is in {}", number,
                                       wanted.size(), one.title, status, took, log.string()));
    }
    return failed;
}

}  // namespace canproof::host
