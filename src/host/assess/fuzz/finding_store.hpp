// Where findings stay: a folder each below the corpus, and the input among the committed ones.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"
#include "host/assess/fuzz/fuzzer_output.hpp"

namespace canproof::host {

struct FoundInput {
    const FuzzTarget* target{nullptr};
    std::filesystem::path input;
    std::filesystem::path output;  ///< of the run that it ended
    Failure failure;
    bool reproduces{true};
    std::string pass;
    std::size_t times{1};
};

/// Keeps input, output and, where the target gives frames to a device, the candump log with the command that replays
/// it; lands the input as regression test when it reproduces. A bug that this campaign knows is only counted.
void store_finding(const CampaignContext& context, const FoundInput& found);

}  // namespace canproof::host
