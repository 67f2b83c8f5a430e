// SPDX-License-Identifier: Apache-2.0
#include "host/conform/run/cases.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>

#include "host/conform/run/case_files.hpp"
#include "host/conform/steps/parse_steps.hpp"
#include "host/register/toml_depth.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host::conform {

namespace {

using Calls = std::vector<StepSource::Call>;

/// Returns the place of the first line of the text at `key`. For a text between `'''`, this is the line after the
/// opening quotes.
Place first_line(const TomlItem& item, const std::string& key) {
    const toml::node* const node = item.table().get(key);
    Place place = item.place(key);
    const toml::source_region region = node == nullptr ? toml::source_region{} : node->source();
    place.line += region.begin.line != region.end.line ? 1U : 0U;
    return place;
}

Steps read_steps(TomlItem& item, const std::string& key, Calls& calls) {
    const std::string text = item.text_or(key, "");
    try {
        StepSource source{text, first_line(item, key)};
        Steps steps = source.block(false);
        calls.insert(calls.end(), source.calls.begin(), source.calls.end());
        return steps;
    } catch (const LanguageError& error) {
        item.faults().push_back(error.fault);
        return {};
    }
}

template <typename Kind>
Kind word_of(TomlItem& item, const std::string& key, const std::vector<std::pair<std::string, Kind>>& kinds) {
    std::vector<std::string> words;
    for (const auto& [word, kind] : kinds) {
        words.push_back(word);
    }
    const std::string found = item.word(key, words, words.front());
    for (const auto& [word, kind] : kinds) {
        if (word == found) {
            return kind;
        }
    }
    return kinds.front().second;
}

bool is_kebab_case(const std::string& text) {
    return !text.empty() && text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
}

void read_needs(TomlItem& item, Case& one) {
    for (const std::string& text : item.texts("needs", false)) {
        try {
            Scanner line{text, item.place("needs")};
            one.needs.push_back(parse_need(line));
        } catch (const LanguageError& error) {
            item.faults().push_back(error.fault);
        }
    }
}

void read_allowed(TomlItem& item, Case& one) {
    for (const std::string& word : item.texts("allow", false)) {
        one.allows_emcy = one.allows_emcy || word == "emcy";
        one.allows_boot_up = one.allows_boot_up || word == "boot-up";
        one.allows_sdo = one.allows_sdo || word == "sdo";
        if (word != "emcy" && word != "boot-up" && word != "sdo") {
            item.fault(item.place("allow"), fmt::format("`{}` cannot be allowed", word), "use emcy, boot-up, sdo");
        }
    }
}

Case read_case(TomlItem& item, Calls& calls) {
    Case one;
    one.place = item.place();
    one.id = item.text("id");
    if (!is_kebab_case(one.id)) {
        item.fault(item.place("id"), fmt::format("`{}` is no id", one.id), "use small letters, digits and dashes");
    }
    one.group = item.word("group", case_groups(), "");
    one.numbers = item.texts("public", false);
    one.shows = item.text("shows");
    one.section = item.text("section");
    one.tests = item.texts("tests", false);
    one.risk = word_of<Risk>(item, "risk",
                             {{"none", Risk::none},
                              {"output", Risk::output},
                              {"store", Risk::store},
                              {"lss", Risk::lss},
                              {"restart", Risk::restart}});
    one.preparation = word_of<Preparation>(item, "prepare",
                                           {{"reset communication", Preparation::reset_communication},
                                            {"reset node", Preparation::reset_node},
                                            {"none", Preparation::none}});
    read_needs(item, one);
    read_allowed(item, one);
    one.steps = read_steps(item, "steps", calls);
    one.restore = read_steps(item, "restore", calls);
    if (!item.has("steps")) {
        item.fault("the case has no steps", "add steps = '''…'''");
    }
    item.finish();
    return one;
}

Procedure read_procedure(TomlItem& item, Calls& calls) {
    Procedure one;
    one.name = item.text("name");
    one.takes = item.texts("takes", false);
    one.file = item.file();
    one.steps = read_steps(item, "steps", calls);
    item.finish();
    return one;
}

void check_calls(const Calls& calls, const CaseBook& book, Faults& faults) {
    for (const StepSource::Call& call : calls) {
        const auto found = book.procedures.find(call.name);
        if (found == book.procedures.end()) {
            faults.emplace_back(call.place, fmt::format("there is no procedure `{}`", call.name),
                                "write a [[procedure]] of that name");
        } else if (found->second.takes.size() != call.arguments) {
            faults.emplace_back(call.place, fmt::format("`{}` gets {} argument(s)", call.name, call.arguments),
                                fmt::format("give the procedure {} argument(s)", found->second.takes.size()));
        }
    }
}

void check_unique(const CaseBook& book, Faults& faults) {
    std::set<std::string> ids;
    for (const Case& one : book.cases) {
        if (!ids.insert(one.id).second) {
            faults.emplace_back(one.place, fmt::format("there are two cases {}", one.id), "change the id of one case");
        }
    }
}

}  // namespace

const std::vector<std::string>& case_groups() {
    static const std::vector<std::string> groups{"eds",       "sdo",      "pdo",   "od",  "emcy", "sync",
                                                 "heartbeat", "guarding", "store", "nmt", "lss",  "load"};
    return groups;
}

CaseBook parse_cases(const std::map<std::string, std::string>& files, Faults& faults) {
    CaseBook book;
    Calls calls;
    for (const auto& [path, text] : files) {
        if (const auto line = too_deep_in(text)) {
            faults.emplace_back(Place{path, *line}, "keys or values are nested too deeply", "nest them less deeply");
            continue;
        }
        try {
            const toml::table table = toml::parse(text, path);
            TomlItem whole{table, path, faults};
            for (TomlItem& item : whole.items("case")) {
                book.cases.push_back(read_case(item, calls));
            }
            for (TomlItem& item : whole.items("procedure")) {
                const Procedure one = read_procedure(item, calls);
                book.procedures[one.name] = one;
            }
            whole.finish();
        } catch (const toml::parse_error& error) {
            faults.emplace_back(Place{path, static_cast<unsigned>(error.source().begin.line)},
                                fmt::format("the file is not TOML: {}", error.description()), "correct the syntax");
        }
    }
    check_calls(calls, book, faults);
    check_unique(book, faults);
    CaseBook sorted;
    sorted.procedures = book.procedures;
    for (const std::string& group : case_groups()) {
        std::copy_if(book.cases.begin(), book.cases.end(), std::back_inserter(sorted.cases),
                     [&](const Case& one) { return one.group == group; });
    }
    return sorted;
}

const CaseBook& built_in_cases() {
    static const CaseBook book = [] {
        Faults faults;
        CaseBook read = parse_cases(case_files(), faults);
        if (!faults.empty()) {
            throw std::logic_error{faults.front().text()};
        }
        return read;
    }();
    return book;
}

}  // namespace canproof::host::conform
