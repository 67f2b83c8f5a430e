// SPDX-License-Identifier: Apache-2.0
#include "host/assess/trace/audit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "host/assess/firmware_scope.hpp"
#include "host/assess/trace/review.hpp"
#include "host/assess/trace/statement_audit.hpp"

namespace canproof::host {

namespace {

/// Returns the kinds (test, property …) of the passed tests that verify the item `id`, and whether a test that verifies
/// it has failed.
std::pair<std::set<std::string>, bool> results_for(const std::string& id, const Evidence& evidence) {
    std::set<std::string> passed;
    bool failed = false;
    const auto found = evidence.verdicts.find(id);
    if (found != evidence.verdicts.end()) {
        for (const auto& verdict : found->second) {
            failed = failed || !verdict.passed;
            if (verdict.passed) {
                passed.insert(verdict.kind);
            }
        }
    }
    return {passed, failed};
}

using DecisionsByItem = std::map<std::string, std::vector<std::string>>;

DecisionsByItem decisions_by_item(const Register& content) {
    DecisionsByItem all;
    for (const auto& part : content.parts) {
        for (const auto& decision : part.decisions) {
            for (const auto& id : decision.affects) {
                all[id].push_back(decision.id);
            }
        }
    }
    return all;
}

/// Returns whether an item needs hand-written code. An object needs none because it is a row of the generated
/// dictionary. A signal needs none because it is a member of the device's inputs or outputs. An item that only
/// inspection or analysis verifies needs none either.
bool needs_code(const AuditedItem& audited) {
    if (audited.word == "object" || audited.word == "signal") {
        return false;
    }
    return std::any_of(audited.demanded.begin(), audited.demanded.end(),
                       [](const std::string& kind) { return kind != "inspection" && kind != "analysis"; });
}

class PartAuditor {
  public:
    PartAuditor(const Register& content, const Part& part, const Evidence& evidence, const DecisionsByItem& decisions,
                const ReviewState& reviews)
        : content_{content}, part_{part}, evidence_{evidence}, decisions_{decisions}, reviews_{reviews} {
        for (const auto& requirement : part.requirements) {
            requirements_[requirement.id] = &requirement;
        }
    }

    PartAudit run(const SectionIndex& sections) {
        audit_.part = &part_;
        content_.for_each_item(part_, [&](const Item& item, const char* word) { audit_item(item, word); });
        for (const auto& hazard : part_.hazards) {
            add_suspect(hazard.id, hazard.id + ": ");
        }
        if (const Manual* manual = content_.manual(part_.info.manual)) {
            audit_sections(*manual, sections);
        }
        return std::move(audit_);
    }

  private:
    void audit_item(const Item& item, const char* word) {
        AuditedItem audited;
        audited.item = &item;
        audited.word = word;
        audited.demanded = {"test"};
        if (const auto requirement = requirements_.find(item.id); requirement != requirements_.end()) {
            if (!requirement->second->retired.empty()) {
                return;
            }
            audited.demanded = requirement->second->verify;
            audited.kind = requirement->second->kind;
        }
        const auto [passed, failed] = results_for(item.id, evidence_);
        audited.failed = failed;
        for (const auto& kind : audited.demanded) {
            if (passed.count(kind) == 0) {
                audited.missing.push_back(kind);
            }
        }
        if (const auto found = decisions_.find(item.id); found != decisions_.end()) {
            audited.decisions = found->second;
        }
        audited.without_code = needs_code(audited) && code_of(item.id, evidence_).empty();
        audited.suspect = reviews_.suspicion(item.id, audited.decisions);
        tell(audited);
        audit_.items.push_back(audited);
    }

    void tell(const AuditedItem& audited) {
        const std::string& id = audited.item->id;
        if (audited.failed) {
            audit_.gaps.push_back(fmt::format("{}: a test that verifies this item has failed", id));
        } else if (!audited.missing.empty()) {
            audit_.gaps.push_back(
                fmt::format("{}: there is no passed {}", id, fmt::join(audited.missing, ", no passed ")));
        }
        if (audited.without_code) {
            const std::string& by = implementing_id(id, evidence_);
            audit_.gaps.push_back(fmt::format("{}: no code implements {}", id, by == id ? "this item" : by));
        }
        if (!audited.suspect.empty()) {
            audit_.suspects.push_back(fmt::format("{}: {}", id, audited.suspect));
        }
    }

    /// If the item or section `id` has no up-to-date review, adds a sentence to the suspects: `words`, then the reason.
    void add_suspect(const std::string& id, const std::string& words) {
        if (const std::string reason = reviews_.suspicion(id, {}); !reason.empty()) {
            audit_.suspects.push_back(words + reason);
        }
    }

    void audit_sections(const Manual& manual, const SectionIndex& index) {
        for (const auto& section : manual.sections) {
            const std::string id = section.id(manual.key);
            add_suspect(id, fmt::format("{} ({}): its disposition: ", id, section.title));
            if (!section.normative) {
                continue;
            }
            const auto items = index.items_of(manual.key, section);
            audit_.sections.push_back({&section, items, !items.empty()});
            if (items.empty() && manual.statements.empty()) {
                audit_.gaps.push_back(
                    fmt::format("{}:{} ({}): the section is normative, but no item names it as its source", manual.key,
                                section.ref, section.title));
            }
        }
    }

    const Register& content_;
    const Part& part_;
    const Evidence& evidence_;
    const DecisionsByItem& decisions_;
    const ReviewState& reviews_;
    std::map<std::string, const Requirement*> requirements_;
    PartAudit audit_;
};

}  // namespace

std::string AuditedItem::status() const {
    return failed ? "failed" : open() ? "open" : suspect.empty() ? "shown" : "suspect";
}

PartAudit audit_part(const Register& content, const Part& part, const Evidence& evidence) {
    std::vector<PartAudit> all = audit_all(content, evidence);
    const auto found = std::find_if(all.begin(), all.end(), [&](const PartAudit& one) { return one.part == &part; });
    return found == all.end() ? PartAudit{} : std::move(*found);
}

std::vector<PartAudit> audit_all(const Register& content, const Evidence& evidence) {
    const DecisionsByItem decisions = decisions_by_item(content);
    const ReviewState reviews{content, evidence.work};
    const SectionIndex sections{content};
    std::vector<PartAudit> all;
    for (const auto& part : content.parts) {
        if (!part.inherited) {
            all.push_back(PartAuditor{content, part, evidence, decisions, reviews}.run(sections));
        }
    }
    audit_statements(content, all);
    return all;
}

std::vector<std::string> orphans(const Evidence& evidence) {
    std::vector<std::string> all;
    for (const auto& file : evidence.untraced) {
        all.push_back(fmt::format("{}: no requirement belongs to this file or to code that includes this file", file));
    }
    all.insert(all.end(), evidence.misplaced.begin(), evidence.misplaced.end());
    for (const auto& run : evidence.runs) {
        if (!run.claims && tests_the_firmware(run.file)) {
            all.push_back(fmt::format("{} ({}): the test verifies no requirement", run.name, run.file));
        }
    }
    return all;
}

std::vector<std::string> code_of(const std::string& id, const Evidence& evidence) {
    std::vector<std::string> code;
    for (const auto* places : {&evidence.implemented, &evidence.used}) {
        if (const auto found = places->find(implementing_id(id, evidence)); found != places->end()) {
            code.insert(code.end(), found->second.begin(), found->second.end());
        }
    }
    return code;
}

}  // namespace canproof::host
