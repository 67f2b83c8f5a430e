// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/mutation.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <random>
#include <thread>
#include <tuple>

#include "host/assess/mutation/mutation_outcome.hpp"
#include "host/assess/mutation/test_server.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

/// The path of a test program, and for each item a filter that selects the tests that verify it.
struct Program {
    std::filesystem::path path;
    std::map<std::string, TestSelection> tests_of_items;

    const TestSelection* tests(const std::string& item) const {
        const auto found = tests_of_items.find(item);
        return found == tests_of_items.end() ? nullptr : &found->second;
    }
};

Program prepare(const std::filesystem::path& path, const std::filesystem::path& verdicts) {
    const auto folder = verdicts / path.filename();
    std::filesystem::create_directories(folder);
    pass_unaltered(path, folder / "verdicts.xml");
    return {path, tests_by_item(read_verdict_files(folder))};
}

MutationOutcome judge(const AlteredCell& cell, const std::vector<Program>& programs, const Servers& servers) {
    MutationOutcome outcome{cell, "", false, nullptr, ""};
    for (std::size_t i = 0; i < programs.size() && outcome.killed_by.empty(); ++i) {
        if (const TestSelection* tests = programs[i].tests(cell.item)) {
            outcome.claimed = true;
            outcome.killed_by = servers[i]->run(cell.number, *tests);
        }
    }
    // A program can compute a value from the cell when it starts. Such a value changes only if the program starts with
    // the altered cell.
    for (std::size_t i = 0; i < programs.size() && outcome.killed_by.empty(); ++i) {
        const TestSelection* tests = programs[i].tests(cell.item);
        if (tests != nullptr && fails_when_started_altered(programs[i].path, cell.number, *tests)) {
            outcome.killed_by = "a test of a program that started with the alteration";
        }
    }
    return outcome;
}

}  // namespace

std::map<std::string, TestSelection> tests_by_item(const Evidence& evidence) {
    std::map<std::string, TestSelection> selections;
    for (const auto& [id, verdicts] : evidence.verdicts) {
        auto ordered = verdicts;
        std::sort(ordered.begin(), ordered.end(), [](const Verdict& a, const Verdict& b) {
            return std::tie(a.seconds, a.test) < std::tie(b.seconds, b.test);
        });
        TestSelection& tests = selections[id];
        for (const Verdict& verdict : ordered) {
            tests.filter += (tests.filter.empty() ? "" : ":") + verdict.test;
            tests.unaltered += verdict.seconds;
        }
    }
    return selections;
}

std::vector<AlteredCell> sample_of(const std::vector<AlteredCell>& cells, std::size_t count, std::uint64_t seed) {
    std::vector<AlteredCell> rest = cells;
    std::mt19937_64 random{seed};
    for (std::size_t i = 0; i < std::min(count, rest.size()); ++i) {
        // The remainder favours small numbers slightly, which does no harm here. std::uniform_int_distribution is not
        // used because it differs between libraries.
        std::swap(rest[i], rest[i + static_cast<std::size_t>(random() % (rest.size() - i))]);
    }
    rest.resize(std::min(count, rest.size()));
    std::sort(rest.begin(), rest.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
    return rest;
}

std::vector<MutationOutcome> judge_all(const std::vector<AlteredCell>& cells,
                                       const std::vector<std::filesystem::path>& programs, unsigned jobs,
                                       const std::function<MutationOutcome(const AlteredCell&, const Servers&)>& judge,
                                       const std::function<void(std::size_t)>& progress) {
    std::vector<MutationOutcome> outcomes(cells.size());
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> done{0};
    std::mutex telling;
    std::string trouble;
    const auto work = [&] {
        try {
            Servers servers;
            for (const auto& program : programs) {
                servers.push_back(std::make_unique<TestServer>(program));
            }
            for (std::size_t at = next++; at < cells.size(); at = next++) {
                outcomes[at] = judge(cells[at], servers);
                const std::scoped_lock lock{telling};
                progress(++done);
            }
        } catch (const std::exception& error) {
            const std::scoped_lock lock{telling};
            trouble = error.what();
        }
    };
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < std::max(1U, jobs); ++i) {
        workers.emplace_back(work);
    }
    for (auto& worker : workers) {
        worker.join();
    }
    if (!trouble.empty()) {
        throw InputError{trouble};
    }
    return outcomes;
}

std::vector<MutationOutcome> mutate_cells(const MutationSetup& setup, const std::vector<AlteredCell>& cells,
                                          const std::function<void(std::size_t)>& progress) {
    std::vector<Program> programs{prepare(setup.tests, setup.verdicts)};
    std::vector<std::filesystem::path> paths{setup.tests};
    if (!setup.properties.empty()) {
        programs.push_back(prepare(setup.properties, setup.verdicts));
        paths.push_back(setup.properties);
    }
    return judge_all(
        cells, paths, setup.jobs,
        [&](const AlteredCell& cell, const Servers& servers) { return judge(cell, programs, servers); }, progress);
}

}  // namespace canproof::host
