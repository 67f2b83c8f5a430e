// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/overview_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/argument_page.hpp"
#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/evidence/own_exhibits.hpp"
#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/evidence/provenance.hpp"
#include "host/assess/evidence/technique_states.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t listed = 40;  ///< most open points that a group lists; further points are only counted

std::string verdict_line(const Argument& argument, const Exhibits& exhibits) {
    return fmt::format("<p><b>{}</b></p>\n", prose(claims_sentence(count_claims(argument, exhibits))));
}

std::string claims_on(const std::string& key, const Argument& argument) {
    std::string text;
    for (const auto& claim : argument.claims) {
        if (std::find(claim.evidence.begin(), claim.evidence.end(), key) != claim.evidence.end()) {
            text += fmt::format("{1}<a href=\"#{0}\">{0}</a>", escaped(claim.id), text.empty() ? "" : ", ");
        }
    }
    return text;
}

std::string said_by(const Exhibit& exhibit) {
    std::string text = prose(exhibit.says);
    for (const auto& [name, value] : exhibit.figures) {
        text += fmt::format("<br><small>{}: <b>{}</b></small>", escaped(name), escaped(value));
    }
    for (const auto& file : exhibit.data) {
        text += fmt::format("<br><a href=\"{}\"><small>{}</small></a>", escaped(file),
                            escaped(std::filesystem::path{file}.filename().string()));
    }
    if (exhibit.state == Exhibit::State::absent || exhibit.state == Exhibit::State::stale) {
        text += (text.empty() ? "" : "<br>") + prose(exhibit.open.back());
    }
    return text;
}

std::string group(const std::string& title, const std::vector<std::string>& entries) {
    if (entries.empty()) {
        return "";
    }
    std::string text = fmt::format("<h3>{} ({})</h3>\n<ul>", escaped(title), entries.size());
    for (std::size_t i = 0; i < std::min(entries.size(), listed); ++i) {
        text += "<li>" + entries[i] + "\n";
    }
    text += entries.size() > listed ? fmt::format("<li>… and {} more\n", entries.size() - listed) : "";
    return text + "</ul>\n";
}

std::vector<std::string> prose_all(std::vector<std::string> sentences) {
    std::transform(sentences.begin(), sentences.end(), sentences.begin(),
                   [](const std::string& sentence) { return prose(sentence); });
    return sentences;
}

std::string open_markup(const PackInput& input, const Exhibits& exhibits) {
    std::vector<std::string> evidence;
    for (const auto& [key, one] : exhibits) {
        for (const auto& sentence : one.open) {
            evidence.push_back(title_markup(one) + ": " + prose(sentence));
        }
    }
    std::vector<std::string> gaps;
    std::vector<std::string> suspects;
    for (const auto& audit : input.audits) {
        gaps.insert(gaps.end(), audit.gaps.begin(), audit.gaps.end());
        suspects.insert(suspects.end(), audit.suspects.begin(), audit.suspects.end());
    }
    std::vector<std::string> techniques;
    for (const auto& technique : techniques_of(input.argument, exhibits)) {
        if (technique.state != "shown" && technique.state != "not applicable") {
            techniques.push_back(fmt::format("{} {}, {}: {}", html_state(technique.state), escaped(technique.table),
                                             escaped(technique.name), prose(technique.how)));
        }
    }
    const std::string text =
        group("Evidence that is missing, stale or open", evidence) +
        group("Gaps that the audit found", prose_all(gaps)) +
        group("Changed since they were reviewed", prose_all(suspects)) +
        group("Code or tests without a requirement", prose_all(input.orphans.value_or(std::vector<std::string>{}))) +
        group("Recommended techniques that are not or only partly used, or not shown in this pack", techniques);
    return text.empty() ? "<p>There is no open point.</p>\n" : text;
}

std::string build_table(const Provenance& provenance) {
    std::vector<std::vector<std::string>> build{{"Commit", fmt::format("<code>{}</code>", escaped(provenance.commit))},
                                                {"Date", escaped(provenance.date)},
                                                {"Configuration", escaped(provenance.configuration)}};
    for (const auto& [name, version] : provenance.tools) {
        build.push_back({escaped(name), escaped(version)});
    }
    return html_table("Origin of this build", {{"What", 22}, {"Which"}}, build);
}

}  // namespace

std::string title_markup(const Exhibit& exhibit) {
    return exhibit.page.empty() ? escaped(exhibit.title)
                                : fmt::format("<a href=\"{}\">{}</a>", escaped(exhibit.page), escaped(exhibit.title));
}

std::string overview_page(const PackInput& input, const Exhibits& exhibits) {
    std::vector<std::vector<std::string>> shown;
    for (const auto& [key, one] : exhibits) {
        shown.push_back(
            {title_markup(one), html_state(word_of(one.state)), claims_on(key, input.argument), said_by(one)});
    }
    return "<p>Four CANopen devices are specified by requirements and implemented in C++. This page shows the claims, "
           "the evidence and the open points.</p>\n" +
           verdict_line(input.argument, exhibits) + "<h2>Claims</h2>\n" + claims_markup(input.argument, exhibits) +
           "<h2>Evidence</h2>\n" +
           html_table("Evidence and the claims that need it",
                      {{"Evidence", 22}, {"State", 13}, {"Claim", 8}, {"Result"}}, shown) +
           "<h2>Open points</h2>\n" + open_markup(input, exhibits) + "<h2>This build</h2>\n" +
           build_table(input.provenance);
}

}  // namespace canproof::host
