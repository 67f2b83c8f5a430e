// SPDX-License-Identifier: Apache-2.0
// The report of a complete or interrupted campaign, as a page and as JSON.
#pragma once

#include <optional>
#include <string>

#include "host/assess/fuzz/campaign_state.hpp"

namespace canproof::host {

/// Returns the HTML page of a campaign. `last` has the figures of the previous campaign, for comparison.
std::string write_campaign_html(const CampaignState& state, const std::optional<Night>& last);
nlohmann::json write_campaign_json(const CampaignState& state, const std::optional<Night>& last);
/// Returns the content of exhibit.json, which describes the campaign in the evidence pack
/// (src/host/assess/evidence/exhibit.hpp).
nlohmann::json write_campaign_exhibit(const CampaignState& state);
/// Returns the figures of this campaign with which the next campaign compares its own figures.
Night night_of(const CampaignState& state);

}  // namespace canproof::host
