// SPDX-License-Identifier: Apache-2.0
#include "host/assess/trace/kill_audit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "host/assess/source/test_bodies.hpp"

namespace canproof::host {

namespace {

/// Greatest number of tests whose names one line lists.
constexpr std::size_t most_names = 40;

enum class Judgement { never, changed, other_code, as_it_was };

bool holds(const std::vector<std::string>& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

class Auditor {
  public:
    Auditor(const Evidence& evidence, const KillRecord& record, const std::filesystem::path& root)
        : evidence_{evidence}, record_{record} {
        TestBodies bodies{root};
        std::map<std::string, std::string> code = code_by_test(evidence);
        for (const TestRun& run : evidence.runs) {
            ran_.insert(run.name);
            const auto found = record.find(run.name);
            judgements_[run.name] = found == record.end()                                   ? Judgement::never
                                    : bodies.hash(run.file, run.name) != found->second.body ? Judgement::changed
                                    : code[run.name] != found->second.code                  ? Judgement::other_code
                                                                                            : Judgement::as_it_was;
        }
        for (const auto& [test, line] : record) {
            for (const auto& id : line.kills) {
                killers_[id].push_back(test);
            }
        }
    }

    KillAudit run(const std::vector<std::string>& ids) {
        for (const auto& id : ids) {
            audit_item(id);
        }
        audit_tests();
        return std::move(audit_);
    }

  private:
    void audit_item(const std::string& id) {
        bool passed = false;
        bool shown = false;
        bool shown_before = false;  // whether an unchanged test noticed a mutant before the item's code changed
        bool judged = true;
        bool has_mutants = false;
        const auto verdicts = evidence_.verdicts.find(id);
        const std::vector<Verdict> none;
        for (const Verdict& verdict : verdicts == evidence_.verdicts.end() ? none : verdicts->second) {
            if (!verdict.passed) {
                continue;
            }
            passed = true;
            const Judgement judgement = judgements_[verdict.test];
            if (judgement != Judgement::as_it_was) {
                judged = false;
                shown_before =
                    shown_before || (judgement == Judgement::other_code && holds(record_.at(verdict.test).kills, id));
                continue;
            }
            const KillLine& line = record_.at(verdict.test);
            shown = shown || holds(line.kills, id);
            has_mutants = has_mutants || !holds(line.without_mutants, id);
        }
        if (shown) {
            ++audit_.shown;
        } else if (passed) {
            (!judged ? audit_.unjudged : has_mutants ? audit_.unnoticed : audit_.immutable).push_back(id);
        }
        if (const auto killers = killers_.find(id); !shown && !shown_before && killers != killers_.end()) {
            audit_.regressions.push_back(
                fmt::format("{}: {} noticed a mutant of this item, but no test in its present form does", id,
                            fmt::join(killers->second.begin(),
                                      killers->second.begin() +
                                          static_cast<std::ptrdiff_t>(std::min<std::size_t>(3, killers->second.size())),
                                      ", ")));
        }
    }

    void audit_tests() {
        for (const auto& [test, line] : record_) {
            if (ran_.count(test) == 0 && !line.kills.empty()) {
                audit_.regressions.push_back(fmt::format("{}: the test no longer exists; it noticed mutants of {}",
                                                         test, fmt::join(line.kills, ", ")));
            }
        }
        for (const TestRun& run : evidence_.runs) {
            const Judgement judgement = judgements_[run.name];
            if (judgement == Judgement::changed) {
                audit_.changed.push_back(run.name);
            } else if (judgement == Judgement::other_code) {
                audit_.other_code.push_back(run.name);
            } else if (judgement == Judgement::never && run.claims) {
                audit_.never.push_back(run.name);
            } else if (judgement == Judgement::as_it_was && record_.at(run.name).kills.empty()) {
                audit_.idle.push_back(run.name);
            }
        }
    }

    const Evidence& evidence_;
    const KillRecord& record_;
    std::set<std::string> ran_;
    std::map<std::string, Judgement> judgements_;
    /// the tests that notice a mutant of an item, by the id of the item
    std::map<std::string, std::vector<std::string>> killers_;
    KillAudit audit_;
};

std::string named(const char* what, const std::vector<std::string>& names, std::size_t most = std::string::npos) {
    if (names.empty()) {
        return "";
    }
    const auto end = names.begin() + static_cast<std::ptrdiff_t>(std::min(most, names.size()));
    return fmt::format("  {}: {}{}\n", what, fmt::join(names.begin(), end, " "),
                       names.size() > most ? fmt::format(" and {} more", names.size() - most) : "");
}

}  // namespace

KillAudit audit_kills(const std::vector<std::string>& ids, const Evidence& evidence, const KillRecord& record,
                      const std::filesystem::path& root) {
    return Auditor{evidence, record, root}.run(ids);
}

std::string kill_summary(const KillAudit& audit) {
    std::string text = fmt::format(
        "mutants: {} item(s) have a mutant that a test notices, {} have only mutants that no test notices, {} have no "
        "mutants, {} wait for `canproof mutate --kills`\n",
        audit.shown, audit.unnoticed.size(), audit.immutable.size(), audit.unjudged.size());
    text += named("items of which no test notices a mutant", audit.unnoticed);
    text += named("items without mutants", audit.immutable);
    text += named("items that wait for a mutation run", audit.unjudged);
    text += named("tests that notice no mutant of the items that they verify", audit.idle, most_names);
    text += named("tests that changed since the last mutation run", audit.changed);
    text += named("tests whose items have other code than in the last mutation run", audit.other_code, most_names);
    text += named("tests that no mutation run has judged", audit.never, most_names);
    for (const auto& regression : audit.regressions) {
        text += fmt::format("  regression: {}\n", regression);
    }
    return text;
}

}  // namespace canproof::host
