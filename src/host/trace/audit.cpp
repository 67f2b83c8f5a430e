#include "host/trace/audit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

namespace canproof::host {

namespace {

/// Kinds of passed runs that claim an id, and whether one of them failed.
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

std::map<std::string, std::vector<std::string>> decisions_by_item(const Register& content) {
    std::map<std::string, std::vector<std::string>> all;
    for (const auto& part : content.parts) {
        for (const auto& decision : part.decisions) {
            for (const auto& id : decision.affects) {
                all[id].push_back(decision.id);
            }
        }
    }
    return all;
}

/// Whether a source such as "CBX-AO412:3.3.2 Table 11" names this section, or an object that it describes.
bool names(const std::string& source, const std::string& key, const Section& section) {
    if (source.rfind(key + ":", 0) != 0) {
        return false;
    }
    const std::string refs = " " + source.substr(key.size() + 1) + " ";
    const auto has = [&](const std::string& ref) { return refs.find(" " + ref + " ") != std::string::npos; };
    return has(section.ref) || std::any_of(section.objects.begin(), section.objects.end(), has);
}

std::vector<AuditedSection> audit_sections(const Register& content, const Manual& manual) {
    std::vector<AuditedSection> all;
    for (const auto& section : manual.sections) {
        if (!section.normative) {
            continue;
        }
        AuditedSection audited{&section, {}};
        for (const auto& part : content.parts) {
            content.for_each_item(part, [&](const Item& item, const char*) {
                const auto hit = [&](const std::string& source) { return names(source, manual.key, section); };
                if (std::any_of(item.sources.begin(), item.sources.end(), hit)) {
                    audited.covered_by.push_back(item.id);
                }
            });
        }
        all.push_back(audited);
    }
    return all;
}

}  // namespace

PartAudit audit_part(const Register& content, const Part& part, const Evidence& evidence) {
    PartAudit audit;
    audit.part = &part;
    const auto decisions = decisions_by_item(content);
    std::map<std::string, const Requirement*> requirements;
    for (const auto& requirement : part.requirements) {
        requirements[requirement.id] = &requirement;
    }
    content.for_each_item(part, [&](const Item& item, const char* word) {
        AuditedItem audited;
        audited.item = &item;
        audited.word = word;
        const auto requirement = requirements.find(item.id);
        if (requirement != requirements.end()) {
            if (!requirement->second->retired.empty()) {
                return;
            }
            audited.demanded = requirement->second->verify;
        } else {
            audited.demanded = {"test"};
        }
        const auto [passed, failed] = results_for(item.id, evidence);
        audited.failed = failed;
        for (const auto& kind : audited.demanded) {
            if (passed.count(kind) == 0) {
                audited.missing.push_back(kind);
            }
        }
        if (const auto found = decisions.find(item.id); found != decisions.end()) {
            audited.decisions = found->second;
        }
        if (failed) {
            audit.gaps.push_back(fmt::format("{}: a test that claims it has failed", item.id));
        } else if (!audited.missing.empty()) {
            audit.gaps.push_back(fmt::format("{}: no passed {}", item.id, fmt::join(audited.missing, ", no passed ")));
        }
        audit.items.push_back(audited);
    });
    if (const Manual* manual = content.manual(part.info.manual)) {
        audit.sections = audit_sections(content, *manual);
        for (const auto& section : audit.sections) {
            if (section.covered_by.empty()) {
                audit.gaps.push_back(fmt::format("{}:{} ({}): normative, and nothing has it as its source", manual->key,
                                                 section.section->ref, section.section->title));
            }
        }
    }
    return audit;
}

}  // namespace canproof::host
