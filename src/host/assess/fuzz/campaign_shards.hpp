// SPDX-License-Identifier: Apache-2.0
// Runs one campaign on several machines. Each machine fuzzes a shard of the targets into its own corpus folder. One
// machine then merges these folders and does the other phases of the campaign.
#pragma once

#include <filesystem>
#include <vector>

#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

/// Name of the phase of a campaign that follows the fuzzing.
constexpr const char* phase_after_fuzzing = "sorting findings";

/// Copies the inputs of every shard below `folder` to `files`, also the artifacts (the inputs that ended a run).
/// Returns the state of a campaign that has fuzzed all `targets`. Each subfolder of `folder` is the corpus folder of
/// one shard. Throws InputError when a shard is missing, has not finished, or belongs to another campaign (other
/// targets, minutes or seed).
CampaignState merge_shards(const std::filesystem::path& folder, const std::vector<FuzzTarget>& targets,
                           const CampaignFiles& files);

}  // namespace canproof::host
