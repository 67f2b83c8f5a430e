// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/make_evidence.hpp"

#include <fmt/format.h>

#include <chrono>

#include "host/base/child_process.hpp"

namespace canproof::host {

namespace {

using Clock = std::chrono::steady_clock;

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
    std::int64_t left = 0;
    for (const auto& one : wanted) {
        left += one.minutes;
    }
    std::size_t failed = 0;
    std::size_t number = 0;
    for (const auto& one : wanted) {
        const auto log = logs / ("evidence-" + one.key + ".log");
        tell(fmt::format("[{}/{}] {}: about {} min; {} min for all that is left", ++number, wanted.size(), one.title,
                         one.minutes, left));
        const auto began = Clock::now();
        const int status = run_in_shell(root, one.run, log);
        const auto took = duration_words(std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - began));
        left -= one.minutes;
        failed += status == 0 ? 0U : 1U;
        tell(status == 0 ? fmt::format("[{}/{}] {}: done after {}", number, wanted.size(), one.title, took)
                         : fmt::format("[{}/{}] {}: ended with {} after {}; its output is in {}", number, wanted.size(),
                                       one.title, status, took, log.string()));
    }
    return failed;
}

}  // namespace canproof::host
