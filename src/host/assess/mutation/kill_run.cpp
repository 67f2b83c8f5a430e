// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/kill_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <mutex>
#include <thread>

#include "host/assess/mutation/code_mutation.hpp"
#include "host/assess/mutation/implementing_mutants.hpp"
#include "host/assess/mutation/kill_judge.hpp"
#include "host/assess/mutation/test_server.hpp"
#include "host/assess/source/test_bodies.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

std::vector<ClaimingTest> tests_to_judge(const std::filesystem::path& root, const Evidence& evidence,
                                         KillRecord& known) {
    std::map<std::string, ClaimingTest> tests;
    std::map<std::string, std::string> files;
    for (const TestRun& run : evidence.runs) {
        files[run.name] = run.file;
    }
    for (const auto& [id, verdicts] : evidence.verdicts) {
        if (id.find('-') == std::string::npos) {
            continue;  // an id without a dash is no id of the requirements register
        }
        for (const Verdict& verdict : verdicts) {
            ClaimingTest& test = tests[verdict.test];
            test.name = verdict.test;
            test.is_property = files[verdict.test].rfind("properties/", 0) == 0;
            test.claims.insert(id);
        }
    }
    for (auto line = known.begin(); line != known.end();) {
        line = tests.count(line->first) == 0 ? known.erase(line) : std::next(line);
    }
    TestBodies bodies{root};
    std::map<std::string, std::string> code = code_by_test(evidence);
    std::vector<ClaimingTest> open;
    for (auto& [name, test] : tests) {
        test.body = bodies.hash(files[name], name);
        test.code = code[name];
        if (test.body.empty()) {
            throw InputError{
                fmt::format("{} does not define the test {}; build and run the tests again", files[name], name)};
        }
        const auto found = known.find(name);
        if (found == known.end() || found->second.body != test.body || found->second.code != test.code) {
            open.push_back(test);
        }
    }
    return open;
}

/// Runs the programs without an altered cell (value in a generated table). Returns the evidence from their results.
/// Throws InputError, and leaves no results, when a program is missing or one of its tests fails.
Evidence run_all_unaltered(const KillSetup& setup, const Register& content) {
    const auto verdicts = setup.programs / "verdicts" / "kills";
    const bool had_verdicts = std::filesystem::exists(verdicts.parent_path());
    for (const char* name : {"canproof_tests", "canproof_properties"}) {
        const auto program = setup.programs / name;
        if (!std::filesystem::is_regular_file(program)) {
            throw InputError{
                fmt::format("there is no program {}; build it with the preset `mutation`", program.string())};
        }
    }
    std::filesystem::create_directories(verdicts);
    for (const char* name : {"canproof_tests", "canproof_properties"}) {
        try {
            pass_unaltered(setup.programs / name, verdicts / fmt::format("{}.xml", name));
        } catch (const InputError&) {
            std::filesystem::remove_all(had_verdicts ? verdicts : verdicts.parent_path());
            throw;
        }
    }
    return collect_evidence(setup.root, verdicts, content);
}

}  // namespace

KillRecord record_kills(const KillSetup& setup, const Register& content, KillRecord known,
                        const std::function<void(std::size_t, std::size_t, const KillRecord&)>& progress) {
    const Evidence evidence = run_all_unaltered(setup, content);
    ItemMutants mutants;
    for (const AlteredCell& cell : read_cells(setup.programs / "canproof_tests")) {
        mutants.cells[cell.item].push_back(cell.number);
    }
    const std::vector<AlteredCell> code = read_cells(setup.programs / "code_mutants");
    mutants.code = implementing_mutants(setup.root, evidence, code);
    auto told_tests = read_told(told_by(setup.programs / "code_mutants", setup.programs / "verdicts" / "code_mutants"));
    mutants.at_startup = told_at_startup(told_tests, code.size());
    std::map<std::string, ToldTest> told;
    for (ToldTest& test : told_tests) {
        told[test.name] = std::move(test);
    }
    const std::vector<ClaimingTest> tests = tests_to_judge(setup.root, evidence, known);
    std::atomic<std::size_t> next{0};
    std::size_t done = 0;
    std::mutex telling;
    std::string trouble;
    const auto work = [&] {
        try {
            KillJudge judge{setup.programs, mutants, told};
            for (std::size_t at = next++; at < tests.size(); at = next++) {
                const KillLine line = judge.judge(tests[at]);
                const std::scoped_lock lock{telling};
                known[tests[at].name] = line;
                progress(++done, tests.size(), known);
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
