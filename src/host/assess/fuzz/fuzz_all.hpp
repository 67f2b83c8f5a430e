// The fuzzing of a campaign.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

/// Fuzzes all targets in turn until their time is over. False when it was interrupted; may be repeated.
bool fuzz_all(const CampaignContext& context);

}  // namespace canproof::host
