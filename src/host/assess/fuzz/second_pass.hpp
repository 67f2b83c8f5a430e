// SPDX-License-Identifier: Apache-2.0
// The second pass of a campaign, which runs the inputs that the campaign kept under valgrind.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

/// Runs the kept inputs under valgrind and stores its findings. Returns false when interrupted; another call runs the
/// pass again.
bool look_again_with_valgrind(const CampaignContext& context);

}  // namespace canproof::host
