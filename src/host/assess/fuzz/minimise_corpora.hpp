// SPDX-License-Identifier: Apache-2.0
// Minimises the corpora.
#pragma once

#include "host/assess/fuzz/campaign_files.hpp"

namespace canproof::host {

/// Keeps only those inputs of each corpus that together reach the same code as all inputs. Returns false when
/// interrupted; another call minimises all corpora again.
bool minimise_corpora(const CampaignContext& context);

}  // namespace canproof::host
