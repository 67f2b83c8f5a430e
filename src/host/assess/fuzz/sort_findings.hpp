// SPDX-License-Identifier: Apache-2.0
// Turns inputs that ended a run of a fuzz target into findings.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

/// Stores one finding for each bug, with a minimised input and the files to replay it. Returns false when interrupted;
/// another call continues.
bool sort_findings(const CampaignContext& context);

}  // namespace canproof::host
