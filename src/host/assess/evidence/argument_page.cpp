#include "host/assess/evidence/argument_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/evidence/overview_page.hpp"
#include "host/assess/evidence/own_exhibits.hpp"
#include "host/assess/evidence/pack_input.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

Exhibit::State state_of(const std::string& key, const Exhibits& exhibits) {
    const auto found = exhibits.find(key);
    return found == exhibits.end() ? Exhibit::State::absent : found->second.state;
}

std::string evidence_line(const std::string& key, const Exhibits& exhibits) {
    const auto found = exhibits.find(key);
    if (found == exhibits.end()) {
        return fmt::format("<li>{} <code>{}</code>\n", html_state("not measured"), escaped(key));
    }
    const Exhibit& one = found->second;
    return fmt::format("<li>{} {}{}{}\n", html_state(word_of(one.state)), title_markup(one),
                       one.says.empty() ? "" : ": ", escaped(one.says));
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
        text += fmt::format("<p class=quiet>Limits: {}</p>\n", escaped(claim.limits));
    }
    for (const auto& other : argument.claims) {
        if (other.parent == claim.id) {
            text += claim_markup(other, argument, exhibits);
        }
    }
    return text + "</div>\n";
}

}  // namespace

bool holds(const Claim& claim, const Argument& argument, const Exhibits& exhibits) {
    const auto below = [&](const Claim& other) { return other.parent != claim.id || holds(other, argument, exhibits); };
    const auto shown = [&](const std::string& key) { return state_of(key, exhibits) == Exhibit::State::holds; };
    return std::all_of(claim.evidence.begin(), claim.evidence.end(), shown) &&
           std::all_of(argument.claims.begin(), argument.claims.end(), below);
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

}  // namespace canproof::host
