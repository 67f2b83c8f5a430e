// The report of a campaign, whole or cut short: a page and the same as JSON.
#pragma once

#include <optional>
#include <string>

#include "host/assess/fuzz/campaign_state.hpp"

namespace canproof::host {

/// `last`: the night before, to compare with.
std::string write_campaign_html(const CampaignState& state, const std::optional<Night>& last);
nlohmann::json write_campaign_json(const CampaignState& state, const std::optional<Night>& last);
/// How the evidence pack shows it (src/host/assess/evidence/exhibit.hpp).
nlohmann::json write_campaign_exhibit(const CampaignState& state);
/// What the next night compares with.
Night night_of(const CampaignState& state);

}  // namespace canproof::host
