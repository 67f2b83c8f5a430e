// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/audit_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>

#include "host/assess/documents/item_words.hpp"
#include "host/assess/evidence/item_links.hpp"
#include "host/assess/evidence/review_notes.hpp"
#include "host/assess/evidence/source_pages.hpp"
#include "host/assess/trace/review.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

constexpr std::array<const char*, 4> states{"shown", "suspect", "open", "failed"};

using ItemsByService = std::map<std::string, std::vector<const AuditedItem*>>;

ItemsByService by_service(const PartAudit& audit) {
    ItemsByService services;
    for (const auto& one : audit.items) {
        services[service_of(*one.item)].push_back(&one);
    }
    return services;
}

std::map<std::string, std::size_t> count_states(const std::vector<const AuditedItem*>& items) {
    std::map<std::string, std::size_t> counts;
    for (const auto* one : items) {
        ++counts[one->status()];
    }
    return counts;
}

/// Returns `text` as a link to a line of a source; returns `text` unchanged when the pack does not contain the source.
std::string linked(const PackInput& input, const std::string& file, const unsigned line, const std::string& text) {
    const std::string place = source_link(input, file, line);
    return place.empty() ? text : fmt::format("<a href=\"{}\">{}</a>", escaped(place), text);
}

/// Returns a place in the code without its common folder: `relay.cpp:12` for a place in the folder of the device's
/// firmware, `firmware/canopen/sdo.cpp:12` for another place below `src/`.
std::string short_place(const Part& part, const std::string& place) {
    for (const auto& common : {"src/devices/" + part.name + "/firmware/", std::string{"src/"}}) {
        if (place.rfind(common, 0) == 0) {
            return place.substr(common.size());
        }
    }
    return place;
}

/// Returns the places in the code that implement an item, or a link to the shared requirement that implements it.
std::string places_of(const PackInput& input, const Part& part, const std::string& id, const ItemLinks& links) {
    if (const std::string& shared = implementing_id(id, input.evidence); shared != id) {
        return fmt::format("<p>implemented by {}</p>", link_to_each(links, {shared}));
    }
    std::vector<std::string> all;
    for (const auto& place : code_of(id, input.evidence)) {
        const auto colon = place.find(':');
        const unsigned line =
            colon == std::string::npos ? 0U : static_cast<unsigned>(std::stoul(place.substr(colon + 1)));
        const std::string words = fmt::format("<code>{}</code>", breakable(short_place(part, place)));
        all.push_back(linked(input, place.substr(0, colon), line, words));
    }
    return all.empty() ? "" : fmt::format("<p>{}</p>", fmt::join(all, ", "));
}

/// Returns the tests of an item, with one line for the tests of the same suite, kind and result.
std::string tests_of(const PackInput& input, const std::string& id) {
    const auto found = input.evidence.verdicts.find(id);
    if (found == input.evidence.verdicts.end()) {
        return "";
    }
    // the links to the tests, by the beginning of the line that shows them: result, suite and kind
    std::map<std::string, std::vector<std::string>> lines;
    for (const auto& verdict : found->second) {
        const auto dot = verdict.test.find('.');
        const std::string suite = verdict.test.substr(0, dot);
        const std::string name = dot == std::string::npos ? suite : verdict.test.substr(dot + 1);
        const std::string head =
            fmt::format("<span class={}>{}</span> {} <small>{}</small>", verdict.passed ? "holds" : "open",
                        verdict.passed ? "✓" : "✗", breakable(suite), verdict.kind);
        lines[head].push_back(linked(input, verdict.file, verdict.line, breakable(name)));
    }
    std::string text;
    for (const auto& [head, names] : lines) {
        text += fmt::format("<p>{} {}</p>", head, fmt::join(names, ", "));
    }
    return text;
}

/// Returns a sentence such as `5 of 6 altered cells noticed`: how many alterations of the item's table cells a test
/// noticed. Returns an empty text when the pack does not contain these numbers.
std::string mutants_of(const std::string& id, const PackInput& input) {
    if (!input.mutation.has_value() || input.mutation->items.count(id) == 0) {
        return "";
    }
    const MutationCount& count = input.mutation->items.at(id);
    return fmt::format("<small>{} of {} altered cells noticed</small>", count.noticed, count.altered);
}

/// Returns the text of an item, then the facts of an object, the value of a constant or the rows of a table.
std::string text_of(const Part& part, const Item& item) {
    const std::string facts = item_words(part, item.id);
    return (item.text.empty() ? "" : fmt::format("<p>{}</p>", prose(item.text))) +
           (facts.empty() ? "" : fmt::format("<p><small>{}</small></p>", escaped(facts)));
}

/// Returns who reviewed the item, or why its review no longer counts. The page shows this text on screens only, to keep
/// the print short.
std::string review_of(const Part& part, const AuditedItem& audited, const ReviewNotes& notes) {
    const auto found = part.reviews.find(audited.item->id);
    return !audited.suspect.empty()      ? audited.suspect
           : found == part.reviews.end() ? ""
                                         : "reviewed " + review_words(found->second) + notes.beside(part, found->first);
}

/// The data from which the rows of a page are made.
struct RowSources {
    const PackInput& input;
    ItemLinks links;
    ReviewNotes notes;
};

std::vector<std::string> item_row(const Part& part, const AuditedItem& audited, const RowSources& from) {
    const PackInput& input = from.input;
    const Item& item = *audited.item;
    const std::string decisions = link_to_each(from.links, audited.decisions);
    return {fmt::format("<code id=\"{0}\">{0}</code><br><small class=kind>{1}</small><br>{2}", item.id, audited.word,
                        html_state(audited.status())),
            fmt::format("{}<p><small>{}{}{}</small></p>", text_of(part, item),
                        escaped(fmt::format("{}", fmt::join(origins(item), ", "))), decisions.empty() ? "" : " · ",
                        decisions),
            places_of(input, part, item.id, from.links) + tests_of(input, item.id) +
                fmt::format("<p class=screen><small>{}</small></p>", escaped(review_of(part, audited, from.notes))) +
                mutants_of(item.id, input)};
}

/// Returns table cells with the number of all items, and how many of them are shown (their tests passed), suspect
/// (changed since their review), open or failed.
std::vector<std::string> count_cells(const std::vector<const AuditedItem*>& items) {
    auto counts = count_states(items);
    std::vector<std::string> cells{std::to_string(items.size())};
    for (const char* state : states) {
        cells.push_back(std::to_string(counts[state]));
    }
    return cells;
}

std::string sentence_list(const char* id, const char* title, const std::vector<std::string>& sentences) {
    if (sentences.empty()) {
        return "";
    }
    std::string text = fmt::format("<h2 class=open id={}>{}</h2><ul>", id, title);
    for (const auto& sentence : sentences) {
        text += fmt::format("<li>{}\n", prose(sentence));
    }
    return text + "</ul>\n";
}

/// Returns the markup of one service (a file of the register): a line with counts, which opens to the table of its
/// items.
std::string service_markup(const PartAudit& audit, const std::string& service,
                           const std::vector<const AuditedItem*>& items, const RowSources& from) {
    std::string counts;
    for (const auto& [state, count] : count_states(items)) {
        counts += fmt::format(" <small class=state>{} {}</small>", count, html_state(state));
    }
    std::vector<std::vector<std::string>> rows;
    for (const auto* one : items) {
        rows.push_back(item_row(*audit.part, *one, from));
    }
    return fmt::format("<details><summary><h2 id=\"service-{}\">{}</h2>{}</summary>\n{}</details>\n", escaped(service),
                       escaped(service_title(service)), counts,
                       html_table("Items: " + service_title(service),
                                  {{"Item", 12}, {"Text", 53}, {"Code, tests, review", 35}}, rows));
}

}  // namespace

std::string service_of(const Item& item) {
    const std::string name = std::filesystem::path{item.place.file}.stem().string();
    return name.empty() ? "other" : name;
}

std::string title_of(const Part& part) {
    return !part.is_device()         ? "CANopen rules that all devices share"
           : part.info.title.empty() ? part.name
                                     : part.info.title;
}

std::string service_title(const std::string& service) {
    static const std::set<std::string> abbreviations{"can", "emcy", "lss", "nmt", "pdo", "sdo", "sync"};
    std::string title;
    for (std::size_t at = 0; at <= service.size();) {
        const auto end = std::min(service.find('_', at), service.size());
        std::string word = service.substr(at, end - at);
        const std::size_t capitals = abbreviations.count(word) != 0 ? word.size() : at == 0 ? 1U : 0U;
        std::transform(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(std::min(capitals, word.size())),
                       word.begin(), [](const unsigned char c) { return static_cast<char>(std::toupper(c)); });
        title += (at == 0 ? "" : " ") + word;
        at = end + 1;
    }
    return title;
}

std::string audit_page(const PackInput& input) {
    std::vector<std::vector<std::string>> parts;
    std::vector<std::vector<std::string>> services;
    std::vector<std::string> gaps;
    std::vector<std::string> suspects;
    const auto add = [](std::vector<std::vector<std::string>>& rows, std::vector<std::string> head,
                        const std::vector<const AuditedItem*>& items) {
        const auto cells = count_cells(items);
        head.insert(head.end(), cells.begin(), cells.end());
        rows.push_back(std::move(head));
    };
    for (const auto& audit : input.audits) {
        const std::string page = escaped(audit_page_name(*audit.part));
        const std::string title = escaped(title_of(*audit.part));
        std::vector<const AuditedItem*> all;
        for (const auto& one : audit.items) {
            all.push_back(&one);
        }
        add(parts, {fmt::format("<a href=\"{}\">{}</a>", page, title)}, all);
        for (const auto& [service, items] : by_service(audit)) {
            add(services,
                {escaped(audit.part->name), fmt::format("<a href=\"{}#service-{}\">{}</a>", page, escaped(service),
                                                        escaped(service_title(service)))},
                items);
        }
        gaps.insert(gaps.end(), audit.gaps.begin(), audit.gaps.end());
        suspects.insert(suspects.end(), audit.suspects.begin(), audit.suspects.end());
    }
    return "<p>The page of a part shows each of its items: the text of the item, its place in the manual, the "
           "decisions that affect the item, the code that names it, and the tests that claim it with their results in "
           "this build. Code and tests are links to their sources.</p>\n" +
           html_table("Items by device", {{"Part", 40}, {"Items"}, {"Shown"}, {"Suspect"}, {"Open"}, {"Failed"}},
                      parts) +
           sentence_list("gaps", "Gaps", gaps) + sentence_list("suspects", "Suspects", suspects) +
           "<h2>Services</h2>\n" +
           html_table("Items by device and service",
                      {{"Part", 18}, {"Service", 22}, {"Items"}, {"Shown"}, {"Suspect"}, {"Open"}, {"Failed"}},
                      services, Search::yes);
}

std::string part_audit_page(const PackInput& input, const PartAudit& audit) {
    const RowSources from{input, links_of(input), ReviewNotes{input}};
    std::set<std::string> kinds;
    for (const auto& one : audit.items) {
        kinds.insert(one.word);
    }
    std::string text = fmt::format(
        "<p>The page has {} items by service. A service opens with a click; a search opens the services that have a "
        "hit.</p>\n<div class=\"filtered wide\">\n{}",
        audit.items.size(),
        html_filter(
            {{"Kind", ".kind", {kinds.begin(), kinds.end()}}, {"State", "td .state", {states.begin(), states.end()}}}));
    for (const auto& [service, items] : by_service(audit)) {
        text += service_markup(audit, service, items, from);
    }
    return text + "</div>\n";
}

}  // namespace canproof::host
