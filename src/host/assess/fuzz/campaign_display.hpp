// SPDX-License-Identifier: Apache-2.0
// The progress of a campaign: on a terminal one live line per target, otherwise a line for each change of a target.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include "host/assess/fuzz/campaign_state.hpp"

namespace canproof::host {

class CampaignDisplay {
  public:
    CampaignDisplay(std::FILE* out, bool is_table) : out_{out}, is_table_{is_table} {}

    /// Prints a line, which later output does not overwrite.
    void say(const std::string& text);
    /// Prints the progress of one target, unless it is shown in a table. `inputs` is the number of this target's inputs
    /// that made a run fail.
    void news(const TargetRecord& target, std::size_t inputs);
    /// Redraws the table, if there is one, at most twice a second.
    void draw(const CampaignState& state);
    /// Draws the table for the last time, at the end of a phase.
    void leave(const CampaignState& state);

  private:
    void table(const CampaignState& state);

    std::FILE* out_;
    bool is_table_;
    std::size_t rows_{0};
    std::chrono::steady_clock::time_point drawn_{};
};

}  // namespace canproof::host
