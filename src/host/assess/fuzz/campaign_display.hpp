// A campaign's progress: on a terminal one live line a target, elsewhere a line whenever a target has news.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include "host/assess/fuzz/campaign_state.hpp"

namespace canproof::host {

class CampaignDisplay {
  public:
    CampaignDisplay(std::FILE* out, bool is_table) : out_{out}, is_table_{is_table} {}

    /// A line that stays.
    void say(const std::string& text);
    /// News of one target, in short; `inputs` ended a run so far.
    void news(const TargetRecord& target, std::size_t inputs);
    /// Redraws the table, not too often.
    void draw(const CampaignState& state);
    /// The last drawing stays.
    void leave(const CampaignState& state);

  private:
    void table(const CampaignState& state);

    std::FILE* out_;
    bool is_table_;
    std::size_t rows_{0};
    std::chrono::steady_clock::time_point drawn_{};
};

}  // namespace canproof::host
