// SPDX-License-Identifier: Apache-2.0
// The fuzzing phase of a campaign.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

/// Fuzzes all targets in turn until their time is over. Returns false when interrupted; another call continues.
bool fuzz_all(const CampaignContext& context);

}  // namespace canproof::host
