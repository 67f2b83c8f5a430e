// SPDX-License-Identifier: Apache-2.0
// A fuzzing campaign. It fuzzes all targets for a given time on all cores, then sorts the findings, measures the
// coverage, minimises the corpora, and runs the inputs again under valgrind. The corpus folder keeps everything between
// campaigns:
//   TARGET/    inputs · findings/TARGET-SIGNATURE/ · history.json · campaign/ state and scratch
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/assess/fuzz/task_pool.hpp"
#include "host/base/shard.hpp"

namespace canproof::host {

struct CampaignOptions {
    double minutes{20.0};  ///< time for fuzzing in minutes, on all jobs together; the later passes take additional time
    std::vector<std::string> targets;  ///< names; empty: all
    std::string corpus{"build/fuzz-corpus"};
    std::string out{"build/exhibits/fuzz"};  ///< index.html, report.json, and exhibit.json for the evidence pack
    std::string build{"build/fuzz"};         ///< libFuzzer programs with sanitizers
    std::string replay_build{"build/release"};
    std::string coverage_build{"build/fuzz-coverage"};
    /// Folder in which findings become regression tests, in its subfolder TARGET. Without a value: the target's own
    /// corpus; empty: no regression tests.
    std::optional<std::string> land;
    unsigned jobs{0};       ///< 0: all cores
    std::uint64_t seed{0};  ///< 0: from the clock; the seed is printed
    bool second_pass{true};
    bool coverage{true};
    bool plain{false};  ///< lines instead of a table, even on a terminal
    bool restart{false};
    std::optional<Shard> shard{};  ///< fuzzes only this part of the targets, and leaves the later passes to `merge`
    std::string merge;  ///< folder with the corpus folders of all shards, which are merged instead of a new campaign;
                        ///< empty: fuzz
};

/// Runs the campaign. Returns the exit status: 0 no finding, 1 a finding, 2 a target that stopped before its time, 130
/// interrupted without a finding. Throws InputError for missing programs or files.
int run_campaign(CampaignOptions options, const Interrupted& interrupted);

}  // namespace canproof::host
