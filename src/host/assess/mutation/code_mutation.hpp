// SPDX-License-Identifier: Apache-2.0
// Mutation of the firmware's code. The program that tests/mutation/code builds contains all mutants. It reports, for
// each test, the mutants that would change a computation in this test.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"
#include "host/assess/mutation/test_server.hpp"

namespace canproof::host {

/// A test, its duration without a mutant, and the mutants that would change a computation in it.
struct ToldTest {
    std::string name;
    double seconds{0.0};
    std::vector<std::size_t> mutants;
    std::string file{};  ///< source of the test
};

/// Runs the program without a mutant, and returns the file in `folder` into which its tests write which mutants they
/// reach; read_told() reads this file. Does not run the program when the file is newer than the program. Throws
/// InputError when a test fails.
std::filesystem::path told_by(const std::filesystem::path& program, const std::filesystem::path& folder);

/// Reads lines of the form `name TAB file TAB seconds TAB mutant TAB mutant …`. Throws InputError when the file does
/// not exist.
std::vector<ToldTest> read_told(const std::filesystem::path& file);

/// Removes from `tests` the entry for the computations before the first test. Returns for each of `count` mutants
/// whether it would change one of these computations. Only a program that starts with such a mutant shows its effect.
std::vector<bool> told_at_startup(std::vector<ToldTest>& tests, std::size_t count);

/// Returns for each of `count` mutants the tests that can notice it, as positions in `tests`, quickest first. Keeps as
/// many of them as run within `budget` seconds, but at least one; a test counts as at least a millisecond. The list is
/// empty when no test can notice the mutant.
std::vector<std::vector<std::uint32_t>> tests_by_mutant(const std::vector<ToldTest>& tests, std::size_t count,
                                                        double budget);

/// Returns a GoogleTest filter that selects the tests at the positions `places`.
std::string filter_of(const std::vector<ToldTest>& tests, const std::vector<std::uint32_t>& places);

/// Tests for a program that starts with a mutant. Every test can depend on a value that the program computes at start.
struct StartedTests {
    TestSelection quickest;  ///< the quickest tests
    TestSelection all;
};

/// Returns the tests for a program that starts with a mutant. The quickest tests take at most `budget` seconds together
/// without a mutant.
StartedTests tests_of_a_start(const std::vector<ToldTest>& tests, double budget);

struct CodeMutationSetup {
    std::filesystem::path program;
    std::filesystem::path folder;  ///< folder for the files that the program writes when it runs without a mutant
    unsigned jobs{2};
    /// Returns whether a record of reports/mutation.toml explains why the mutant may survive. Slow tests do not run
    /// with such a mutant.
    std::function<bool(const AlteredCell&)> is_explained{[](const AlteredCell&) { return false; }};
};

/// Runs the program without a mutant, then with each of `mutants`. `count` is the number of all mutants of the program.
/// `progress` receives the number of mutants tested so far. Throws InputError when a test fails without a mutant.
std::vector<MutationOutcome> mutate_code(const CodeMutationSetup& setup, const std::vector<AlteredCell>& mutants,
                                         std::size_t count, const std::function<void(std::size_t)>& progress);

}  // namespace canproof::host
