// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/code_mutation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>
#include <tuple>

#include "host/assess/mutation/killer_log.hpp"
#include "host/assess/mutation/mutation.hpp"
#include "host/assess/mutation/mutation_outcome.hpp"
#include "host/assess/mutation/test_server.hpp"
#include "host/base/input_error.hpp"
#include "host/base/reading.hpp"

namespace canproof::host {

namespace {

/// Limit in seconds for the processor time of all tests with one mutant. Counts the times that the tests take
/// without a mutant.
constexpr double most_seconds = 1.5;
/// Limit in seconds for the processor time of additional tests. They run with a mutant that survives the first tests
/// and that no record explains.
constexpr double patient_seconds = 60.0;
/// Limit in seconds for the processor time of the tests that run first. These tests notice most mutants.
constexpr double quick_seconds = 0.1;
/// Limit in seconds for the processor time of the tests that run first in a program that starts with a mutant.
constexpr double started_seconds = 5.0;
/// Name of the entry, in the list of tests, that stands for the computations before the first test.
const char* const startup = "startup";
/// Least time in seconds that is counted for each test, because the start of a test takes time.
constexpr double least_seconds = 0.001;

TestSelection stage(const std::string& filter, const std::map<std::string, double>& seconds) {
    double all = 0.0;
    std::istringstream names{filter};
    for (std::string name; std::getline(names, name, ':');) {
        const auto found = seconds.find(name);
        all += found == seconds.end() ? 0.0 : found->second;
    }
    return {filter, all};
}

/// Returns the name of a test that notices the mutant. Runs the stages in order and stops at the first with a failing
/// test. Returns an empty text when the mutant survives.
std::string killer(TestServer& server, std::size_t mutant, const std::vector<TestSelection>& stages) {
    std::string test;
    for (auto one = stages.begin(); one != stages.end() && test.empty(); ++one) {
        if (!one->filter.empty()) {
            test = server.run(mutant, *one);
        }
    }
    return test;
}

/// Returns the positions of the tests in `tests`, the quickest test first.
std::vector<std::uint32_t> quickest_first(const std::vector<ToldTest>& tests) {
    std::vector<std::uint32_t> ordered(tests.size());
    std::iota(ordered.begin(), ordered.end(), 0U);
    std::sort(ordered.begin(), ordered.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(tests[a].seconds, tests[a].name) < std::tie(tests[b].seconds, tests[b].name);
    });
    return ordered;
}

/// Returns whether a test notices the mutant in a program that starts with it. Runs the quickest tests. If they pass
/// and no record explains the mutant, runs all tests, which takes minutes.
bool noticed_at_start(const CodeMutationSetup& setup, const AlteredCell& mutant, const StartedTests& tests) {
    return fails_when_started_altered(setup.program, mutant.number, tests.quickest) ||
           (!setup.is_explained(mutant) && fails_when_started_altered(setup.program, mutant.number, tests.all));
}

}  // namespace

std::filesystem::path told_by(const std::filesystem::path& program, const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    const fs::path told = folder / "told.tsv";
    const fs::path running = folder / "told.running";
    if (fs::exists(told) && fs::exists(program) && fs::last_write_time(told) > fs::last_write_time(program)) {
        return told;
    }
    fs::create_directories(folder);
    pass_unaltered(program, folder / "verdicts.xml", {"CANPROOF_TOLD=" + running.string()});
    fs::rename(running, told);
    return told;
}

std::vector<ToldTest> read_told(const std::filesystem::path& file) {
    std::ifstream in{file};
    if (!in) {
        throw InputError{fmt::format("there is no {}; build code_mutants with the preset `mutation`", file.string())};
    }
    std::vector<ToldTest> tests;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words{line};
        ToldTest test;
        if (words >> test.name >> test.file >> test.seconds) {
            for (std::size_t mutant = 0; words >> mutant;) {
                test.mutants.push_back(mutant);
            }
            tests.push_back(std::move(test));
        }
    }
    check_read(in, file.string());
    return tests;
}

std::vector<bool> told_at_startup(std::vector<ToldTest>& tests, std::size_t count) {
    std::vector<bool> starting(count);
    for (auto test = tests.begin(); test != tests.end();) {
        if (test->name != startup) {
            ++test;
            continue;
        }
        for (const std::size_t mutant : test->mutants) {
            if (mutant < count) {
                starting[mutant] = true;
            }
        }
        test = tests.erase(test);
    }
    return starting;
}

std::vector<std::vector<std::uint32_t>> tests_by_mutant(const std::vector<ToldTest>& tests, std::size_t count,
                                                        double budget) {
    std::vector<std::vector<std::uint32_t>> chosen(count);
    std::vector<double> spent(count);
    for (const std::uint32_t place : quickest_first(tests)) {
        const double cost = std::max(tests[place].seconds, least_seconds);
        for (const std::size_t mutant : tests[place].mutants) {
            if (mutant < count && (chosen[mutant].empty() || spent[mutant] + cost <= budget)) {
                chosen[mutant].push_back(place);
                spent[mutant] += cost;
            }
        }
    }
    return chosen;
}

std::string filter_of(const std::vector<ToldTest>& tests, const std::vector<std::uint32_t>& places) {
    std::string filter;
    for (const std::uint32_t place : places) {
        filter += (filter.empty() ? "" : ":") + tests.at(place).name;
    }
    return filter;
}

StartedTests tests_of_a_start(const std::vector<ToldTest>& tests, double budget) {
    std::vector<std::uint32_t> ordered = quickest_first(tests);
    StartedTests started;
    started.all.filter = "*";
    std::size_t count = 0;
    for (const std::uint32_t place : ordered) {
        started.all.unaltered += tests[place].seconds;
        if (started.all.unaltered <= budget) {
            started.quickest.unaltered = started.all.unaltered;
            ++count;
        }
    }
    ordered.resize(count);
    started.quickest.filter = filter_of(tests, ordered);
    return started;
}

std::vector<MutationOutcome> mutate_code(const CodeMutationSetup& setup, const std::vector<AlteredCell>& mutants,
                                         std::size_t count, const std::function<void(std::size_t)>& progress) {
    auto tests = read_told(told_by(setup.program, setup.folder));
    const std::vector<bool> starting = told_at_startup(tests, count);
    std::map<std::string, double> seconds;
    std::map<std::string, std::string> files;
    for (const ToldTest& test : tests) {
        seconds[test.name] = test.seconds;
        files[test.name] = test.file;
    }
    const auto quick = tests_by_mutant(tests, count, quick_seconds);
    const auto most = tests_by_mutant(tests, count, most_seconds);
    const auto patient = tests_by_mutant(tests, count, patient_seconds);
    const StartedTests started = tests_of_a_start(tests, started_seconds);
    KillerLog log{setup.folder / "killers.tsv"};
    return judge_all(
        mutants, {setup.program}, setup.jobs,
        [&](const AlteredCell& mutant, const Servers& servers) {
            const std::size_t number = mutant.number;
            MutationOutcome outcome{mutant, "", starting.at(number) || !most.at(number).empty(), nullptr, ""};
            if (!most.at(number).empty()) {
                outcome.killed_by =
                    killer(*servers.front(), number,
                           {stage(log.filter(mutant), seconds), stage(filter_of(tests, quick[number]), seconds),
                            stage(filter_of(tests, most[number]), seconds)});
                if (outcome.killed_by.empty() && patient[number].size() > most[number].size() &&
                    !setup.is_explained(mutant)) {
                    outcome.killed_by =
                        killer(*servers.front(), number, {stage(filter_of(tests, patient[number]), seconds)});
                }
                if (const auto found = files.find(outcome.killed_by); found != files.end()) {
                    outcome.killer_file = found->second;
                }
            }
            if (outcome.killed_by.empty() && starting.at(number) && noticed_at_start(setup, mutant, started)) {
                outcome.killed_by = "a test of a program that started with the mutant";
            }
            log.note(outcome);
            return outcome;
        },
        progress);
}

}  // namespace canproof::host
