// SPDX-License-Identifier: Apache-2.0
// The lines of the firmware that a campaign reached.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

/// Runs the corpora with the coverage build and stores the reached lines in the state of the campaign. Returns false
/// when interrupted; another call starts the measurement again.
bool measure_coverage(const CampaignContext& context);

}  // namespace canproof::host
