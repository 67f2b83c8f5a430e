// SPDX-License-Identifier: Apache-2.0
#include "host/register/advice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <tuple>

#include "host/register/refs.hpp"

namespace canproof::host {

namespace {

using Sources = std::vector<std::string>;

/// Returns the sources of each item and decision by id.
std::map<std::string, Sources> sources_by_id(const Register& content) {
    std::map<std::string, Sources> all;
    for (const Part& part : content.parts) {
        content.for_each_item(part, [&](const Item& item, const char*) { all[item.id] = item.sources; });
        for (const auto& decision : part.decisions) {
            for (const auto& reading : decision.readings) {
                all[decision.id].push_back(reading.source);
            }
        }
    }
    return all;
}

/// Returns the place in the manual that a statement names, and its other names: for a section the objects that it
/// describes, for an object the sections that describe it.
std::set<std::string> names_of_place(const Manual& manual, const std::string& place) {
    std::set<std::string> names{place};
    for (const auto& section : manual.sections) {
        const auto& objects = section.objects;
        if (section.ref == place) {
            names.insert(objects.begin(), objects.end());
        } else if (std::find(objects.begin(), objects.end(), place) != objects.end()) {
            names.insert(section.ref);
        }
    }
    return names;
}

/// Returns whether one of the sources names, in the manual with this key, one of `places` or a section above or below
/// one of them.
bool cites(const Sources& sources, const std::string& key, const std::set<std::string>& places) {
    for (const auto& source : sources) {
        if (source.rfind(key + ":", 0) != 0) {
            continue;
        }
        for (const auto& ref : split_refs(source.substr(key.size() + 1))) {
            const auto near = [&](const std::string& place) { return is_within(ref, place) || is_within(place, ref); };
            if (std::any_of(places.begin(), places.end(), near)) {
                return true;
            }
        }
    }
    return false;
}

void advise_on_statements(const Register& content, Faults& advice) {
    const auto sources = sources_by_id(content);
    for (const Manual& manual : content.manuals) {
        for (const Statement& statement : manual.statements) {
            const std::string id = statement.id(manual.key);
            if (statement.is_open()) {
                advice.emplace_back(
                    statement.place, fmt::format("{} has neither `covered` nor `reason`", id),
                    "name in `covered` the items that cover the statement, or give in `reason` why no item covers it");
            }
            const auto places = names_of_place(manual, statement.section);
            const auto is_cited = [&](const std::string& item) {
                const auto found = sources.find(item);
                return found == sources.end() || cites(found->second, manual.key, places);
            };
            if (!statement.covered.empty() &&
                std::none_of(statement.covered.begin(), statement.covered.end(), is_cited)) {
                advice.emplace_back(statement.covered_place,
                                    fmt::format("{} is covered by {}, but none of these items names {} as its source",
                                                id, fmt::join(statement.covered, ", "), statement.section),
                                    "add the place to the source of one item, or name an item that has this source");
            }
        }
    }
}

/// Returns the words of the text with their punctuation.
std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in{text};
    return {std::istream_iterator<std::string>{in}, std::istream_iterator<std::string>{}};
}

/// Returns whether a sentence ends with this word: its last character is a full stop, an exclamation mark or a question
/// mark. Closing quotes and brackets after it do not count.
bool ends_sentence(std::string word) {
    while (!word.empty() && (word.back() == '"' || word.back() == ')')) {
        word.pop_back();
    }
    return !word.empty() && (word.back() == '.' || word.back() == '!' || word.back() == '?');
}

bool begins_sentence(const std::string& word) {
    return (word.front() >= 'A' && word.front() <= 'Z') || (word.front() >= '0' && word.front() <= '9');
}

/// Returns whether this word begins a condition, such as "when" or "if".
bool begins_condition(const std::string& word) {
    static constexpr std::array<std::string_view, 10> conditions{"if",     "when",  "whenever", "while",  "where",
                                                                 "unless", "until", "after",    "before", "once"};
    return std::find(conditions.begin(), conditions.end(), word) != conditions.end();
}

struct Demands {
    std::size_t shalls{0};
    std::size_t sentences{1};
    /// the word that begins a second condition after a semicolon; empty: there is no second condition
    std::string condition;
};

Demands demands_in(const std::string& text) {
    const std::vector<std::string> words = words_of(text);
    Demands found;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        found.shalls += word == "shall" || word == "shall," ? 1U : 0U;
        found.sentences += i > 0 && ends_sentence(words[i - 1]) && begins_sentence(word) ? 1U : 0U;
        if (i > 0 && words[i - 1].back() == ';' && begins_condition(word)) {
            found.condition = word;
        }
    }
    return found;
}

void advise_on_requirements(const Register& content, Faults& advice) {
    for (const Part& part : content.parts) {
        if (part.inherited) {
            continue;
        }
        for (const auto& requirement : part.requirements) {
            if (!requirement.retired.empty()) {
                continue;
            }
            const Demands found = demands_in(requirement.text);
            if (found.shalls > 1 || found.sentences > 1) {
                advice.emplace_back(requirement.place,
                                    fmt::format("{} demands several things: {} sentence(s), \"shall\" {} time(s)",
                                                requirement.id, found.sentences, found.shalls),
                                    "write one requirement for each demand");
            }
            if (!found.condition.empty()) {
                advice.emplace_back(requirement.place,
                                    fmt::format("{} has a second condition behind a semicolon: \"; {}\"",
                                                requirement.id, found.condition),
                                    "write one requirement for each condition, or one condition for both");
            }
        }
    }
}

}  // namespace

Faults advice_on(const Register& content) {
    Faults advice;
    advise_on_statements(content, advice);
    advise_on_requirements(content, advice);
    std::sort(advice.begin(), advice.end(), [](const Fault& a, const Fault& b) {
        return std::tie(a.place.file, a.place.line, a.what) < std::tie(b.place.file, b.place.line, b.what);
    });
    return advice;
}

}  // namespace canproof::host
