// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/decisions_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "host/assess/evidence/audit_pages.hpp"
#include "host/assess/evidence/item_links.hpp"
#include "host/assess/evidence/review_notes.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

constexpr std::array<const char*, 3> severities{"high", "medium", "low"};

using DecisionsByTopic = std::map<std::string, std::vector<const Decision*>>;

/// Returns the decisions of a device, or of the shared rules, by topic, which is the name of their file in the register
/// without `_decisions`.
DecisionsByTopic by_topic(const Part& part) {
    const std::string ending = "_decisions";
    DecisionsByTopic topics;
    for (const auto& one : part.decisions) {
        const std::string service = service_of(one);
        topics[service.substr(0, service.rfind(ending))].push_back(&one);
    }
    return topics;
}

std::string readings_of(const Decision& decision) {
    std::string text;
    for (const auto& reading : decision.readings) {
        text += fmt::format("<p>{} <small>{}</small></p>", prose(reading.says), escaped(reading.source));
    }
    return text;
}

std::vector<std::string> row_of(const Part& part, const Decision& decision, const ItemLinks& links,
                                const ReviewNotes& notes) {
    const std::string affects = link_to_each(links, decision.affects);
    return {fmt::format("<code id=\"{0}\">{0}</code><br><small class=severity>{1}</small>", decision.id,
                        escaped(decision.severity)),
            prose(decision.text), readings_of(decision),
            fmt::format("<p><b>{}</b></p><p>{}</p>{}", prose(decision.chosen), prose(decision.because),
                        notes.of(part, decision.id)),
            affects.empty() ? prose(decision.none) : affects};
}

std::string topic_markup(const Part& part, const std::string& topic, const std::vector<const Decision*>& decisions,
                         const ItemLinks& links, const ReviewNotes& notes) {
    std::vector<std::vector<std::string>> rows;
    for (const auto* one : decisions) {
        rows.push_back(row_of(part, *one, links, notes));
    }
    std::string counts;
    for (const char* const severity : severities) {
        const auto count = std::count_if(decisions.begin(), decisions.end(),
                                         [severity](const Decision* one) { return one->severity == severity; });
        counts += count == 0 ? "" : fmt::format(" <small>{} {}</small>", count, severity);
    }
    const std::string title = service_title(topic);
    return fmt::format(
        "<details><summary><h3>{}</h3>{}</summary>\n{}</details>\n", escaped(title), counts,
        html_table("Decisions: " + title,
                   {{"Decision", 11}, {"Question", 20}, {"Readings", 26}, {"Chosen, because", 30}, {"Affects", 13}},
                   rows));
}

}  // namespace

std::string decisions_page(const PackInput& input) {
    const ItemLinks links = links_of(input);
    const ReviewNotes notes{input};
    std::size_t all = 0;
    std::string parts;
    for (const auto& audit : input.audits) {
        const Part& part = *audit.part;
        if (part.decisions.empty()) {
            continue;
        }
        all += part.decisions.size();
        parts += fmt::format("<h2>{}</h2>\n", escaped(title_of(part)));
        for (const auto& [topic, decisions] : by_topic(part)) {
            parts += topic_markup(part, topic, decisions, links, notes);
        }
    }
    return fmt::format(
        "<p>In {} places the manuals contradict themselves, each other or CiA's standards, or leave a question open. A "
        "decision settles each place: by the standard, then by the manual's own consistency, then by the safer "
        "failure.</p>\n<p>The severity is a judgement by the authors, without a rule: how much it would harm a user "
        "who expects another reading. A topic opens with a click; a search opens the topics "
        "that have a hit.</p>\n<div class=\"filtered wide\">\n{}{}</div>\n",
        all, html_filter({{"Severity", ".severity", {severities.begin(), severities.end()}}}), parts);
}

}  // namespace canproof::host
