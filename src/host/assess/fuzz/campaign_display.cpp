// SPDX-License-Identifier: Apache-2.0
#include "host/assess/fuzz/campaign_display.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/report/markup.hpp"

namespace canproof::host {

namespace {

constexpr auto redraw = std::chrono::milliseconds{500};

/// Returns the table line that shows a target's progress. `bad` is the text of its last column, about failures.
std::string row(const TargetRecord& target, const std::string& bad) {
    const double rate = target.seconds > 0.0 ? static_cast<double>(target.executions) / target.seconds : 0.0;
    return fmt::format("{:<14}{:>8.0f} s{:>14} executions{:>10.0f}/s{:>8} edges{:>20}", target.name, target.seconds,
                       grouped(target.executions), rate, grouped(target.edges()), bad);
}

std::size_t findings_of(const CampaignState& state, const std::string& target) {
    return static_cast<std::size_t>(std::count_if(state.findings.begin(), state.findings.end(),
                                                  [&](const Finding& one) { return one.target == target; }));
}

}  // namespace

void CampaignDisplay::say(const std::string& text) {
    rows_ = 0;
    fmt::print(out_, "{}\n", text);
    std::fflush(out_);
}

void CampaignDisplay::news(const TargetRecord& target, std::size_t inputs) {
    if (!is_table_) {
        say(row(target, inputs == 0 ? "" : fmt::format("{} bad input(s)", inputs)));
    }
}

void CampaignDisplay::draw(const CampaignState& state) {
    const auto now = std::chrono::steady_clock::now();
    if (is_table_ && now - drawn_ >= redraw) {
        drawn_ = now;
        table(state);
    }
}

void CampaignDisplay::leave(const CampaignState& state) {
    if (is_table_) {
        table(state);
    }
    rows_ = 0;
}

void CampaignDisplay::table(const CampaignState& state) {
    if (rows_ > 0) {
        fmt::print(out_, "\x1b[{}A", rows_);
    }
    for (const TargetRecord& target : state.targets) {
        fmt::print(out_, "\x1b[2K{}\n", row(target, fmt::format("{} finding(s)", findings_of(state, target.name))));
    }
    fmt::print(out_, "\x1b[2K{}: {:.0f} of {:.0f} s of work\n", state.phase, state.seconds(),
               state.minutes * 60.0 * state.jobs);
    rows_ = state.targets.size() + 1;
    std::fflush(out_);
}

}  // namespace canproof::host
