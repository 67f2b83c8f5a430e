// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/register_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/assess/evidence/item_links.hpp"
#include "host/assess/evidence/manual_page.hpp"
#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/statement_audit.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

/// Returns the table of conditions that installers and operators must meet. No test shows that they are met, because
/// the firmware does not control them.
std::string conditions_table(const Manual& manual) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& section : manual.sections) {
        for (const auto& condition : section.conditions) {
            rows.push_back({escaped(section.ref), escaped(section.title), prose(condition)});
        }
    }
    return rows.empty()
               ? ""
               : "<h3>Conditions of use</h3>\n" +
                     html_table("Conditions of use", {{"Section", 10}, {"Title", 30}, {"Condition"}}, rows, Search::no);
}

/// Returns a table with one row for each manual and its coverage.
std::string manuals_table(const PackInput& input) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& audit : input.audits) {
        const Manual* manual = input.content->manual(audit.part->info.manual);
        if (manual == nullptr) {
            continue;
        }
        auto count = count_statements(audit);
        const auto bare = std::count_if(audit.sections.begin(), audit.sections.end(),
                                        [](const AuditedSection& section) { return !section.covered; });
        rows.push_back({fmt::format("<a href=\"{}\">{}</a>", manual_page_name(*audit.part), escaped(manual->key)),
                        std::to_string(audit.sections.size()), std::to_string(bare),
                        std::to_string(audit.statements.size()), std::to_string(count["shown"]),
                        std::to_string(count["explained"]),
                        std::to_string(count["open"] + count["suspect"] + count["failed"])});
    }
    return html_table("Coverage of the manuals",
                      {{"Manual", 22},
                       {"Normative sections"},
                       {"Not covered"},
                       {"Statements"},
                       {"Shown"},
                       {"Explained"},
                       {"Not shown"}},
                      rows);
}

/// Returns a table, for a manual without statements, of its normative sections, each with the items that name the
/// section as their source.
std::string sections_table(const PartAudit& audit, const ItemLinks& links) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& section : audit.sections) {
        const std::string covered = link_to_each(links, section.covered_by);
        rows.push_back({escaped(section.section->ref), escaped(section.section->title),
                        covered.empty() ? html_state("open") : covered});
    }
    return html_table("Normative sections", {{"Section", 10}, {"Title", 30}, {"Covered by"}}, rows, Search::yes);
}

/// Returns a table of the manual's sections that are not normative, each with the reason.
std::string informative_table(const Manual& manual) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& section : manual.sections) {
        if (!section.normative && !section.reason.empty()) {
            rows.push_back({escaped(section.ref), escaped(section.title), prose(section.reason)});
        }
    }
    return rows.empty() ? ""
                        : "<h3>Sections without requirements</h3>\n" +
                              html_table("Sections without requirements", {{"Section", 10}, {"Title", 30}, {"Why"}},
                                         rows, Search::no);
}

}  // namespace

std::string sections_page(const PackInput& input) {
    const ItemLinks links = links_of(input);
    std::string text =
        "<p>This page shows how far the items of the register cover the demands of each manual. The page of a manual "
        "has its sections with our statement of each normative sentence. For a manual without statements, the coverage "
        "is counted by section.</p>\n" +
        manuals_table(input);
    for (const auto& audit : input.audits) {
        const Manual* manual = input.content->manual(audit.part->info.manual);
        if (manual == nullptr) {
            continue;
        }
        text += fmt::format("<h2 id=\"{}\">{}</h2><p class=quiet>{}, {}, {}</p>\n", escaped(audit.part->name),
                            escaped(manual->title), escaped(manual->publisher), escaped(manual->revision),
                            escaped(manual->date));
        text += manual->statements.empty() ? sections_table(audit, links) : "";
        text += conditions_table(*manual) + informative_table(*manual);
    }
    return text;
}

std::string tests_page(const PackInput& input) {
    // for each suite: the names of its test cases, and the number of failed test cases
    std::map<std::string, std::pair<std::vector<std::string>, std::size_t>> suites;
    std::vector<std::vector<std::string>> failed;
    for (const auto& one : input.evidence.cases) {
        auto& [names, failures] = suites[one.suite];
        names.push_back(escaped(one.name));
        failures += one.passed ? 0 : 1;
        if (!one.passed) {
            failed.push_back(
                {escaped(one.suite + "." + one.name), fmt::format("<code>{}</code>", escaped(one.failure))});
        }
    }
    std::string text = fmt::format("<p>{} test cases, {} failed.</p>\n", input.evidence.tests, input.evidence.failed);
    if (!failed.empty()) {
        text += "<h2 class=open>Failed</h2>" + html_table("Failed test cases", {{"Case"}, {"Message"}}, failed);
    }
    std::vector<std::vector<std::string>> rows;
    for (const auto& [suite, counts] : suites) {
        const auto& [names, failures] = counts;
        rows.push_back({escaped(suite), std::to_string(names.size()), html_state(failures == 0 ? "holds" : "open"),
                        fmt::format("{}", fmt::join(names, ", "))});
    }
    return text + html_table("Test suites", {{"Suite", 18}, {"Cases", 7}, {"State", 9}, {"Names"}}, rows, Search::yes);
}

std::string plots_page(const PackInput& input) {
    std::string text =
        "<p>The plots show the behaviour of the devices, drawn from their frames and outputs. A plot opens alone with "
        "a "
        "click.</p>\n";
    for (const auto& [name, figure] : input.figures) {
        text += html_figure(fmt::format("<a href=\"plots/{0}\"><img src=\"plots/{0}\" alt=\"{1}\" loading=lazy></a>",
                                        escaped(name), escaped(figure.words)),
                            figure.title);
    }
    return text;
}

}  // namespace canproof::host
