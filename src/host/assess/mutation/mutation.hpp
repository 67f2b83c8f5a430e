// SPDX-License-Identifier: Apache-2.0
// Mutation of generated cells (values in generated tables): each cell is altered, and a test that verifies the cell's
// item must fail.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"
#include "host/assess/mutation/test_server.hpp"
#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

/// Returns, for each item that tests in `evidence` verify, a filter that selects these tests, quickest first.
std::map<std::string, TestSelection> tests_by_item(const Evidence& evidence);

/// Returns `count` random cells in their original order, or all cells if there are fewer. The same seed gives the same
/// cells.
std::vector<AlteredCell> sample_of(const std::vector<AlteredCell>& cells, std::size_t count, std::uint64_t seed);

struct MutationSetup {
    std::filesystem::path tests;       ///< path of the program with the tests
    std::filesystem::path properties;  ///< path of the program with the properties; empty: there is none
    std::filesystem::path verdicts;    ///< folder for the test results of both programs, run with unaltered cells
    unsigned jobs{2};
};

/// Runs the programs with the tests and the properties unaltered, then with each cell altered. `progress` receives the
/// number of cells tested so far. Throws InputError when a test fails with unaltered cells.
std::vector<MutationOutcome> mutate_cells(const MutationSetup& setup, const std::vector<AlteredCell>& cells,
                                          const std::function<void(std::size_t)>& progress);

using Servers = std::vector<std::unique_ptr<TestServer>>;

/// Calls `judge` for each cell on `jobs` threads. Each thread has its own test servers, one for each program.
/// `progress` receives the number of cells tested so far. Throws InputError when `judge` throws or a server cannot be
/// started.
std::vector<MutationOutcome> judge_all(const std::vector<AlteredCell>& cells,
                                       const std::vector<std::filesystem::path>& programs, unsigned jobs,
                                       const std::function<MutationOutcome(const AlteredCell&, const Servers&)>& judge,
                                       const std::function<void(std::size_t)>& progress);

}  // namespace canproof::host
