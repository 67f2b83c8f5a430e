// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/register_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/assess/documents/item_words.hpp"
#include "host/assess/evidence/manual_page.hpp"
#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/mutation/mutation_counts.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/assess/trace/statement_audit.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

std::string joined(const std::vector<std::string>& words) {
    return escaped(fmt::format("{}", fmt::join(words, ", ")));
}

/// Returns the places in the code without their common prefix `src/`.
std::string places_of(const std::vector<std::string>& places) {
    const std::string common = "src/";
    std::string text;
    for (const auto& place : places) {
        const bool inside = place.rfind(common, 0) == 0;
        text += fmt::format("<code>{}</code><br>", escaped(inside ? place.substr(common.size()) : place));
    }
    return text;
}

std::string tests_of(const std::string& id, const Evidence& evidence) {
    std::string text;
    if (const auto found = evidence.verdicts.find(id); found != evidence.verdicts.end()) {
        for (const auto& verdict : found->second) {
            text +=
                fmt::format("<span class={}>{}</span>&nbsp;{} <small>{}</small><br>", verdict.passed ? "holds" : "open",
                            verdict.passed ? "✓" : "✗", escaped(verdict.test), verdict.kind);
        }
    }
    return text;
}

/// Returns the counts of the item's altered cells in words.
std::string mutants_of(const std::string& id, const PackInput& input) {
    if (!input.mutation.has_value() || input.mutation->items.count(id) == 0) {
        return "";
    }
    const MutationCount& count = input.mutation->items.at(id);
    return fmt::format("<small>{} of {} altered cells noticed</small>", count.noticed, count.altered);
}

/// Returns the facts of an object, the value of a constant, or the rows of a table.
std::string facts_of(const Part& part, const std::string& id) {
    const std::string words = item_words(part, id);
    return words.empty() ? "" : fmt::format("<br><small>{}</small>", escaped(words));
}

std::vector<std::string> item_row(const Part& part, const AuditedItem& audited, const PackInput& input) {
    const Item& item = *audited.item;
    std::string decisions;
    for (const auto& id : audited.decisions) {
        decisions += fmt::format("<a href=\"decisions.html#{0}\">{0}</a> ", id);
    }
    return {
        fmt::format("<code id=\"{0}\">{0}</code><br><small>{1}</small>", item.id, audited.word),
        fmt::format("{}{}<br><small>{}</small>", escaped(item.text), facts_of(part, item.id), joined(origins(item))),
        decisions,
        places_of(code_of(item.id, input.evidence)),
        tests_of(item.id, input.evidence) + mutants_of(item.id, input),
        html_state(audited.status())};
}

}  // namespace

std::string audit_page(const PackInput& input) {
    std::string text =
        "<p>Every item of the register with its text, its place in the manual, the decisions that affect it, the code "
        "that names it, and the tests that claim it with their results in this build.</p>\n";
    std::vector<std::vector<std::string>> rows;
    std::string gaps;
    for (const auto& audit : input.audits) {
        for (const auto& gap : audit.gaps) {
            gaps += fmt::format("<li>{}\n", escaped(gap));
        }
        for (const auto& item : audit.items) {
            rows.push_back(item_row(*audit.part, item, input));
        }
    }
    if (!gaps.empty()) {
        text += fmt::format("<h2 class=open>Gaps</h2><ul>{}</ul>\n", gaps);
    }
    return text + html_table({{"Item", 12}, {"Text", 30}, {"Decisions", 9}, {"Code", 16}, {"Tests", 25}, {"State", 8}},
                             rows, Search::yes);
}

/// Returns the table of conditions that installers and operators must keep. No test can show them, because the firmware
/// does not control them.
std::string conditions_table(const Manual& manual) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& section : manual.sections) {
        for (const auto& condition : section.conditions) {
            rows.push_back({escaped(section.ref), escaped(section.title), escaped(condition)});
        }
    }
    return rows.empty() ? ""
                        : "<h3>Conditions of use</h3>\n" +
                              html_table({{"Section", 10}, {"Title", 30}, {"Condition"}}, rows, Search::no);
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
    return html_table({{"Manual", 22},
                       {"Normative sections"},
                       {"Not covered"},
                       {"Statements"},
                       {"Shown"},
                       {"Explained"},
                       {"Not shown"}},
                      rows);
}

/// Returns a table of the normative sections of a manual without statements, each with the items that name it as their
/// source.
std::string sections_table(const PartAudit& audit) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& section : audit.sections) {
        std::string covered;
        for (const auto& id : section.covered_by) {
            covered += fmt::format("<a href=\"audit.html#{0}\">{0}</a> ", id);
        }
        rows.push_back({escaped(section.section->ref), escaped(section.section->title),
                        covered.empty() ? html_state("open") : covered});
    }
    return html_table({{"Section", 10}, {"Title", 30}, {"Covered by"}}, rows, Search::yes);
}

/// Returns the sections without requirements, each with its reason.
std::string informative_table(const Manual& manual) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& section : manual.sections) {
        if (!section.normative && !section.reason.empty()) {
            rows.push_back({escaped(section.ref), escaped(section.title), escaped(section.reason)});
        }
    }
    return rows.empty() ? ""
                        : "<h3>Sections without requirements</h3>\n" +
                              html_table({{"Section", 10}, {"Title", 30}, {"Why"}}, rows, Search::no);
}

std::string sections_page(const PackInput& input) {
    std::string text =
        "<p>The demands of the manuals, and the items that cover them. The page of a manual has its sections with our "
        "statement of each normative sentence. A manual without statements counts by section.</p>\n" +
        manuals_table(input);
    for (const auto& audit : input.audits) {
        const Manual* manual = input.content->manual(audit.part->info.manual);
        if (manual == nullptr) {
            continue;
        }
        text += fmt::format("<h2 id=\"{}\">{}</h2><p class=quiet>{}, {}, {}</p>\n", escaped(audit.part->name),
                            escaped(manual->title), escaped(manual->publisher), escaped(manual->revision),
                            escaped(manual->date));
        text += manual->statements.empty() ? sections_table(audit) : "";
        text += conditions_table(*manual) + informative_table(*manual);
    }
    return text;
}

std::string decisions_page(const PackInput& input) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& audit : input.audits) {
        for (const auto& decision : audit.part->decisions) {
            std::string readings;
            for (const auto& reading : decision.readings) {
                readings += fmt::format("{} <small>{}</small><br>", escaped(reading.says), escaped(reading.source));
            }
            std::string affects;
            for (const auto& id : decision.affects) {
                affects += fmt::format("<a href=\"audit.html#{0}\">{0}</a> ", id);
            }
            rows.push_back({fmt::format("<code id=\"{0}\">{0}</code><br><small>{1}</small>", decision.id,
                                        escaped(decision.severity)),
                            escaped(decision.text), readings,
                            fmt::format("<b>{}</b><br>{}", escaped(decision.chosen), escaped(decision.because)),
                            affects.empty() ? escaped(decision.none) : affects});
        }
    }
    return fmt::format(
               "<p>The manuals contradict themselves, each other and CiA's standards in {} places, or leave them open. "
               "Each is decided here: by the standard, then by the manual's own consistency, then by the safer "
               "failure. A decision is of severity high when it changes the wire or an output, medium when it changes "
               "the configuration or a range, low when it is editorial.</p>\n",
               rows.size()) +
           html_table({{"Decision", 9}, {"Question", 20}, {"Readings", 28}, {"Chosen, because", 30}, {"Affects", 13}},
                      rows, Search::yes);
}

std::string tests_page(const PackInput& input) {
    // by suite: the number of cases and the number of failed cases
    std::map<std::string, std::pair<std::size_t, std::size_t>> suites;
    std::vector<std::vector<std::string>> failed;
    for (const auto& one : input.evidence.cases) {
        auto& [cases, failures] = suites[one.suite];
        ++cases;
        failures += one.passed ? 0 : 1;
        if (!one.passed) {
            failed.push_back(
                {escaped(one.suite + "." + one.name), fmt::format("<code>{}</code>", escaped(one.failure))});
        }
    }
    std::string text = fmt::format("<p>{} test cases, {} failed.</p>\n", input.evidence.tests, input.evidence.failed);
    if (!failed.empty()) {
        text += "<h2 class=open>Failed</h2>" + html_table({{"Case"}, {"Message"}}, failed);
    }
    std::vector<std::vector<std::string>> rows;
    for (const auto& [suite, counts] : suites) {
        rows.push_back(
            {escaped(suite), std::to_string(counts.first), html_state(counts.second == 0 ? "holds" : "open")});
    }
    return text + html_table({{"Suite"}, {"Cases"}, {"State"}}, rows, Search::yes);
}

std::string plots_page(const PackInput& input) {
    std::string text = "<p>What the devices do, drawn from their own frames and outputs.</p><div class=grid>\n";
    for (const auto& figure : input.figures) {
        text +=
            fmt::format("<figure><a href=\"plots/{0}\"><img src=\"plots/{0}\" alt=\"{0}\" loading=lazy></a></figure>\n",
                        escaped(figure.first));
    }
    return text + "</div>\n";
}

}  // namespace canproof::host
