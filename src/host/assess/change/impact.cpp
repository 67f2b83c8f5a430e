// SPDX-License-Identifier: Apache-2.0
#include "host/assess/change/impact.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "host/assess/trace/audit.hpp"

namespace canproof::host {

namespace {

const char* word_of(ItemChange::Kind kind) {
    switch (kind) {
        case ItemChange::Kind::added:
            return "added";
        case ItemChange::Kind::removed:
            return "removed";
        default:
            return "changed";
    }
}

std::string verdict_of(const std::string& id, const Evidence& evidence) {
    const auto found = evidence.verdicts.find(id);
    if (found == evidence.verdicts.end()) {
        return "none";
    }
    return std::all_of(found->second.begin(), found->second.end(), [](const Verdict& one) { return one.passed; })
               ? "passed"
               : "failed";
}

std::string line(const char* what, const std::string& text) {
    return fmt::format("    {:<9} {}\n", what, text);
}

/// Returns lines with the decisions that affect an item, its code and its tests; for a decision, also the items that it
/// affects.
std::string links_of(const std::string& id, const Register& content, const Evidence& evidence) {
    std::string text;
    for (const auto& part : content.parts) {
        for (const auto& decision : part.decisions) {
            if (std::find(decision.affects.begin(), decision.affects.end(), id) != decision.affects.end()) {
                text += line("decision", decision.id);
            }
            if (decision.id == id) {
                for (const auto& affected : decision.affects) {
                    text += line("affects", affected);
                }
            }
        }
    }
    for (const auto& place : code_of(id, evidence)) {
        text += line("code", place);
    }
    if (const auto found = evidence.verdicts.find(id); found != evidence.verdicts.end()) {
        for (const auto& verdict : found->second) {
            text += line(verdict.kind.c_str(),
                         fmt::format("{} {} {}", verdict.passed ? "passed" : "FAILED", verdict.test, verdict.file));
        }
    }
    return text;
}

/// Returns what the user must do next, with the command, when the code or tests of an item changed; otherwise an empty
/// text.
std::string next_step(const Impact& impact) {
    return impact.stale.empty()
               ? ""
               : "next: run `./test`; then read the stale items with their code and tests, and record the review: "
                 "`canproof spec review ID… --by NAME --role author`\n";
}

/// Returns the items that a file of code implements or uses, and those that tests in the file verify.
std::set<std::string> items_in(const std::string& file, const Evidence& evidence) {
    std::set<std::string> ids;
    for (const auto* places : {&evidence.implemented, &evidence.used}) {
        for (const auto& [id, all] : *places) {
            for (const auto& place : all) {
                if (place.rfind(file + ":", 0) == 0) {
                    ids.insert(id);
                }
            }
        }
    }
    for (const auto& [id, shared] : evidence.implemented_by) {
        if (ids.count(shared) != 0) {
            ids.insert(id);
        }
    }
    for (const auto& [id, verdicts] : evidence.verdicts) {
        for (const auto& verdict : verdicts) {
            if (verdict.file == file) {
                ids.insert(id);
            }
        }
    }
    return ids;
}

}  // namespace

std::vector<VerdictChange> verdict_changes(const Evidence& before, const Evidence& after) {
    std::set<std::string> ids;
    for (const auto* evidence : {&before, &after}) {
        for (const auto& [id, verdicts] : evidence->verdicts) {
            ids.insert(id);
        }
    }
    std::vector<VerdictChange> changes;
    for (const auto& id : ids) {
        const std::string was = verdict_of(id, before);
        const std::string is = verdict_of(id, after);
        if (was != is) {
            changes.push_back({id, was, is});
        }
    }
    return changes;
}

std::string write_impact(const Impact& impact, const Register& content, const Evidence& evidence) {
    std::string text;
    std::set<std::string> touched;
    for (const auto& change : impact.items) {
        touched.insert(change.id);
        text += fmt::format("{} {} {}\n", change.word, change.id, word_of(change.kind));
        for (const auto& detail : change.details) {
            text += fmt::format("    {}\n", detail);
        }
        text += links_of(change.id, content, evidence);
    }
    for (const auto& file : impact.files) {
        const auto ids = items_in(file, evidence);
        touched.insert(ids.begin(), ids.end());
        text += fmt::format("file {}\n", file);
        text += ids.empty() ? "" : line("items", fmt::format("{}", fmt::join(ids, ", ")));
    }
    for (const auto& change : impact.verdicts) {
        text += fmt::format("verdict {} {} -> {}\n", change.id, change.before, change.after);
    }
    for (const auto& change : impact.stale) {
        touched.insert(change.id);
        text += fmt::format("stale {}: its {} changed\n", change.id,
                            change.code && change.tests ? "code and its tests have"
                            : change.code               ? "code has"
                                                        : "tests have");
        for (const auto& part : change.parts) {
            text += line("changed", fmt::format("{} {}", part.name.empty() ? "statements" : part.name, part.file));
        }
    }
    text += next_step(impact);
    return text +
           fmt::format("{} item(s) and {} file(s) changed, {} item(s) affected in total, {} test result(s) differ\n",
                       impact.items.size(), impact.files.size(), touched.size(), impact.verdicts.size());
}

std::string impact_json(const Impact& impact) {
    using Json = nlohmann::ordered_json;
    Json items = Json::array();
    for (const auto& one : impact.items) {
        items.push_back({{"id", one.id}, {"word", one.word}, {"change", word_of(one.kind)}, {"details", one.details}});
    }
    Json verdicts = Json::array();
    for (const auto& one : impact.verdicts) {
        verdicts.push_back({{"id", one.id}, {"before", one.before}, {"after", one.after}});
    }
    Json stale = Json::array();
    for (const auto& one : impact.stale) {
        Json parts = Json::array();
        for (const auto& part : one.parts) {
            parts.push_back({{"name", part.name}, {"place", part.file}});
        }
        stale.push_back({{"id", one.id}, {"code", one.code}, {"tests", one.tests}, {"changed", parts}});
    }
    return Json{{"items", items}, {"files", impact.files}, {"verdicts", verdicts}, {"stale", stale}}.dump(2) + "\n";
}

}  // namespace canproof::host
