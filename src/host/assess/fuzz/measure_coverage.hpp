// Lines of the firmware that a campaign reached.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

/// Runs the corpora with the build that counts lines. False when it was interrupted; may be repeated.
bool measure_coverage(const CampaignContext& context);

}  // namespace canproof::host
