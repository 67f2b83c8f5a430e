// A requirement is proven when breaking it is noticed: each generated cell is altered, and the tests that claim its
// requirement have to fail.
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

/// The tests of one program by the item they claim, quickest first, as a filter of GoogleTest.
std::map<std::string, std::string> filters_by_item(const Evidence& evidence);

/// `count` of them by a seed, in their order; the same for the same seed.
std::vector<AlteredCell> sample_of(const std::vector<AlteredCell>& cells, std::size_t count, std::uint64_t seed);

struct MutationSetup {
    std::filesystem::path tests;       ///< program
    std::filesystem::path properties;  ///< program; empty: none
    std::filesystem::path verdicts;    ///< folder to which both write their unaltered verdicts
    unsigned jobs{2};
};

/// Runs both programs unaltered, then each of the cells altered. Throws InputError when a test fails unaltered.
/// `progress` is told how many are done.
std::vector<MutationOutcome> mutate_cells(const MutationSetup& setup, const std::vector<AlteredCell>& cells,
                                          const std::function<void(std::size_t)>& progress);

using Servers = std::vector<std::unique_ptr<TestServer>>;

/// Has each cell judged, `jobs` at a time, each by servers of its own, one a program. `progress` is told how many are
/// done. Throws InputError when a server is lost.
std::vector<MutationOutcome> judge_all(const std::vector<AlteredCell>& cells,
                                       const std::vector<std::filesystem::path>& programs, unsigned jobs,
                                       const std::function<MutationOutcome(const AlteredCell&, const Servers&)>& judge,
                                       const std::function<void(std::size_t)>& progress);

}  // namespace canproof::host
