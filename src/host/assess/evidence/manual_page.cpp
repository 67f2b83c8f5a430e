// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/manual_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "host/assess/evidence/item_links.hpp"
#include "host/assess/evidence/review_notes.hpp"
#include "host/assess/trace/section_index.hpp"
#include "host/assess/trace/statement_audit.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

/// How the page shows a state of a section: as a word, with a class of the style sheet and a symbol for readers who
/// cannot see colours. The legend explains the meaning.
struct StateLook {
    const char* word;
    const char* style;
    const char* symbol;
    const char* meaning;
};
constexpr std::array<StateLook, 6> looks{
    {{"shown", "proven", "✓", "every statement is covered, and every item that covers one is shown"},
     {"not shown", "unproven", "◐", "every statement is covered, but an item that covers one is not shown"},
     {"uncovered", "uncovered", "✗", "a statement has neither an item nor a reason, or the section has no statement"},
     {"explained", "aside", "–", "every statement has a reason why no item covers it"},
     {"informative", "aside", "·", "the section has no requirement"},
     {"condition of use", "aside", "§", "the section has conditions for installers or operators"}}};

const StateLook& look_of(const std::string& word) {
    return *std::find_if(looks.begin(), looks.end() - 1, [&](const StateLook& one) { return one.word == word; });
}

/// Converts a place in the manual into the name of an anchor in the page.
std::string anchor(std::string place) {
    std::replace(place.begin(), place.end(), ' ', '-');
    return escaped(place);
}

class ManualPage {
  public:
    ManualPage(const PackInput& input, const PartAudit& audit, const Manual& manual)
        : audit_{audit},
          manual_{manual},
          sections_{by_section(manual, audit.statements)},
          index_{*input.content},
          notes_{input},
          links_{links_of(input)} {
        for (const auto& one : input.audits) {
            for (const auto& item : one.items) {
                states_[item.item->id] = item.status();
            }
        }
    }

    std::string markup() const {
        std::string tiles;
        std::vector<std::vector<std::string>> rows;
        std::map<std::string, std::size_t> count;
        for (const Section& section : manual_.sections) {
            const StateLook& look = look_of(state_of(section));
            ++count[look.word];
            tiles +=
                fmt::format("<a class=\"tile {}\" href=\"#{}\" title=\"{}: {}\">{} {}</a>\n", look.style,
                            anchor(section.ref), escaped(section.title), look.word, look.symbol, escaped(section.ref));
            rows.push_back(row_of(section, look));
        }
        return head() + legend(count) + "<div class=tiles>\n" + tiles + "</div>\n" +
               html_table("Sections of the manual",
                          {{"Section", 9}, {"Title", 21}, {"State", 12}, {"Demand, and the items that cover it"}}, rows,
                          Search::yes);
    }

  private:
    std::vector<const AuditedStatement*> statements_of(const Section& section) const {
        std::vector<const AuditedStatement*> all;
        if (const auto found = sections_.find(section.ref); found != sections_.end()) {
            std::transform(found->second.begin(), found->second.end(), std::back_inserter(all),
                           [&](const std::size_t at) { return &audit_.statements[at]; });
        }
        return all;
    }

    std::string state_of(const Section& section) const {
        std::vector<std::string> item_states;
        for (const auto& id : index_.items_of(manual_.key, section)) {
            const auto found = states_.find(id);
            item_states.push_back(found == states_.end() ? "shown" : found->second);
        }
        return section_state(section, statements_of(section), item_states, manual_.statements.empty());
    }

    std::string head() const {
        std::string text = fmt::format(
            "<p>{}, {}, {}, {}. The table lists each section of the manual with its demands in our words, and the "
            "items of the register that cover these demands. It does not contain the text of the manual.</p>\n",
            escaped(manual_.title), escaped(manual_.publisher), escaped(manual_.revision), escaped(manual_.date));
        if (manual_.statements.empty()) {
            return text +
                   "<p>The register has no statements of this manual: an item that has a section as its source covers "
                   "the whole section.</p>\n";
        }
        auto count = count_statements(audit_);
        return text +
               fmt::format(
                   "<p><b>{}</b> statements: {} shown, {} explained by a reason, {} suspect, {} open, {} failed.</p>\n",
                   audit_.statements.size(), count["shown"], count["explained"], count["suspect"], count["open"],
                   count["failed"]);
    }

    static std::string legend(std::map<std::string, std::size_t>& count) {
        std::vector<std::vector<std::string>> rows;
        for (const StateLook& look : looks) {
            rows.push_back({fmt::format("<span class=\"tile {}\">{} {}</span>", look.style, look.symbol, look.word),
                            std::to_string(count[look.word]), look.meaning});
        }
        return html_table("States of sections", {{"State", 18}, {"Sections", 10}, {"Meaning"}}, rows);
    }

    std::vector<std::string> row_of(const Section& section, const StateLook& look) const {
        std::string text;
        for (const auto* statement : statements_of(section)) {
            text += statement_markup(*statement);
        }
        if (!text.empty()) {
            text = "<ul>" + text + "</ul>";
        } else if (manual_.statements.empty() && section.normative) {
            for (const auto& id : index_.items_of(manual_.key, section)) {
                text += (text.empty() ? "" : ", ") + link_to(links_, id);
            }
        }
        for (const auto& condition : section.conditions) {
            text += fmt::format("<p>{}</p>", prose(condition));
        }
        if (!section.normative && !section.reason.empty()) {
            text += fmt::format("<small>{}</small>", prose(section.reason));
        }
        text += notes_.of(*audit_.part, section.id(manual_.key));
        return {fmt::format("<span id=\"{}\">{}</span>", anchor(section.ref), escaped(section.ref)),
                escaped(section.title),
                fmt::format("<span class=\"tile {}\">{} {}</span>", look.style, look.symbol, look.word), text};
    }

    std::string statement_markup(const AuditedStatement& audited) const {
        const Statement& one = *audited.statement;
        const std::string place = audited.id.substr(manual_.key.size() + 1);
        const std::string links = link_to_each(links_, one.covered);
        const std::string state =
            audited.status == "explained" ? "<span class=quiet>– explained</span>" : html_state(audited.status);
        return fmt::format("<li id=\"{}\"><small>{}</small> {} {} <small>{}{}</small>\n", anchor(place), escaped(place),
                           state, prose(one.text), links, prose(one.reason));
    }

    const PartAudit& audit_;
    const Manual& manual_;
    std::map<std::string, std::vector<std::size_t>> sections_;
    SectionIndex index_;
    ReviewNotes notes_;
    std::map<std::string, std::string> states_;
    ItemLinks links_;
};

bool all_shown(const std::vector<std::string>& states) {
    return std::all_of(states.begin(), states.end(), [](const std::string& state) { return state == "shown"; });
}

}  // namespace

std::string section_state(const Section& section, const std::vector<const AuditedStatement*>& statements,
                          const std::vector<std::string>& item_states, const bool counts_by_section) {
    const bool all_explained =
        std::all_of(statements.begin(), statements.end(), [](const auto* one) { return one->status == "explained"; });
    if (!section.normative && all_explained) {
        return section.is_condition_of_use() ? "condition of use" : "informative";
    }
    if (counts_by_section) {
        return item_states.empty() ? "uncovered" : all_shown(item_states) ? "shown" : "not shown";
    }
    const bool any_bare =
        std::any_of(statements.begin(), statements.end(), [](const auto* one) { return one->statement->is_open(); });
    if (statements.empty() || any_bare) {
        return "uncovered";
    }
    const bool any_open =
        std::any_of(statements.begin(), statements.end(), [](const auto* one) { return one->open(); });
    return all_explained ? "explained" : any_open ? "not shown" : "shown";
}

std::string manual_page_name(const Part& part) {
    return "manual-" + part.name + ".html";
}

std::string manual_page(const PackInput& input, const PartAudit& audit, const Manual& manual) {
    return ManualPage{input, audit, manual}.markup();
}

}  // namespace canproof::host
