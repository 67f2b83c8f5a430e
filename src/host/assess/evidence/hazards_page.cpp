// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/hazards_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "host/assess/evidence/audit_pages.hpp"
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

/// Returns whether at least one of the requirements that prevent the failure is not yet shown by passed tests.
bool is_open(const Hazard::Failure& failure, const StatusById& status) {
    return std::any_of(failure.prevented_by.begin(), failure.prevented_by.end(), [&](const std::string& id) {
        const auto found = status.find(id);
        return found != status.end() && found->second != "shown";
    });
}

std::vector<std::string> failure_row(const Hazard::Failure& failure, const StatusById& status, const ItemLinks& links) {
    const bool none = failure.prevented_by.empty();
    return {prose(failure.text), none ? prose(failure.reason) : link_to_each(links, failure.prevented_by),
            none ? "<span class=\"state partly\">– not prevented</span>"
                 : html_state(is_open(failure, status) ? "open" : "shown")};
}

/// Returns the markup of one hazard; `review` is the note on its review, as markup.
std::string hazard_markup(const Hazard& hazard, const StatusById& status, const ItemLinks& links,
                          const std::string& review) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& failure : hazard.failures) {
        rows.push_back(failure_row(failure, status, links));
    }
    const std::string decisions =
        hazard.decisions.empty() ? "" : fmt::format("<p>Decided by: {}.</p>\n", link_to_each(links, hazard.decisions));
    return fmt::format("<details open><summary><h3 id=\"{0}\"><code>{0}</code> {1}</h3></summary>\n", hazard.id,
                       prose(hazard.text)) +
           fmt::format("<p>Safe state: {}</p>\n{}{}\n", prose(hazard.safe_state), decisions, review) +
           html_table("Failures of " + hazard.id, {{"Failure", 42}, {"Prevented by, or why not", 44}, {"State", 14}},
                      rows) +
           "</details>\n";
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
        "<p>The page lists each hazard of an output or a message, its safe state, the failures that can violate this "
        "state, and the requirements that prevent these failures. A failure that the device does not prevent has a "
        "reason; the integrator must assess this failure.</p>\n<div class=filtered>\n" +
        html_filter({{"State", "td .state", {"shown", "open", "not prevented"}}});
    for (const auto& audit : input.audits) {
        if (audit.part->hazards.empty()) {
            continue;
        }
        text += fmt::format("<h2>{}</h2>\n", escaped(title_of(*audit.part)));
        for (const auto& hazard : audit.part->hazards) {
            text += hazard_markup(hazard, status, links, notes.of(*audit.part, hazard.id));
        }
    }
    return text + "</div>\n";
}

}  // namespace canproof::host
