// SPDX-License-Identifier: Apache-2.0
// Mutation of the firmware's code. The program built by tests/mutation/code contains all mutants. It reports which
// mutants would change a computation in which test.
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

/// Runs the program without a mutant. Returns the file in `folder` that its tests write for read_told(). A file that is
/// newer than the program is used again. Throws InputError when a test fails.
std::filesystem::path told_by(const std::filesystem::path& program, const std::filesystem::path& folder);

/// Reads lines `name TAB file TAB seconds TAB mutant TAB mutant …`. Throws InputError when there is no such file.
std::vector<ToldTest> read_told(const std::filesystem::path& file);

/// Removes the entry for the time before the first test from the list. Returns for each of `count` mutants whether it
/// would change a computation at program start. Such a mutant shows only in a program that starts with it.
std::vector<bool> told_at_startup(std::vector<ToldTest>& tests, std::size_t count);

/// Returns for each of `count` mutants the tests that can notice it, as positions in `tests`, quickest first: as many
/// as take `budget` seconds, and at least one; empty when no test can notice it. A test counts as at least a
/// millisecond.
std::vector<std::vector<std::uint32_t>> tests_by_mutant(const std::vector<ToldTest>& tests, std::size_t count,
                                                        double budget);

/// Returns these tests as a GoogleTest filter.
std::string filter_of(const std::vector<ToldTest>& tests, const std::vector<std::uint32_t>& places);

struct CodeMutationSetup {
    std::filesystem::path program;
    std::filesystem::path folder;  ///< folder for the files that the program writes without a mutant
    unsigned jobs{2};
};

/// Runs the program without a mutant, then with each of the mutants. `progress` receives the number of judged mutants.
/// Throws InputError when a test fails without a mutant.
std::vector<MutationOutcome> mutate_code(const CodeMutationSetup& setup, const std::vector<AlteredCell>& mutants,
                                         std::size_t count, const std::function<void(std::size_t)>& progress);

}  // namespace canproof::host
