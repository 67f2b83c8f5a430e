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

Json item_json(const AuditedItem& one, const Evidence& evidence) {
    return {{"id", one.item->id},
            {"word", one.word},
            {"kind", one.kind},
            {"text", one.item->text},
            {"sources", origins(*one.item)},
            {"decisions", one.decisions},
            {"code", code_of(one.item->id, evidence)},
            {"tests", tests_of(one.item->id, evidence)},
            {"missing", one.missing},
            {"suspect", one.suspect},
            {"state", one.status()}};
}

}  // namespace

std::string audit_json(const std::vector<PartAudit>& audits, const Evidence& evidence, const AuditFilter& filter) {
    Json parts = Json::array();
    for (const auto& audit : audits) {
        Json items = Json::array();
        for (const auto& one : audit.items) {
            if (passes(one, filter)) {
                items.push_back(item_json(one, evidence));
            }
        }
        parts.push_back(
            {{"name", audit.part->name}, {"items", items}, {"gaps", audit.gaps}, {"suspects", audit.suspects}});
    }
    const Json json{
        {"parts", parts}, {"orphans", orphans(evidence)}, {"tests", evidence.tests}, {"failed", evidence.failed}};
    return json.dump(2) + "\n";
}

}  // namespace canproof::host
