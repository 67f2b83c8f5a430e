// SPDX-License-Identifier: Apache-2.0
// `canproof fuzz`: a fuzzing campaign, which Ctrl-C stops in an orderly way.
#pragma once

#include "host/assess/fuzz/campaign.hpp"

namespace canproof::host {

/// Runs the campaign. Returns the exit status of run_campaign().
int fuzz_targets(const CampaignOptions& options);

}  // namespace canproof::host
