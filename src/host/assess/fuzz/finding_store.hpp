// SPDX-License-Identifier: Apache-2.0
// Stores findings: each in a folder of its own below the corpus folder, and its input as a regression test in the
// committed corpus.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"
#include "host/assess/fuzz/fuzzer_output.hpp"

namespace canproof::host {

struct FoundInput {
    const FuzzTarget* target{nullptr};
    std::filesystem::path input;
    std::filesystem::path output;  ///< output of the run in which the input failed
    Failure failure;
    bool reproduces{true};
    std::string pass;
    std::size_t times{1};
};

/// Saves the input and the output in the folder of the finding. For a target that sends frames to a device, also saves
/// the candump log and the command that replays it. Adds the input as a regression test if it reproduces the failure
/// and the options permit it. If this campaign has already found the bug, only adds `times` to its count.
void store_finding(const CampaignContext& context, const FoundInput& found);

}  // namespace canproof::host
