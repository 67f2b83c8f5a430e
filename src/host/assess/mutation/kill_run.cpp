// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/kill_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#include "host/assess/mutation/code_mutation.hpp"
#include "host/assess/mutation/implementing_mutants.hpp"
#include "host/assess/mutation/test_server.hpp"
#include "host/assess/source/test_bodies.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

/// Number of mutants of one item that a test runs with first. They are spread evenly over all mutants of the item.
constexpr std::size_t first_tries = 24;
/// Longest processor time in seconds for one test with the cells of one item, and again with the mutants of its code.
constexpr double most_seconds = 3.0;

using Numbers = std::vector<std::size_t>;

/// Numbers of the mutants of each item, by kind: altered cells and mutants of code.
struct Mutants {
    std::map<std::string, Numbers> cells;
    std::map<std::string, Numbers> code;  ///< the numbers of each item are in ascending order
};

/// A test to judge.
struct Task {
    std::string test;
    std::string body;
    bool is_property{false};
    std::set<std::string> claims;
};

/// Returns all numbers in another order: first about `first_tries` numbers that are evenly spread, then the others.
Numbers spread(const Numbers& all) {
    Numbers ordered;
    const std::size_t step = 1 + all.size() / first_tries;
    for (std::size_t first = 0; first < step; ++first) {
        for (std::size_t at = first; at < all.size(); at += step) {
            ordered.push_back(all[at]);
        }
    }
    return ordered;
}

std::vector<Task> tasks_of(const std::filesystem::path& root, const Evidence& evidence, KillRecord& known) {
    std::map<std::string, Task> tasks;
    std::map<std::string, std::string> files;
    for (const TestRun& run : evidence.runs) {
        files[run.name] = run.file;
    }
    for (const auto& [id, verdicts] : evidence.verdicts) {
        if (id.find('-') == std::string::npos) {
            continue;  // the id of a rule that is no item of the requirements register
        }
        for (const Verdict& verdict : verdicts) {
            Task& task = tasks[verdict.test];
            task.test = verdict.test;
            task.is_property = files[verdict.test].rfind("properties/", 0) == 0;
            task.claims.insert(id);
        }
    }
    for (auto line = known.begin(); line != known.end();) {
        line = tasks.count(line->first) == 0 ? known.erase(line) : std::next(line);
    }
    TestBodies bodies{root};
    std::vector<Task> open;
    for (auto& [test, task] : tasks) {
        task.body = bodies.hash(files[test], test);
        if (task.body.empty()) {
            throw InputError{fmt::format("{} does not define {}; build and run the tests again", files[test], test)};
        }
        const auto found = known.find(test);
        if (found == known.end() || found->second.body != task.body) {
            open.push_back(task);
        }
    }
    return open;
}

/// Runs single tests with mutants. Each thread has its own object.
class Judge {
  public:
    Judge(const KillSetup& setup, const Mutants& mutants, const std::map<std::string, ToldTest>& told)
        : tests_{setup.programs / "canproof_tests"},
          properties_{setup.programs / "canproof_properties"},
          code_{setup.programs / "code_mutants"},
          mutants_{mutants},
          told_{told} {}

    KillLine judge(const Task& task) {
        KillLine line;
        line.body = task.body;
        noticed_.clear();
        for (const auto& id : task.claims) {
            const Numbers* cells = find(mutants_.cells, id);
            const Numbers* code = find(mutants_.code, id);
            if (cells == nullptr && code == nullptr) {
                line.without_mutants.push_back(id);
            } else if ((cells != nullptr && notices_cell(task, *cells)) ||
                       (code != nullptr && notices_code(task, *code))) {
                line.kills.push_back(id);
            }
        }
        return line;
    }

  private:
    static const Numbers* find(const std::map<std::string, Numbers>& all, const std::string& id) {
        const auto found = all.find(id);
        return found == all.end() || found->second.empty() ? nullptr : &found->second;
    }

    double seconds_of(const Task& task) const {
        const auto found = told_.find(task.test);
        return found == told_.end() ? 1.0 : std::max(found->second.seconds, 0.01);
    }

    bool notices(TestServer& server, const Task& task, std::size_t number) const {
        return !server.run(number, task.test, 2U + static_cast<unsigned>(5.0 * seconds_of(task))).empty();
    }

    bool notices_cell(const Task& task, const Numbers& cells) {
        double left = most_seconds;
        for (const std::size_t number : spread(cells)) {
            if (left <= 0.0) {
                break;
            }
            left -= seconds_of(task);
            if (notices(task.is_property ? properties_ : tests_, task, number)) {
                return true;
            }
        }
        return false;
    }

    bool notices_code(const Task& task, const Numbers& code) {
        const auto found = told_.find(task.test);
        if (found == told_.end()) {
            return false;
        }
        Numbers reached;
        std::set_intersection(code.begin(), code.end(), found->second.mutants.begin(), found->second.mutants.end(),
                              std::back_inserter(reached));
        double left = most_seconds;
        for (const std::size_t number : spread(reached)) {
            auto known = noticed_.find(number);
            if (known == noticed_.end()) {
                if (left <= 0.0) {
                    break;
                }
                left -= seconds_of(task);
                known = noticed_.emplace(number, notices(code_, task, number)).first;
            }
            if (known->second) {
                return true;
            }
        }
        return false;
    }

    TestServer tests_;
    TestServer properties_;
    TestServer code_;
    const Mutants& mutants_;
    const std::map<std::string, ToldTest>& told_;
    std::map<std::size_t, bool> noticed_;  ///< for each mutant of code, whether the current test notices it
};

/// Runs the programs with unaltered cells. Returns the evidence from the results.
Evidence run_all_unaltered(const KillSetup& setup, const Register& content) {
    const auto verdicts = setup.programs / "verdicts" / "kills";
    std::filesystem::create_directories(verdicts);
    for (const char* name : {"canproof_tests", "canproof_properties"}) {
        if (!run_unaltered(setup.programs / name, verdicts / fmt::format("{}.xml", name))) {
            throw InputError{fmt::format("a test of {} fails without any alteration; fix this test first", name)};
        }
    }
    return collect_evidence(setup.root, verdicts, content);
}

}  // namespace

KillRecord record_kills(const KillSetup& setup, const Register& content, KillRecord known,
                        const std::function<void(std::size_t, std::size_t, const KillRecord&)>& progress) {
    const Evidence evidence = run_all_unaltered(setup, content);
    Mutants mutants;
    for (const AlteredCell& cell : read_cells(setup.programs / "canproof_tests")) {
        mutants.cells[cell.item].push_back(cell.number);
    }
    mutants.code = implementing_mutants(setup.root, content, evidence, read_cells(setup.programs / "code_mutants"));
    std::map<std::string, ToldTest> told;
    for (ToldTest& test :
         read_told(told_by(setup.programs / "code_mutants", setup.programs / "verdicts" / "code_mutants"))) {
        told[test.name] = std::move(test);
    }
    const std::vector<Task> tasks = tasks_of(setup.root, evidence, known);
    std::atomic<std::size_t> next{0};
    std::size_t done = 0;
    std::mutex telling;
    std::string trouble;
    const auto work = [&] {
        try {
            Judge judge{setup, mutants, told};
            for (std::size_t at = next++; at < tasks.size(); at = next++) {
                const KillLine line = judge.judge(tasks[at]);
                const std::scoped_lock lock{telling};
                known[tasks[at].test] = line;
                progress(++done, tasks.size(), known);
            }
        } catch (const std::exception& error) {
            const std::scoped_lock lock{telling};
            trouble = error.what();
        }
    };
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < std::max(1U, setup.jobs); ++i) {
        workers.emplace_back(work);
    }
    for (auto& worker : workers) {
        worker.join();
    }
    if (!trouble.empty()) {
        throw InputError{trouble};
    }
    return known;
}

}  // namespace canproof::host
