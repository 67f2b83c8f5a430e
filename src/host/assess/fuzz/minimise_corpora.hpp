// SPDX-License-Identifier: Apache-2.0
// Minimises the corpora.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

/// Keeps the inputs of each corpus that reach code which the others do not. Returns false when interrupted; the call
/// may be repeated.
bool minimise_corpora(const CampaignContext& context);

}  // namespace canproof::host
