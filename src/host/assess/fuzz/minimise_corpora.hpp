// Corpora without what brings nothing.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

/// Keeps of each corpus the inputs that reach something others do not. False when it was interrupted; may be repeated.
bool minimise_corpora(const CampaignContext& context);

}  // namespace canproof::host
