// Inputs that ended a run, as findings.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

/// One finding a bug, as small as it gets, with what replays it. False when it was interrupted; may be repeated.
bool sort_findings(const CampaignContext& context);

}  // namespace canproof::host
