// SPDX-License-Identifier: Apache-2.0
// Stores findings: each in a folder below the corpus, and its input in the committed corpus.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"
#include "host/assess/fuzz/fuzzer_output.hpp"

namespace canproof::host {

struct FoundInput {
    const FuzzTarget* target{nullptr};
    std::filesystem::path input;
    std::filesystem::path output;  ///< output of the run that the input ended
    Failure failure;
    bool reproduces{true};
    std::string pass;
    std::size_t times{1};
};

/// Keeps input and output. For a target that sends frames to a device, also keeps the candump log and the command that
/// replays it. Adds the input as a regression test when it reproduces. A bug that this campaign has already found is
/// only counted.
void store_finding(const CampaignContext& context, const FoundInput& found);

}  // namespace canproof::host
