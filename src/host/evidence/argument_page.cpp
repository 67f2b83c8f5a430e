#include <fmt/format.h>

#include <algorithm>

#include "host/evidence/page.hpp"
#include "host/evidence/pages.hpp"
#include "host/plot/markup.hpp"

namespace canproof::host {

namespace {

Exhibit::State state_of(const std::string& key, const Exhibits& exhibits) {
    const auto found = exhibits.find(key);
    return found == exhibits.end() ? Exhibit::State::absent : found->second.state;
}

/// A claim holds when its evidence and all claims below it hold.
bool holds(const Claim& claim, const Argument& argument, const Exhibits& exhibits) {
    const auto below = [&](const Claim& other) { return other.parent != claim.id || holds(other, argument, exhibits); };
    const auto shown = [&](const std::string& key) { return state_of(key, exhibits) == Exhibit::State::holds; };
    return std::all_of(claim.evidence.begin(), claim.evidence.end(), shown) &&
           std::all_of(argument.claims.begin(), argument.claims.end(), below);
}

std::string evidence_line(const std::string& key, const Exhibits& exhibits) {
    const auto found = exhibits.find(key);
    if (found == exhibits.end()) {
        return fmt::format("<li>{} <code>{}</code>\n", html_state("not measured"), escaped(key));
    }
    const Exhibit& one = found->second;
    const std::string title = one.page.empty()
                                  ? escaped(one.title)
                                  : fmt::format("<a href=\"{}\">{}</a>", escaped(one.page), escaped(one.title));
    return fmt::format("<li>{} {}: {}\n", html_state(word_of(one.state)), title, escaped(one.says));
}

std::string claim_markup(const Claim& claim, const Argument& argument, const Exhibits& exhibits) {
    std::string text =
        fmt::format("<div class=claim id=\"{0}\"><p><b>{0}</b> {1}</p><p>{2}</p>\n", escaped(claim.id),
                    html_state(holds(claim, argument, exhibits) ? "holds" : "open"), escaped(claim.text));
    if (!claim.evidence.empty()) {
        text += "<ul>";
        for (const auto& key : claim.evidence) {
            text += evidence_line(key, exhibits);
        }
        text += "</ul>\n";
    }
    if (!claim.limits.empty()) {
        text += fmt::format("<p class=quiet>Not shown by this: {}</p>\n", escaped(claim.limits));
    }
    for (const auto& other : argument.claims) {
        if (other.parent == claim.id) {
            text += claim_markup(other, argument, exhibits);
        }
    }
    return text + "</div>\n";
}

std::string claims_markup(const Argument& argument, const Exhibits& exhibits) {
    std::string text;
    for (const auto& claim : argument.claims) {
        if (claim.parent.empty()) {
            text += claim_markup(claim, argument, exhibits);
        }
    }
    return text;
}

}  // namespace

std::string argument_page(const PackInput& input, const Exhibits& exhibits) {
    std::vector<std::vector<std::string>> techniques;
    for (const auto& one : input.argument.techniques) {
        techniques.push_back(
            {escaped(one.table), escaped(one.name), escaped(one.level), html_state(one.state), escaped(one.how)});
    }
    std::vector<std::vector<std::string>> tools;
    for (const auto& one : input.argument.tools) {
        const auto version = input.provenance.packages.find(one.package);
        tools.push_back({escaped(one.name), version == input.provenance.packages.end() ? "" : escaped(version->second),
                         escaped(one.hides), escaped(one.noticed)});
    }
    return "<h2>Claims</h2>\n" + claims_markup(input.argument, exhibits) +
           "<h2>Techniques that the standards recommend</h2><p>IEC 61508-3 for SIL 3 and ISO 26262-6 for ASIL D, in "
           "our "
           "words. This is no assessment.</p>\n" +
           html_table({{"Table", 14}, {"Technique", 30}, {"Level", 6}, {"State", 10}, {"Here"}}, techniques,
                      Search::yes) +
           "<h2>Confidence in tools</h2>\n" +
           html_table({{"Tool", 14}, {"Version", 14}, {"Could hide", 28}, {"Noticed by"}}, tools);
}

std::string overview_page(const PackInput& input, const Exhibits& exhibits) {
    std::vector<std::vector<std::string>> shown;
    std::vector<std::string> open;
    for (const auto& [key, one] : exhibits) {
        const std::string title = one.page.empty()
                                      ? escaped(one.title)
                                      : fmt::format("<a href=\"{}\">{}</a>", escaped(one.page), escaped(one.title));
        shown.push_back({title, html_state(word_of(one.state)), escaped(one.says)});
    }
    std::string text =
        "<p>Four CANopen devices, written down as requirements first and as C++ second. This page answers what is "
        "claimed, what shows it, and what is open.</p>\n<h2>What is claimed</h2>\n" +
        claims_markup(input.argument, exhibits) + "<h2>What shows it</h2>\n" +
        html_table({{"Evidence", 22}, {"State", 14}, {"Says"}}, shown);
    text += "<h2>What is open</h2>\n<ul>";
    for (const auto& audit : input.audits) {
        for (const auto& gap : audit.gaps) {
            text += fmt::format("<li>{}\n", escaped(gap));
        }
    }
    for (const auto& technique : input.argument.techniques) {
        if (technique.state != "shown") {
            text += fmt::format("<li>{} {}, {}: {}\n", html_state(technique.state), escaped(technique.table),
                                escaped(technique.name), escaped(technique.how));
        }
    }
    text += "</ul>\n<h2>This build</h2>\n";
    std::vector<std::vector<std::string>> build{
        {"Commit", fmt::format("<code>{}</code>", escaped(input.provenance.commit))},
        {"Date", escaped(input.provenance.date)},
        {"Configuration", escaped(input.provenance.configuration)}};
    for (const auto& [name, version] : input.provenance.tools) {
        build.push_back({escaped(name), escaped(version)});
    }
    return text + html_table({{"What", 22}, {"Which"}}, build) +
           "<p>The same as data: <a href=\"data/register.reqif\">ReqIF</a>, <a href=\"data/junit.xml\">JUnit</a>, <a "
           "href=\"data/cobertura.xml\">Cobertura</a>, <a href=\"data/requirements.csv\">requirements as CSV</a>, <a "
           "href=\"data/decisions.csv\">decisions as CSV</a>, <a href=\"data/sbom.cdx.json\">CycloneDX</a>, <a "
           "href=\"manifest.json\">manifest with checksums</a>.</p>\n";
}

}  // namespace canproof::host
