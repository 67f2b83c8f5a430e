// Mutants of the firmware's code: the program built by tests/mutation/code has all of them, and
// knows which tests would compute something else with which.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"
#include "host/assess/mutation/test_server.hpp"

namespace canproof::host {

/// A test of the unmutated program: what it costs, and the mutants that would compute something else in it.
struct ToldTest {
    std::string name;
    double seconds{0.0};
    std::vector<std::size_t> mutants;
    std::string file{};  ///< source of the test
};

/// Runs the program unmutated, and returns the file in `folder` that its tests leave for read_told(). What a run left
/// that is newer than the program serves again. Throws InputError when a test fails.
std::filesystem::path told_by(const std::filesystem::path& program, const std::filesystem::path& folder);

/// Lines `name TAB file TAB seconds TAB mutant TAB mutant …`. Throws InputError when there is no such file.
std::vector<ToldTest> read_told(const std::filesystem::path& file);

/// Takes what was told before any test out of the list: for each of `count` mutants whether it would compute something
/// else when the program starts. It then shows in a program that starts with it.
std::vector<bool> told_at_startup(std::vector<ToldTest>& tests, std::size_t count);

/// For each of `count` mutants the tests that can notice it, as places in `tests`, quickest first, as many as take
/// `budget` seconds and one at least; empty when none can. A test counts for a millisecond at least.
std::vector<std::vector<std::uint32_t>> tests_by_mutant(const std::vector<ToldTest>& tests, std::size_t count,
                                                        double budget);

/// These tests as a filter of GoogleTest.
std::string filter_of(const std::vector<ToldTest>& tests, const std::vector<std::uint32_t>& places);

struct CodeMutationSetup {
    std::filesystem::path program;
    std::filesystem::path folder;  ///< for what the unmutated program leaves
    unsigned jobs{2};
};

/// Runs the program unmutated, then each of the mutants. Throws InputError when a test fails unmutated.
std::vector<MutationOutcome> mutate_code(const CodeMutationSetup& setup, const std::vector<AlteredCell>& mutants,
                                         std::size_t count, const std::function<void(std::size_t)>& progress);

}  // namespace canproof::host
