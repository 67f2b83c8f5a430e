// A requirement is proven when breaking it is noticed: each generated cell is altered, and the tests that claim its
// requirement have to fail.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/assess/mutation/test_server.hpp"
#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

/// Why alterations may survive: a record of reports/mutation.toml. `item` and `cell` may hold * and ?.
struct SurvivorRecord {
    std::string item;
    std::string cell;
    std::string change;
    std::string reason;
    unsigned line{0};
};

/// Throws InputError with file, line and remedy.
std::vector<SurvivorRecord> read_survivor_records(const std::filesystem::path& file);
/// `*` any characters, `?` one.
bool matches(const std::string& pattern, const std::string& text);

struct MutationOutcome {
    AlteredCell cell;
    std::string killed_by;                  ///< a test, or how it died; empty: survived
    bool claimed{false};                    ///< some test claims the item
    const SurvivorRecord* record{nullptr};  ///< why it may survive
    bool open() const { return killed_by.empty() && record == nullptr; }
};

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

/// Gives survivors their records. The records that no survivor needs.
std::vector<const SurvivorRecord*> justify(std::vector<MutationOutcome>& outcomes,
                                           const std::vector<SurvivorRecord>& records);

/// Alterations, those noticed, and those that survive with a reason.
struct MutationCount {
    std::size_t altered{0};
    std::size_t noticed{0};
    std::size_t justified{0};
    std::size_t open() const { return altered - noticed - justified; }
    MutationCount& operator+=(const MutationCount& more);
};

using CountsByItem = std::map<std::string, MutationCount>;
CountsByItem count_by_item(const std::vector<MutationOutcome>& outcomes);
MutationCount total(const CountsByItem& counts);

std::string write_mutation_json(const std::vector<MutationOutcome>& outcomes);
/// Empty when there is no such file. Throws InputError when it is something else.
CountsByItem read_mutation_json(const std::filesystem::path& file);

}  // namespace canproof::host
