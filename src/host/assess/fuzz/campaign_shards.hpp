// SPDX-License-Identifier: Apache-2.0
// A campaign on several machines: each fuzzes a shard of the targets into a corpus folder of its own, and one of them
// takes these folders over and does the rest of the campaign.
#pragma once

#include <filesystem>
#include <vector>

#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

/// The phase with which a campaign continues when all targets have had their time.
constexpr const char* phase_after_fuzzing = "sorting findings";

/// Copies inputs and findings' inputs of every shard below `folder` to `files`, and returns the state of a campaign
/// that has fuzzed all `targets`. A subfolder of `folder` is the corpus folder of a shard. Throws InputError when a
/// shard is missing, has not finished, or belongs to another campaign: other targets, minutes or seed.
CampaignState merge_shards(const std::filesystem::path& folder, const std::vector<FuzzTarget>& targets,
                           const CampaignFiles& files);

}  // namespace canproof::host
