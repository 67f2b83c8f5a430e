// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/hazards_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "host/assess/evidence/item_links.hpp"
#include "host/assess/evidence/review_notes.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

using StatusById = std::map<std::string, std::string>;

StatusById status_of_items(const PackInput& input) {
    StatusById all;
    for (const auto& audit : input.audits) {
        for (const auto& item : audit.items) {
            all[item.item->id] = item.status();
        }
    }
    return all;
}

/// Returns whether a requirement that prevents the failure has another status than `shown` in this build.
bool is_open(const Hazard::Failure& failure, const StatusById& status) {
    return std::any_of(failure.prevented_by.begin(), failure.prevented_by.end(), [&](const std::string& id) {
        const auto found = status.find(id);
        return found != status.end() && found->second != "shown";
    });
}

/// Returns the row of one failure. `review` is the note on the review of the hazard, as markup; it is in the row of the
/// hazard's first failure.
std::vector<std::string> failure_row(const Hazard& hazard, const Hazard::Failure& failure, const StatusById& status,
                                     const ItemLinks& links, const std::string& review) {
    const bool none = failure.prevented_by.empty();
    const bool first = &failure == &hazard.failures.front();
    const std::string anchor = first ? fmt::format(" id=\"{}\"", hazard.id) : "";
    return {fmt::format("<code{}>{}</code><br>{}{}", anchor, hazard.id, escaped(hazard.text), first ? review : ""),
            escaped(hazard.safe_state),
            escaped(failure.text),
            none ? escaped(failure.reason) : link_to_each(links, failure.prevented_by),
            link_to_each(links, hazard.decisions),
            none ? "not prevented" : html_state(is_open(failure, status) ? "open" : "shown")};
}

}  // namespace

FailureCounts count_failures(const PackInput& input) {
    const StatusById status = status_of_items(input);
    FailureCounts counts;
    for (const auto& audit : input.audits) {
        for (const auto& hazard : audit.part->hazards) {
            ++counts.hazards;
            for (const auto& failure : hazard.failures) {
                ++counts.failures;
                counts.unprevented += failure.prevented_by.empty() ? 1U : 0U;
                counts.open += is_open(failure, status) ? 1U : 0U;
            }
        }
    }
    return counts;
}

std::string hazards_page(const PackInput& input) {
    const StatusById status = status_of_items(input);
    const ReviewNotes notes{input};
    const ItemLinks links = links_of(input);
    std::string text =
        "<p>The tables list each hazard of an output or a message, its safe state, the failures that can violate this "
        "state, and the requirements that prevent these failures. A failure that the device does not prevent has a "
        "reason; the integrator must assess this failure.</p>\n";
    for (const auto& audit : input.audits) {
        std::vector<std::vector<std::string>> rows;
        for (const auto& hazard : audit.part->hazards) {
            for (const auto& failure : hazard.failures) {
                rows.push_back(failure_row(hazard, failure, status, links, notes.of(*audit.part, hazard.id)));
            }
        }
        if (!rows.empty()) {
            text += fmt::format("<h2>{}</h2>\n", escaped(audit.part->info.title)) +
                    html_table("Hazards: " + audit.part->info.title,
                               {{"Hazard", 22},
                                {"Safe state", 16},
                                {"Failure", 22},
                                {"Prevented by, or why not", 22},
                                {"Decisions", 10},
                                {"State", 8}},
                               rows, Search::yes);
        }
    }
    return text;
}

}  // namespace canproof::host
