// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/argument_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/argument_export.hpp"
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
                       one.says.empty() ? "" : ": ", prose(one.says));
}

std::string claim_markup(const Claim& claim, const Argument& argument, const Exhibits& exhibits) {
    std::string text = fmt::format("<div class=claim id=\"{0}\"><p><b>{0}</b> {1}</p><p>{2}</p>\n", escaped(claim.id),
                                   html_state(word_of(state_of_claim(claim, argument, exhibits))), prose(claim.text));
    if (!claim.evidence.empty()) {
        text += "<ul>";
        for (const auto& key : claim.evidence) {
            text += evidence_line(key, exhibits);
        }
        text += "</ul>\n";
    }
    if (!claim.limits.empty()) {
        text += fmt::format("<p class=quiet>Limits: {}</p>\n", prose(claim.limits));
    }
    for (const auto& other : argument.claims) {
        if (other.parent == claim.id) {
            text += claim_markup(other, argument, exhibits);
        }
    }
    return text + "</div>\n";
}

}  // namespace

Exhibit::State state_of_claim(const Claim& claim, const Argument& argument, const Exhibits& exhibits) {
    auto worst = Exhibit::State::holds;
    const auto take = [&worst](const Exhibit::State one) {
        if (one == Exhibit::State::open || one == Exhibit::State::stale) {
            worst = Exhibit::State::open;
        } else if (one == Exhibit::State::absent && worst == Exhibit::State::holds) {
            worst = Exhibit::State::absent;
        }
    };
    for (const auto& key : claim.evidence) {
        take(state_of(key, exhibits));
    }
    for (const auto& other : argument.claims) {
        if (other.parent == claim.id) {
            take(state_of_claim(other, argument, exhibits));
        }
    }
    return worst;
}

ClaimCounts count_claims(const Argument& argument, const Exhibits& exhibits) {
    ClaimCounts counts;
    for (const auto& claim : argument.claims) {
        const auto state = state_of_claim(claim, argument, exhibits);
        ++counts.all;
        counts.hold += state == Exhibit::State::holds ? 1U : 0U;
        counts.not_measured += state == Exhibit::State::absent ? 1U : 0U;
    }
    return counts;
}

std::string claims_sentence(const ClaimCounts& counts) {
    const std::string wait =
        counts.not_measured == 0
            ? ""
            : fmt::format("; {} wait for evidence that was not measured: `canproof evidence --full` measures it",
                          counts.not_measured);
    return fmt::format("{} of {} claims hold{}", counts.hold, counts.all, wait);
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

namespace {

/// Returns the version of a tool: that of its Debian package, or the commit if the tool is part of this project.
std::string version_of(const Tool& tool, const Provenance& provenance) {
    if (tool.package.empty()) {
        return "commit " + provenance.commit.substr(0, 12);
    }
    const auto found = provenance.packages.find(tool.package);
    return found == provenance.packages.end() ? "not installed" : found->second;
}

}  // namespace

std::string argument_page(const PackInput& input, const Exhibits& exhibits) {
    std::vector<std::vector<std::string>> tools;
    for (const auto& one : input.argument.tools) {
        tools.push_back({escaped(one.name), escaped(one.tool_class), escaped(version_of(one, input.provenance)),
                         prose(one.hides), prose(one.noticed), prose(one.defects)});
    }
    return "<h2>Claims</h2>\n" + argument_graph(input.argument, exhibits) + claims_markup(input.argument, exhibits) +
           "<h2>Confidence in tools</h2>\n<p>The class is that of IEC 61508-4: a T2 tool checks the code and could "
           "miss a fault; a T3 tool makes the code that runs and could add a fault. No tool is qualified.</p>\n" +
           html_table(
               "Tools and their classes",
               {{"Tool", 12}, {"Class", 6}, {"Version", 12}, {"Could hide", 22}, {"Noticed by", 26}, {"Known defects"}},
               tools);
}

}  // namespace canproof::host
