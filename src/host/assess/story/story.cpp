// SPDX-License-Identifier: Apache-2.0
#include "host/assess/story/story.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "host/assess/trace/review.hpp"
#include "host/assess/trace/statement_audit.hpp"
#include "host/base/one_line.hpp"

namespace canproof::host {

namespace {

std::string line(const char* what, const std::string& text) {
    return fmt::format("  {:<12} {}\n", what, text);
}

std::string joined(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::string item_line(const AuditedItem& audited) {
    return fmt::format("  {:<22} {:<8} {:<11} {}\n", audited.item->id, audited.status(),
                       audited.kind.empty() ? audited.word : audited.kind, brief(audited.item->text));
}

std::string statement_line(const AuditedStatement& audited) {
    return fmt::format("  {:<22} {:<9} {:<10} {}\n", audited.id, audited.status, "statement",
                       brief(audited.statement->text));
}

StoryTeller::StoryTeller(const Register& content, const std::vector<PartAudit>& audits, const Evidence& evidence,
                         const CountsByItem& mutations)
    : content_{content}, evidence_{evidence}, mutations_{mutations} {
    for (const auto& audit : audits) {
        for (const auto& audited : audit.items) {
            items_[audited.item->id] = &audited;
            parts_[audited.item->id] = audit.part;
        }
        for (const auto& one : audit.part->decisions) {
            decisions_[one.id] = &one;
        }
        for (const auto& one : audit.statements) {
            statements_[one.id] = &one;
        }
        audits_[audit.part->info.manual] = &audit;
    }
}

std::optional<Story> StoryTeller::tell(const std::string& subject) const {
    if (const auto found = items_.find(subject); found != items_.end()) {
        return item(*found->second);
    }
    if (const auto found = decisions_.find(subject); found != decisions_.end()) {
        return decision(*found->second);
    }
    if (const auto found = statements_.find(subject); found != statements_.end()) {
        return statement(*found->second);
    }
    for (const auto look : {&StoryTeller::section, &StoryTeller::file, &StoryTeller::test}) {
        if (auto story = (this->*look)(subject)) {
            return story;
        }
    }
    return std::nullopt;
}

std::string StoryTeller::sections_of(const AuditedItem& audited) const {
    std::string text;
    for (const auto& source : audited.item->sources) {
        const auto colon = source.find(':');
        const Manual* manual = content_.manual(source.substr(0, colon));
        std::string title;
        if (manual != nullptr) {
            for (const auto& section : manual->sections) {
                const std::string refs = " " + source.substr(colon + 1) + " ";
                if (refs.find(" " + section.ref + " ") != std::string::npos) {
                    title += (title.empty() ? ": " : "; ") + section.title;
                }
            }
        }
        text += line("source", source + title);
    }
    if (!audited.item->derived.empty()) {
        text += line("derived", audited.item->derived);
    }
    return text;
}

std::string StoryTeller::verdicts_of(const std::string& id) const {
    std::string text;
    if (const auto found = evidence_.verdicts.find(id); found != evidence_.verdicts.end()) {
        for (const auto& verdict : found->second) {
            text += line(verdict.kind.c_str(),
                         fmt::format("{} {} {}", verdict.passed ? "passed" : "FAILED", verdict.test, verdict.file));
        }
    }
    return text;
}

Story StoryTeller::item(const AuditedItem& audited) const {
    const Item& one = *audited.item;
    const Part& part = *parts_.at(one.id);
    Story story{fmt::format("{} ({}{}{} of {}, {}:{})\n  {}\n", one.id, audited.kind, audited.kind.empty() ? "" : " ",
                            audited.word, part.name, one.place.file, one.place.line, one.text),
                audited.status() != "shown"};
    story.text += sections_of(audited);
    for (const auto& id : audited.decisions) {
        story.text += line("decision", id + ": " + brief(decisions_.at(id)->chosen));
    }
    if (const std::string& shared = implementing_id(one.id, evidence_); shared != one.id) {
        story.text += line("by", shared + ", a requirement of all devices, implements this one");
    }
    for (const auto& place : code_of(one.id, evidence_)) {
        story.text += line("code", place);
    }
    if (audited.word == "object") {
        story.text +=
            line("code", fmt::format("generated/{}/objects.hpp, read by the object dictionary", part.cpp_name()));
    }
    story.text += line("demanded", joined(audited.demanded));
    story.text += verdicts_of(one.id);
    for (const auto& kind : audited.missing) {
        story.text += line(kind.c_str(), "none has passed");
    }
    if (const auto found = mutations_.find(one.id); found != mutations_.end()) {
        const MutationCount& count = found->second;
        story.text += line("alterations",
                           fmt::format("{} of {} noticed{}", count.noticed, count.altered,
                                       count.justified == 0 ? "" : fmt::format(", {} with a reason", count.justified)));
    }
    const auto reviewed = part.reviews.find(one.id);
    story.text += line("review", !audited.suspect.empty() ? audited.suspect : review_words(reviewed->second));
    if (reviewed != part.reviews.end()) {
        const IndependentReview independent = ReviewState{content_, evidence_.work}.independent(part, one.id);
        if (const std::string words = independent_words(independent, reviewed->second); !words.empty()) {
            story.text += line("", words);
        }
    }
    story.text += line("verdict", audited.status());
    return story;
}

Story StoryTeller::list(const std::string& head, const std::vector<std::string>& ids) const {
    Story story{head, false};
    for (const auto& id : ids) {
        if (const auto found = items_.find(id); found != items_.end()) {
            story.text += item_line(*found->second);
            story.open = story.open || found->second->status() != "shown";
        }
    }
    return story;
}

Story StoryTeller::decision(const Decision& one) const {
    std::string head =
        fmt::format("{} (decision, {}, {}:{})\n  {}\n", one.id, one.severity, one.place.file, one.place.line, one.text);
    for (const auto& reading : one.readings) {
        head += line("reading", fmt::format("{} [{}]", reading.says, reading.source));
    }
    head += line("chosen", one.chosen) + line("because", one.because);
    if (!one.answer.topic.empty()) {
        head += line("topic", one.answer.topic + ": " + one.answer.choice);
        head += one.answer.differs.empty() ? "" : line("differs", one.answer.differs);
        head += one.answer.overrides.empty() ? "" : line("overrides", one.answer.overrides);
    }
    head += one.affects.empty() ? line("affects", "nothing: " + one.none) : "";
    return list(head, one.affects);
}

std::optional<Story> StoryTeller::section(const std::string& subject) const {
    const auto colon = subject.find(':');
    const Manual* manual = colon == std::string::npos ? nullptr : content_.manual(subject.substr(0, colon));
    if (manual == nullptr) {
        return std::nullopt;
    }
    for (const auto& one : manual->sections) {
        if (one.ref != subject.substr(colon + 1)) {
            continue;
        }
        const auto ids = SectionIndex{content_}.items_of(manual->key, one);
        const char* disposition = one.normative               ? "normative"
                                  : one.is_condition_of_use() ? "condition of use"
                                                              : "informative: ";
        std::string head = fmt::format("{} {} ({}{})\n", subject, one.title, disposition, one.reason);
        for (const auto& condition : one.conditions) {
            head += line("condition", condition);
        }
        const auto statements = statements_of(*manual, one);
        for (const auto* statement : statements) {
            head += statement_line(*statement);
        }
        Story story = list(head, ids);
        const bool covered = manual->statements.empty() ? !ids.empty() : !statements.empty();
        story.open =
            story.open || (one.normative && !covered) ||
            std::any_of(statements.begin(), statements.end(), [](const auto* statement) { return statement->open(); });
        return story;
    }
    return std::nullopt;
}

std::vector<const AuditedStatement*> StoryTeller::statements_of(const Manual& manual, const Section& section) const {
    std::vector<const AuditedStatement*> found;
    if (const auto audit = audits_.find(manual.key); audit != audits_.end()) {
        const auto& all = audit->second->statements;
        const auto sections = by_section(manual, all);
        if (const auto here = sections.find(section.ref); here != sections.end()) {
            std::transform(here->second.begin(), here->second.end(), std::back_inserter(found),
                           [&](const std::size_t at) { return &all[at]; });
        }
    }
    return found;
}

Story StoryTeller::statement(const AuditedStatement& audited) const {
    const Statement& one = *audited.statement;
    Story story{fmt::format("{} (statement, {}:{})\n  {}\n", audited.id, one.place.file, one.place.line, one.text),
                audited.open()};
    const Manual* manual = content_.manual(audited.id.substr(0, audited.id.find(':')));
    if (const Section* section = manual->describing(one.section)) {
        story.text += line("section", section->ref + " " + section->title);
    }
    std::vector<std::string> marks;
    for (const Mark& mark : one.marks) {
        marks.push_back(mark.text());
    }
    story.text += line("passage", joined(marks));
    if (one.is_open()) {
        story.text += line("covered by", "nothing, and there is no reason");
    } else if (!one.reason.empty()) {
        story.text += line("not covered", one.reason);
    }
    for (const auto& id : one.covered) {
        if (const auto item = items_.find(id); item != items_.end()) {
            story.text += item_line(*item->second) + verdicts_of(id);
        } else if (const auto found = decisions_.find(id); found != decisions_.end()) {
            story.text += fmt::format("  {:<22} {:<8} {:<11} {}\n", id, "", "decision", brief(found->second->chosen));
        } else {
            story.text +=
                fmt::format("  {:<22} {}\n", id, "shared item of canproof; canproof's own audit shows its status");
        }
    }
    story.text += line("verdict", audited.status);
    return story;
}

std::optional<Story> StoryTeller::file(const std::string& subject) const {
    std::vector<std::string> ids;
    const auto is_here = [&](const std::string& place) { return place.rfind(subject + ":", 0) == 0; };
    for (const auto& [id, audited] : items_) {
        const auto code = code_of(id, evidence_);
        const auto verdicts = evidence_.verdicts.find(id);
        const bool tested = verdicts != evidence_.verdicts.end() &&
                            std::any_of(verdicts->second.begin(), verdicts->second.end(),
                                        [&](const Verdict& verdict) { return verdict.file == subject; });
        if (tested || std::any_of(code.begin(), code.end(), is_here)) {
            ids.push_back(id);
        }
    }
    return ids.empty() ? std::nullopt : std::optional{list(subject + "\n", ids)};
}

std::optional<Story> StoryTeller::test(const std::string& subject) const {
    const auto run = std::find_if(evidence_.runs.begin(), evidence_.runs.end(),
                                  [&](const TestRun& one) { return one.name == subject; });
    if (run == evidence_.runs.end()) {
        return std::nullopt;
    }
    std::vector<std::string> ids;
    for (const auto& [id, verdicts] : evidence_.verdicts) {
        if (std::any_of(verdicts.begin(), verdicts.end(), [&](const Verdict& one) { return one.test == subject; })) {
            ids.push_back(id);
        }
    }
    Story story = list(fmt::format("{} ({}, {})\n", run->name, run->file, run->passed ? "passed" : "FAILED"), ids);
    story.open = story.open || !run->passed;
    return story;
}

}  // namespace canproof::host
