// SPDX-License-Identifier: Apache-2.0
// A fuzzing campaign. It fuzzes all targets for a given time on all cores, then sorts the findings, measures the
// coverage, minimises the corpora, and runs the inputs again under valgrind. The corpus folder keeps its data between
// campaigns:
// - TARGET/ with the inputs of a target;
// - findings/TARGET-SIGNATURE/ with one finding;
// - history.json;
// - campaign/ with the state and scratch files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/assess/fuzz/task_pool.hpp"
#include "host/base/shard.hpp"

namespace canproof::host {

struct CampaignOptions {
    double minutes{20.0};              ///< duration of the fuzzing in minutes; all targets share it
    std::vector<std::string> targets;  ///< names of the targets; empty: all
    std::string root{"."};             ///< folder of the project
    std::string corpus{"build/fuzz-corpus"};
    /// folder for index.html, report.json, and exhibit.json for the evidence pack
    std::string out{"build/exhibits/fuzz"};
    std::string build{"build/fuzz"};  ///< folder with libFuzzer programs that have sanitizers
    std::string replay_build{"build/release"};
    std::string coverage_build{"build/fuzz-coverage"};
    /// Folder whose subfolder TARGET receives findings as regression tests. Without a value, the target's committed
    /// corpus receives the findings; an empty path means no regression tests.
    std::optional<std::string> land;
    unsigned jobs{0};       ///< number of parallel processes; 0: all cores
    std::uint64_t seed{0};  ///< seed of the random numbers; 0: taken from the clock and printed
    bool second_pass{true};
    bool coverage{true};
    bool plain{false};  ///< prints progress as lines instead of a table, even on a terminal
    bool restart{false};
    std::optional<Shard> shard{};  ///< fuzzes only this part of the targets; a run with `merge` does the later phases
    /// folder with the corpus folders of all shards, which are merged; empty: the targets are fuzzed
    std::string merge;
};

/// Runs the campaign. Returns the exit status: 0 no finding, 1 a finding, 2 a target that stopped before its time, 130
/// interrupted without a finding. With `shard`, a finding does not change the status. Throws InputError for missing
/// programs or files.
int run_campaign(CampaignOptions options, const Interrupted& interrupted);

}  // namespace canproof::host
