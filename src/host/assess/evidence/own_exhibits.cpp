// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/own_exhibits.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/assess/coverage/coverage.hpp"
#include "host/assess/coverage/coverage_records.hpp"
#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/evidence/hazards_page.hpp"
#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/evidence/reviews_page.hpp"
#include "host/assess/mutation/mutation_counts.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/assess/trace/statement_audit.hpp"

namespace canproof::host {

namespace {

Exhibit::State state_of(const bool good) {
    return good ? Exhibit::State::holds : Exhibit::State::open;
}

Exhibit exhibit(const char* key, const char* title, const bool good, const std::string& says, const char* page) {
    return {key, title, state_of(good), says, page};
}

/// Returns an exhibit for one kind of test. Its state is `holds` when tests of this kind ran and all of them passed.
Exhibit runs_exhibit(const PackInput& input, const char* key, const char* kind, const char* title) {
    std::size_t runs = 0;
    std::size_t failed = 0;
    for (const auto& [id, verdicts] : input.evidence.verdicts) {
        for (const auto& verdict : verdicts) {
            runs += verdict.kind == kind ? 1 : 0;
            failed += verdict.kind == kind && !verdict.passed ? 1 : 0;
        }
    }
    return exhibit(key, title, runs > 0 && failed == 0,
                   fmt::format("{} claims of requirements by {} runs, {} failed", runs, kind, failed), "tests.html");
}

Exhibit audit_exhibit(const PackInput& input) {
    std::size_t items = 0;
    std::size_t open = 0;
    for (const auto& audit : input.audits) {
        items += audit.items.size();
        open += audit.gaps.size();
    }
    return exhibit(
        "audit", "Audit", open == 0,
        fmt::format("{} items of the register; {} gaps (an item without code, or without a required test that passed)",
                    items, open),
        "audit.html");
}

Exhibit suspects_exhibit(const PackInput& input) {
    std::size_t suspects = 0;
    for (const auto& audit : input.audits) {
        suspects += audit.suspects.size();
    }
    const auto counts = count_all_reviews(input);
    const auto items = counts.find(ReviewedKind::item);
    const std::size_t text_alone =
        items == counts.end() ? 0 : items->second.author_text + items->second.independent_text;
    return exhibit(
        "suspects", "Suspects", suspects == 0,
        fmt::format("{} items, decisions, hazards or dispositions of sections have changed since their latest "
                    "review; for {} items this review did not include code and tests. {}",
                    suspects, text_alone, review_sentences(counts)),
        "reviews.html");
}

Exhibit sections_exhibit(const PackInput& input) {
    std::size_t sections = 0;
    std::size_t bare = 0;
    for (const auto& audit : input.audits) {
        for (const auto& section : audit.sections) {
            ++sections;
            bare += section.covered ? 0 : 1;
        }
    }
    return exhibit("sections", "Sections of the manuals", bare == 0,
                   fmt::format("{} normative sections, {} with neither a statement nor an item", sections, bare),
                   "sections.html");
}

/// Returns an exhibit with the state `holds` when every manual has statements (demands) and every statement names an
/// item or has a reason. Returns nothing when no manual has statements. Does not check whether tests of the items
/// passed; the audit does.
std::optional<Exhibit> statements_exhibit(const PackInput& input) {
    std::size_t statements = 0;
    std::size_t bare = 0;
    std::map<std::string, std::size_t> all;
    std::vector<std::string> without;
    for (const auto& audit : input.audits) {
        const std::string& manual = audit.part->info.manual;
        if (!manual.empty() && audit.statements.empty()) {
            without.push_back(manual + " has no statements: its coverage is counted by section");
        }
        for (const auto& [status, count] : count_statements(audit)) {
            all[status] += count;
            statements += count;
        }
        bare += static_cast<std::size_t>(std::count_if(audit.statements.begin(), audit.statements.end(),
                                                       [](const auto& one) { return one.statement->is_open(); }));
    }
    if (statements == 0) {
        return std::nullopt;
    }
    Exhibit made =
        exhibit("statements", "Statements of the manuals", bare == 0 && without.empty(),
                fmt::format("{} normative statements, {} of them with neither an item nor a reason; {} shown, {} "
                            "explained by a reason, {} with an item that is not shown",
                            statements, bare, all["shown"], all["explained"],
                            all["open"] - bare + all["suspect"] + all["failed"]),
                "sections.html");
    made.open = without;
    return made;
}

Exhibit decisions_exhibit(const PackInput& input) {
    std::size_t decisions = 0;
    for (const auto& audit : input.audits) {
        decisions += audit.part->decisions.size();
    }
    return exhibit("decisions", "Decisions", true,
                   fmt::format("{} contradictions and gaps of the manuals, each decided with its reason", decisions),
                   "decisions.html");
}

Exhibit hazards_exhibit(const PackInput& input) {
    const FailureCounts counts = count_failures(input);
    return exhibit(
        "hazards", "Hazards", counts.open == 0,
        fmt::format(
            "{} hazards with {} failures; {} failures have a preventing requirement that is not shown, {} are not "
            "prevented by the device and have a reason",
            counts.hazards, counts.failures, counts.open, counts.unprevented),
        "hazards.html");
}

Exhibit orphans_exhibit(const std::vector<std::string>& orphans) {
    return exhibit("orphans", "Orphans", orphans.empty(),
                   fmt::format("{} pieces of code or tests without a requirement", orphans.size()), "");
}

Exhibit tests_exhibit(const PackInput& input) {
    return exhibit("tests", "Tests", input.evidence.tests > 0 && input.evidence.failed == 0,
                   fmt::format("{} test cases, {} failed", input.evidence.tests, input.evidence.failed), "tests.html");
}

Exhibit socketcan_exhibit(const Evidence& runs) {
    Exhibit made =
        exhibit("socketcan", "SocketCAN of a real kernel", runs.tests > 0 && runs.failed == 0,
                fmt::format("{} checks on vcan and emulated controllers, {} failed", runs.tests, runs.failed), "");
    for (const auto& one : runs.cases) {
        if (!one.passed) {
            made.open.push_back("failed: " + one.name);
        }
    }
    return made;
}

Exhibit coverage_exhibit(const MeasuredCoverage& coverage) {
    const CoverageTotals totals = totals_of(coverage.files);
    const CoverageTotals host = host_totals_of(coverage.files);
    const std::size_t open = coverage.verdict.open();
    Exhibit made = exhibit(
        "coverage", "Structural coverage", coverage.verdict.holds(),
        fmt::format("lines {:.1f} %, branches {:.1f} %, MC/DC {:.1f} %; {} places not reached, {} of them without a "
                    "reason",
                    totals.lines.percent(), totals.branches.percent(), totals.conditions.percent(),
                    coverage.verdict.gaps.size(), open),
        "coverage.html");
    if (host.lines.total != 0) {
        made.says += fmt::format("; the host's buses and replay: MC/DC {:.1f} %", host.conditions.percent());
    }
    if (open != 0) {
        made.open.push_back(fmt::format("{} places in the code that no test reaches, without a reason", open));
    }
    if (!coverage.verdict.enough_conditions()) {
        made.open.push_back(fmt::format("MC/DC {:.1f} %, less than the required {:.0f} %", totals.conditions.percent(),
                                        CoverageVerdict::least_conditions));
    }
    if (!coverage.verdict.enough_host_conditions()) {
        made.open.push_back(fmt::format("MC/DC of the host's buses and replay {:.1f} %, less than {:.0f} %",
                                        host.conditions.percent(), CoverageVerdict::least_host_conditions));
    }
    for (const auto& record : coverage.verdict.unused) {
        made.open.push_back(
            fmt::format("reports/coverage.toml:{}: the record of `{}` matches no gap", record.line, record.code));
    }
    return made;
}

Exhibit mutation_exhibit(const MeasuredMutation& mutation) {
    const MutationCount all = total(mutation.items);
    const auto items = std::count_if(mutation.items.begin(), mutation.items.end(),
                                     [](const auto& item) { return item.second.open() != 0; });
    Exhibit made = exhibit("mutation", "Mutation of generated cells", all.altered > 0 && all.open() == 0,
                           fmt::format("{} cells altered one at a time, {} noticed by a test that claims their "
                                       "requirement, {} survive with a reason, {} without",
                                       all.altered, all.noticed, all.justified, all.open()),
                           "mutation.html");
    if (all.open() != 0) {
        made.open.push_back(fmt::format("{} altered cells of {} items that no test notices", all.open(), items));
    }
    return made;
}

Exhibit target_exhibit(const std::string& markup) {
    return exhibit("target", "On the microcontroller", markup.find("class=open") == std::string::npos,
                   "flash, RAM, stack and instructions on an STM32F405, against their budgets and goals",
                   "target.html");
}

Exhibit absent(const ExpectedEvidence& expected) {
    Exhibit made{expected.key, expected.title, Exhibit::State::absent, "", ""};
    made.open.push_back(fmt::format("not part of this pack; {} creates it", expected.made_by));
    return made;
}

}  // namespace

Exhibits exhibits_of(const PackInput& input) {
    Exhibits all;
    const auto add = [&](Exhibit one, const std::string& measured_with) {
        if (const auto newer = input.newer.find(measured_with); newer != input.newer.end()) {
            mark_stale(one, newer->second);
        }
        all[one.key] = std::move(one);
    };
    add(audit_exhibit(input), "tests");
    add(suspects_exhibit(input), "");
    add(sections_exhibit(input), "");
    if (auto statements = statements_exhibit(input)) {
        add(std::move(*statements), "");
    }
    add(decisions_exhibit(input), "");
    add(hazards_exhibit(input), "");
    add(tests_exhibit(input), "tests");
    add(runs_exhibit(input, "properties", "property", "Properties"), "tests");
    add(runs_exhibit(input, "corpora", "fuzz", "Corpora of the fuzz targets, replayed"), "tests");
    if (input.orphans.has_value()) {
        add(orphans_exhibit(*input.orphans), "tests");
    }
    if (input.socketcan.has_value()) {
        add(socketcan_exhibit(*input.socketcan), "socketcan");
    }
    if (input.coverage.has_value()) {
        add(coverage_exhibit(*input.coverage), "coverage");
    }
    if (input.mutation.has_value()) {
        add(mutation_exhibit(*input.mutation), "mutation");
    }
    if (input.target.has_value()) {
        add(target_exhibit(*input.target), "target");
    }
    for (auto one : input.exhibits) {
        one.page = one.page.empty() ? one.key + ".html" : one.page;
        add(std::move(one), "");
    }
    for (const auto& expected : input.argument.evidence) {
        if (all.count(expected.key) == 0) {
            add(absent(expected), expected.key);
        }
    }
    return all;
}

}  // namespace canproof::host
