#include "host/assess/story/story.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace canproof::host {

namespace {

std::string line(const char* what, const std::string& text) {
    return fmt::format("  {:<12} {}\n", what, text);
}

std::string joined(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

std::string brief(const std::string& text) {
    constexpr std::size_t longest = 90;
    return text.size() <= longest ? text : text.substr(0, text.rfind(' ', longest)) + " …";
}

std::string review_line(const Review& review) {
    const std::string role = review.role == "author"        ? ", author of the change"
                             : review.role == "independent" ? ", not the author of the change"
                                                            : ", role not stated";
    if (!review.marked.empty()) {
        return fmt::format("{} by {}{}; read: item; code and tests marked on {} and not read", review.date, review.by,
                           role, review.marked);
    }
    std::string read = "item";
    read += review.code.empty() ? "" : ", code";
    read += review.tests.empty() ? "" : ", tests";
    return fmt::format("{} by {}{}; read: {}", review.date, review.by, role, read);
}

}  // namespace

std::string item_line(const AuditedItem& audited) {
    return fmt::format("  {:<22} {:<8} {:<11} {}\n", audited.item->id, audited.status(),
                       audited.kind.empty() ? audited.word : audited.kind, brief(audited.item->text));
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
    }
}

std::optional<Story> StoryTeller::tell(const std::string& subject) const {
    if (const auto found = items_.find(subject); found != items_.end()) {
        return item(*found->second);
    }
    if (const auto found = decisions_.find(subject); found != decisions_.end()) {
        return decision(*found->second);
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
                title += refs.find(" " + section.ref + " ") == std::string::npos ? "" : " " + section.title + ";";
            }
        }
        text += line("source", source + (title.empty() ? "" : ":" + title));
    }
    if (!audited.item->derived.empty()) {
        text += line("derived", audited.item->derived);
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
    for (const auto& place : code_of(one.id, evidence_)) {
        story.text += line("code", place);
    }
    if (audited.word == "object") {
        story.text +=
            line("code", fmt::format("generated/{}/objects.hpp, read by the object dictionary", part.cpp_name()));
    }
    story.text += line("demanded", joined(audited.demanded));
    if (const auto found = evidence_.verdicts.find(one.id); found != evidence_.verdicts.end()) {
        for (const auto& verdict : found->second) {
            story.text += line(verdict.kind.c_str(), fmt::format("{} {} {}", verdict.passed ? "passed" : "FAILED",
                                                                 verdict.test, verdict.file));
        }
    }
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
    story.text += line("review", !audited.suspect.empty() ? audited.suspect : review_line(reviewed->second));
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
        const char* disposition = one.normative        ? "normative"
                                  : one.reason.empty() ? "condition of use"
                                                       : "informative: ";
        std::string head = fmt::format("{} {} ({}{})\n", subject, one.title, disposition, one.reason);
        for (const auto& condition : one.conditions) {
            head += line("condition", condition);
        }
        Story story = list(head, ids);
        story.open = story.open || (one.normative && ids.empty());
        return story;
    }
    return std::nullopt;
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
