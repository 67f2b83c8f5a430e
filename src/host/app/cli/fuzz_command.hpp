// `canproof fuzz`: a campaign that Ctrl-C stops in order.
#pragma once

#include "host/assess/fuzz/campaign.hpp"

namespace canproof::host {

/// Returns the exit status of run_campaign().
int fuzz_targets(const CampaignOptions& options);

}  // namespace canproof::host
