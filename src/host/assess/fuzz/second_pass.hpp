// A second look at the inputs that a campaign kept.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

/// Runs the kept inputs under valgrind. False when it was interrupted; may be repeated.
bool look_again_with_valgrind(const CampaignContext& context);

}  // namespace canproof::host
