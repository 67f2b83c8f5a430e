// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/pack.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/assess/coverage/cobertura.hpp"
#include "host/assess/coverage/coverage_json.hpp"
#include "host/assess/evidence/argument_export.hpp"
#include "host/assess/evidence/argument_page.hpp"
#include "host/assess/evidence/audit_pages.hpp"
#include "host/assess/evidence/coverage_page.hpp"
#include "host/assess/evidence/csv.hpp"
#include "host/assess/evidence/decisions_page.hpp"
#include "host/assess/evidence/document_pages.hpp"
#include "host/assess/evidence/exhibit_page.hpp"
#include "host/assess/evidence/hazards_page.hpp"
#include "host/assess/evidence/item_links.hpp"
#include "host/assess/evidence/junit.hpp"
#include "host/assess/evidence/manual_page.hpp"
#include "host/assess/evidence/mutation_page.hpp"
#include "host/assess/evidence/overview_page.hpp"
#include "host/assess/evidence/own_exhibits.hpp"
#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/evidence/provenance.hpp"
#include "host/assess/evidence/register_pages.hpp"
#include "host/assess/evidence/reqif.hpp"
#include "host/assess/evidence/reviews_page.hpp"
#include "host/assess/evidence/sacm.hpp"
#include "host/assess/evidence/sbom.hpp"
#include "host/assess/evidence/source_pages.hpp"
#include "host/assess/evidence/standards_page.hpp"
#include "host/base/sha256.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

std::vector<NavigationEntry> navigation_of(const PackInput& input, const Exhibits& exhibits) {
    std::vector<NavigationEntry> entries{{"index.html", "canproof"},      {"argument.html", "Argument"},
                                         {"audit.html", "Audit"},         {"sections.html", "Sections"},
                                         {"decisions.html", "Decisions"}, {"hazards.html", "Hazards"},
                                         {"reviews.html", "Reviews"},     {"documents.html", "Documents"},
                                         {"standards.html", "Standards"}, {"tests.html", "Tests"}};
    if (input.coverage.has_value()) {
        entries.push_back({"coverage.html", "Coverage"});
    }
    if (input.mutation.has_value()) {
        entries.push_back({"mutation.html", "Mutation"});
    }
    if (input.target.has_value()) {
        entries.push_back({"target.html", "Target"});
    }
    for (const auto& one : input.exhibits) {
        entries.push_back({exhibits.at(one.key).page, one.title});
    }
    entries.push_back({"plots.html", "Plots"});
    return entries;
}

/// Returns the text at the foot of each page: the commit and its date.
std::string origin_of(const Provenance& provenance) {
    return provenance.commit.empty() ? "" : fmt::format("canproof {}, {}", provenance.commit, provenance.date);
}

/// Returns the list of the files in the pack's data/, each with a description, as markup.
std::string data_markup(const PackFiles& files) {
    static const std::map<std::string, std::string> words{
        {"data/register.reqif", "the register as ReqIF"},
        {"data/junit.xml", "test cases as JUnit"},
        {"data/cobertura.xml", "coverage as Cobertura"},
        {"data/requirements.csv", "requirements as CSV"},
        {"data/decisions.csv", "decisions as CSV"},
        {"data/statements.csv", "statements of the manuals as CSV"},
        {"data/sbom.cdx.json", "packages as CycloneDX"},
        {"data/coverage.json", "coverage with MC/DC as JSON"},
        {"data/argument.json", "claims and evidence as JSON (GSN)"},
        {"data/argument.sacm.xmi", "claims and evidence as SACM"},
        {"data/mutation.json", "altered cells as JSON"},
        {"data/misra.sarif", "MISRA findings as SARIF"},
    };
    std::string text = "<h2>The content as data</h2>\n<ul>";
    for (auto file = files.lower_bound("data/"); file != files.end() && file->first.rfind("data/", 0) == 0; ++file) {
        const auto known = words.find(file->first);
        const std::string word = known == words.end() ? file->first.substr(5) : known->second;
        text += fmt::format("<li><a href=\"{}\">{}</a>\n", escaped(file->first), escaped(word));
    }
    return text + "<li><a href=\"manifest.json\">checksums of all files, compiler, commit</a></ul>\n";
}

}  // namespace

PackFiles make_pack(const PackInput& input) {
    const Exhibits exhibits = exhibits_of(input);
    const PageFrame frame{navigation_of(input, exhibits), origin_of(input.provenance)};
    PackFiles files = document_files(input, frame);
    files.merge(source_pages(input, frame));
    const auto page = [&](const std::string& name, const std::string& title, const std::string& body) {
        files[name] = html_page(title, name, frame, body);
    };
    page("argument.html", "Argument", argument_page(input, exhibits));
    page("audit.html", "Audit", audit_page(input));
    page("sections.html", "Sections of the manuals", sections_page(input));
    page("decisions.html", "Decisions", decisions_page(input));
    page("hazards.html", "Hazards", hazards_page(input));
    page("reviews.html", "Reviews", reviews_page(input));
    page("standards.html", "Techniques of the standards", standards_page(input, exhibits));
    page("tests.html", "Tests", tests_page(input));
    page("plots.html", "Plots", plots_page(input));
    for (const auto& audit : input.audits) {
        files[audit_page_name(*audit.part)] =
            html_page("Audit of " + title_of(*audit.part), "audit.html", frame, part_audit_page(input, audit));
        if (const Manual* manual = input.content->manual(audit.part->info.manual)) {
            page(manual_page_name(*audit.part), "Manual " + manual->key, manual_page(input, audit, *manual));
        }
    }
    if (input.coverage.has_value()) {
        page("coverage.html", "Structural coverage", coverage_page(*input.coverage));
        files["data/cobertura.xml"] = write_cobertura(input.coverage->files);
        files["data/coverage.json"] = coverage_json(input.coverage->files, input.coverage->verdict);
    }
    if (input.mutation.has_value()) {
        page("mutation.html", "Mutation of generated cells", mutation_page(input));
        files["data/mutation.json"] = input.mutation->json;
    }
    if (input.target.has_value()) {
        page("target.html", "On the microcontroller", *input.target);
    }
    files["data/argument.json"] = write_argument_json(input.argument, exhibits);
    files["data/argument.sacm.xmi"] = write_sacm(input.argument, exhibits, input.provenance.commit);
    files["data/register.reqif"] = write_reqif(*input.content, input.audits, input.evidence);
    files["data/junit.xml"] = write_junit(input.evidence);
    files["data/sbom.cdx.json"] = write_sbom(input.provenance, input.packages);
    files["data/requirements.csv"] = write_requirements_csv(input.audits, input.evidence);
    files["data/decisions.csv"] = write_decisions_csv(input.audits);
    files["data/statements.csv"] = write_statements_csv(input.audits);
    for (const auto& [name, figure] : input.figures) {
        files["plots/" + name] = figure.svg;
    }
    for (const auto& one : input.exhibits) {
        if (one.page.empty()) {
            page(exhibits.at(one.key).page, one.title, exhibit_page(one));
        }
        files.insert(one.files.begin(), one.files.end());
        if (!one.page.empty()) {
            files[one.page] = framed_page(one, frame);
        }
        for (const auto& name : one.data) {
            files["data/" + std::filesystem::path{name}.filename().string()] = one.files.at(name);
        }
    }
    page("index.html", "Evidence", overview_page(input, exhibits) + data_markup(files));
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
