// SPDX-License-Identifier: Apache-2.0
#include "host/app/panel/lamp.hpp"

#include <fmt/format.h>

#include <vector>

namespace canproof::host {

namespace {

// An LED that has not changed for this time is steady, because every pause of CiA 303-3 is shorter.
constexpr Duration settled = milliseconds(2000);
// Flashes that start at least this time apart belong to two groups. The flashes of one group start 400 ms apart.
constexpr Duration between_groups = milliseconds(800);
constexpr int most_flashes = 4;
constexpr Duration slowest_flicker = milliseconds(150);

}  // namespace

bool LampHistory::show(bool lit, Instant now) {
    if (!edges_.empty() && edges_.back().lit == lit) {
        return false;
    }
    const bool changed = !edges_.empty() || lit;
    edges_.push_back({now, lit});
    if (edges_.size() > edges_kept) {
        edges_.pop_front();
    }
    return changed;
}

std::string LampHistory::words(Instant now) const {
    if (edges_.empty() || elapsed(edges_.back().time, now).us > settled.us) {
        return lit() ? "on" : "off";
    }
    std::vector<Instant> rises;
    for (const LampEdge& edge : edges_) {
        if (edge.lit && elapsed(edge.time, now).us < 4U * settled.us) {
            rises.push_back(edge.time);
        }
    }
    if (rises.size() < 2U) {
        return lit() ? "on" : "off";
    }
    // Counts the flashes between the last two pauses: they form the newest complete group.
    int in_group = 1;
    int groups = 0;
    for (std::size_t i = rises.size() - 1; i > 0; --i) {
        const bool pause = elapsed(rises[i - 1], rises[i]).us >= between_groups.us;
        if (pause && ++groups == 2) {
            return fmt::format("{} flash{}", in_group, in_group == 1 ? "" : "es");
        }
        in_group = pause ? 1 : in_group + 1;
        if (in_group > most_flashes) {
            const Duration round = elapsed(rises[rises.size() - 2], rises.back());
            return round.us < slowest_flicker.us ? "flickering" : "blinking";
        }
    }
    return "flashing";
}

IndicatorPattern run_lamp(NmtState state) {
    constexpr Duration flash = milliseconds(200);
    switch (state) {
        case NmtState::operational:
            return {0U, flash, {}, {}};
        case NmtState::stopped:
            return {1U, flash, {}, milliseconds(1000)};
        case NmtState::pre_operational:
            return {1U, flash, {}, flash};
        case NmtState::initialising:
        default:
            return {};
    }
}

}  // namespace canproof::host
