#include "host/evidence/pack.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/evidence/page.hpp"
#include "host/evidence/pages.hpp"
#include "host/evidence/sha256.hpp"

namespace canproof::host {

namespace {

Exhibit::State state_of(const bool good) {
    return good ? Exhibit::State::holds : Exhibit::State::open;
}

/// Whether runs of this kind are there and all passed.
Exhibit runs_exhibit(const PackInput& input, const std::string& key, const std::string& kind,
                     const std::string& title) {
    std::size_t runs = 0;
    std::size_t failed = 0;
    for (const auto& [id, verdicts] : input.evidence.verdicts) {
        for (const auto& verdict : verdicts) {
            runs += verdict.kind == kind ? 1 : 0;
            failed += verdict.kind == kind && !verdict.passed ? 1 : 0;
        }
    }
    return {key,
            title,
            state_of(runs > 0 && failed == 0),
            fmt::format("{} claims of requirements by {} runs, {} failed", runs, kind, failed),
            "tests.html",
            {}};
}

Exhibit audit_exhibit(const PackInput& input) {
    std::size_t items = 0;
    std::size_t open = 0;
    for (const auto& audit : input.audits) {
        items += audit.items.size();
        open += audit.gaps.size();
    }
    return {"audit",
            "Audit",
            state_of(open == 0),
            fmt::format("{} items of the register, {} without a passed test that they ask for", items, open),
            "audit.html",
            {}};
}

Exhibit sections_exhibit(const PackInput& input) {
    std::size_t sections = 0;
    std::size_t bare = 0;
    for (const auto& audit : input.audits) {
        for (const auto& section : audit.sections) {
            ++sections;
            bare += section.covered_by.empty() ? 1 : 0;
        }
    }
    return {
        "sections",          "Sections of the manuals",
        state_of(bare == 0), fmt::format("{} normative sections, {} without anything that covers them", sections, bare),
        "sections.html",     {}};
}

Exhibit decisions_exhibit(const PackInput& input) {
    std::size_t decisions = 0;
    for (const auto& audit : input.audits) {
        decisions += audit.part->decisions.size();
    }
    return {"decisions",
            "Decisions",
            Exhibit::State::holds,
            fmt::format("{} contradictions and gaps of the manuals, each decided with its reason", decisions),
            "decisions.html",
            {}};
}

Exhibit coverage_exhibit(const MeasuredCoverage& coverage) {
    const CoverageTotals totals = totals_of(coverage.files);
    const bool closed = coverage.verdict.open() == 0 && coverage.verdict.unused.empty();
    return {"coverage",
            "Structural coverage",
            state_of(closed),
            fmt::format(
                "lines {:.1f} %, branches {:.1f} %, MC/DC {:.1f} %; {} places not reached, {} of them without a reason",
                totals.lines.percent(), totals.branches.percent(), totals.conditions.percent(),
                coverage.verdict.gaps.size(), coverage.verdict.open()),
            "coverage.html",
            {}};
}

Exhibits exhibits_of(const PackInput& input) {
    Exhibits all;
    const auto add = [&all](Exhibit one) { all[one.key] = std::move(one); };
    add(audit_exhibit(input));
    add(sections_exhibit(input));
    add(decisions_exhibit(input));
    if (input.orphans.has_value()) {
        add({"orphans",
             "Orphans",
             state_of(input.orphans->empty()),
             fmt::format("{} pieces of code or tests without a requirement", input.orphans->size()),
             "",
             {}});
    }
    add({"tests",
         "Tests",
         state_of(input.evidence.tests > 0 && input.evidence.failed == 0),
         fmt::format("{} test cases, {} failed", input.evidence.tests, input.evidence.failed),
         "tests.html",
         {}});
    add(runs_exhibit(input, "properties", "property", "Properties"));
    if (input.coverage.has_value()) {
        add(coverage_exhibit(*input.coverage));
    }
    if (input.target.has_value()) {
        const bool open = input.target->find("class=open") != std::string::npos;
        add({"target",
             "On the microcontroller",
             state_of(!open),
             "flash, RAM, stack and instructions on an STM32F405, against their budgets and goals",
             "target.html",
             {}});
    }
    for (const auto& one : input.exhibits) {
        add(one);
    }
    return all;
}

std::vector<NavigationEntry> navigation_of(const PackInput& input) {
    std::vector<NavigationEntry> entries{{"index.html", "canproof"},      {"argument.html", "Argument"},
                                         {"audit.html", "Audit"},         {"sections.html", "Sections"},
                                         {"decisions.html", "Decisions"}, {"tests.html", "Tests"}};
    if (input.coverage.has_value()) {
        entries.push_back({"coverage.html", "Coverage"});
    }
    if (input.target.has_value()) {
        entries.push_back({"target.html", "Target"});
    }
    for (const auto& one : input.exhibits) {
        if (!one.page.empty()) {
            entries.push_back({one.page, one.title});
        }
    }
    entries.push_back({"plots.html", "Plots"});
    return entries;
}

}  // namespace

PackFiles make_pack(const PackInput& input) {
    const Exhibits exhibits = exhibits_of(input);
    const auto navigation = navigation_of(input);
    PackFiles files;
    const auto page = [&](const std::string& name, const std::string& title, const std::string& body) {
        files[name] = html_page(title, name, navigation, body);
    };
    page("index.html", "Evidence", overview_page(input, exhibits));
    page("argument.html", "Argument", argument_page(input, exhibits));
    page("audit.html", "Audit", audit_page(input));
    page("sections.html", "Sections of the manuals", sections_page(input));
    page("decisions.html", "Decisions", decisions_page(input));
    page("tests.html", "Tests", tests_page(input));
    page("plots.html", "Plots", plots_page(input));
    if (input.coverage.has_value()) {
        page("coverage.html", "Structural coverage", coverage_page(*input.coverage));
        files["data/cobertura.xml"] = write_cobertura(input.coverage->files);
    }
    if (input.target.has_value()) {
        page("target.html", "On the microcontroller", *input.target);
    }
    files["data/register.reqif"] = write_reqif(*input.content, input.audits);
    files["data/junit.xml"] = write_junit(input.evidence);
    files["data/sbom.cdx.json"] = write_sbom(input.provenance);
    files["data/requirements.csv"] = write_requirements_csv(input.audits, input.evidence);
    files["data/decisions.csv"] = write_decisions_csv(input.audits);
    for (const auto& [name, text] : input.figures) {
        files["plots/" + name] = text;
    }
    for (const auto& one : input.exhibits) {
        files.insert(one.files.begin(), one.files.end());
    }
    return files;
}

std::string write_manifest(const PackFiles& files, const Provenance& provenance) {
    nlohmann::ordered_json manifest{{"commit", provenance.commit},
                                    {"date", provenance.date},
                                    {"configuration", provenance.configuration},
                                    {"tools", provenance.tools}};
    auto& sums = manifest["sha256"] = nlohmann::ordered_json::object();
    for (const auto& [name, bytes] : files) {
        sums[name] = sha256(bytes);
    }
    return manifest.dump(2) + "\n";
}

}  // namespace canproof::host
