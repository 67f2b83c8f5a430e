// A fuzzing campaign: all targets for a given time on all cores, then what was found is sorted, measured, minimised and
// looked at a second time. The corpus folder keeps everything from night to night:
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
    double minutes{20.0};              ///< of fuzzing, on all jobs together; the passes after it come on top
    std::vector<std::string> targets;  ///< names; none: all
    std::string corpus{"build/fuzz-corpus"};
    std::string out{"build/exhibits/fuzz"};  ///< index.html, report.json, and exhibit.json for the evidence pack
    std::string build{"build/fuzz"};         ///< libFuzzer programs under sanitizers
    std::string replay_build{"build/release"};
    std::string coverage_build{"build/fuzz-coverage"};
    /// Findings become regression tests in TARGET below this folder, in the target's own corpus without it; empty:
    /// nowhere.
    std::optional<std::string> land;
    unsigned jobs{0};       ///< 0: all cores
    std::uint64_t seed{0};  ///< 0: from the clock, and printed
    bool second_pass{true};
    bool coverage{true};
    bool plain{false};  ///< lines instead of a table, on a terminal as well
    bool restart{false};
    std::optional<Shard> shard{};  ///< fuzzes only this part of the targets, and leaves the passes to `merge`
    std::string merge;             ///< folder with the corpus folders of all shards, in place of fuzzing; empty: fuzz
};

/// Exit status: 0 nothing found, 1 a finding, 2 a target that did not run its time, 130 interrupted without a finding.
/// Throws InputError for what is missing.
int run_campaign(CampaignOptions options, const Interrupted& interrupted);

}  // namespace canproof::host
