// SPDX-License-Identifier: Apache-2.0
#include "host/assess/trace/audit_json.hpp"

#include <nlohmann/json.hpp>

namespace canproof::host {

namespace {

using Json = nlohmann::ordered_json;

Json tests_of(const std::string& id, const Evidence& evidence) {
    Json all = Json::array();
    if (const auto found = evidence.verdicts.find(id); found != evidence.verdicts.end()) {
        for (const auto& verdict : found->second) {
            all.push_back({{"test", verdict.test}, {"kind", verdict.kind}, {"passed", verdict.passed}});
        }
    }
    return all;
}

Json json_of(const AuditedItem& item, const Evidence& evidence) {
    return {{"id", item.item->id},
            {"implemented_by", implementing_id(item.item->id, evidence)},
            {"word", item.word},
            {"kind", item.kind},
            {"text", item.item->text},
            {"status", item.status()},
            {"sources", origins(*item.item)},
            {"decisions", item.decisions},
            {"code", code_of(item.item->id, evidence)},
            {"tests", tests_of(item.item->id, evidence)},
            {"missing", item.missing},
            {"without_code", item.without_code},
            {"suspect", item.suspect}};
}

Json json_of(const AuditedStatement& statement) {
    const Statement& one = *statement.statement;
    Json made{{"id", statement.id}, {"section", one.section}, {"text", one.text}, {"status", statement.status}};
    made["covered"] = one.covered;
    if (!one.reason.empty()) {
        made["reason"] = one.reason;
    }
    return made;
}

Json json_of(const AuditedSection& section) {
    return {{"ref", section.section->ref},
            {"title", section.section->title},
            {"covered", section.covered},
            {"source_of", section.covered_by}};
}

Json json_of(const PartAudit& audit, const Manual* manual, const AuditFilter& filter, const Evidence& evidence) {
    Json made{{"part", audit.part->name}, {"items", Json::array()}};
    for (const auto& one : audit.items) {
        if (passes(one, filter)) {
            made["items"].push_back(json_of(one, evidence));
        }
    }
    if (manual != nullptr) {
        made["manual"] = manual->key;
        made["counts_by"] = manual->statements.empty() ? "section" : "statement";
        made["statements"] = Json::array();
        for (const auto& one : audit.statements) {
            if (passes(one, *manual, filter)) {
                made["statements"].push_back(json_of(one));
            }
        }
    }
    if (filter.empty()) {
        made["sections"] = Json::array();
        for (const auto& one : audit.sections) {
            made["sections"].push_back(json_of(one));
        }
        made["gaps"] = audit.gaps;
        made["suspects"] = audit.suspects;
    }
    return made;
}

}  // namespace

std::string write_audit_json(const Register& content, const std::vector<PartAudit>& audits, const AuditFilter& filter,
                             const std::map<std::string, std::vector<std::string>>& findings,
                             const Evidence& evidence) {
    Json whole{{"parts", Json::array()}};
    for (const auto& audit : audits) {
        whole["parts"].push_back(json_of(audit, content.manual(audit.part->info.manual), filter, evidence));
    }
    for (const auto& [name, sentences] : findings) {
        whole[name] = sentences;
    }
    whole["tests"] = evidence.tests;
    whole["failed"] = evidence.failed;
    return whole.dump(2) + "\n";
}

}  // namespace canproof::host
