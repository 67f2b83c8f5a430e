// SPDX-License-Identifier: Apache-2.0
#include "host/assess/trace/audit_filter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "host/base/input_error.hpp"
#include "host/register/refs.hpp"

namespace canproof::host {

namespace {

/// Returns whether the manual has the section `ref` or a section below it.
bool has_section(const Manual& manual, const std::string& ref) {
    return std::any_of(manual.sections.begin(), manual.sections.end(),
                       [&](const Section& section) { return is_within(section.ref, ref); });
}

/// Returns the section `ref` with the key of its manual before it: `AX130751:1.3` for `1.3`.
std::string with_key(const std::string& ref, const Register& content, const std::vector<PartAudit>& audits) {
    std::vector<std::string> found;
    for (const auto& audit : audits) {
        const Manual* manual = content.manual(audit.part->info.manual);
        if (manual != nullptr && has_section(*manual, ref)) {
            found.push_back(manual->key + ":" + ref);
        }
    }
    if (found.empty()) {
        throw InputError{fmt::format(
            "no manual has a section {}; `canproof spec statements KEY` lists the sections of a manual", ref)};
    }
    if (found.size() > 1) {
        throw InputError{
            fmt::format("{} is a section of several manuals; write one of {}", ref, fmt::join(found, ", "))};
    }
    return found.front();
}

void check_section(const std::string& section, const Register& content) {
    const auto colon = section.find(':');
    const std::string key = section.substr(0, colon);
    const Manual& manual = manual_with(key, content);
    const std::string ref = section.substr(colon + 1);
    const bool is_section = !ref.empty() && ref.find_first_not_of("0123456789.") == std::string::npos;
    if (is_section && !has_section(manual, ref)) {
        throw InputError{fmt::format(
            "the manual {0} has no section {1}; `canproof spec statements {0}` lists its sections", key, ref)};
    }
}

void check_kind(const std::string& kind, const std::vector<PartAudit>& audits) {
    std::set<std::string> kinds;
    for (const auto& audit : audits) {
        for (const auto& item : audit.items) {
            kinds.insert(item.word);
            if (!item.kind.empty()) {
                kinds.insert(item.kind);
            }
        }
        if (!audit.statements.empty()) {
            kinds.insert("statement");
        }
    }
    if (kinds.count(kind) == 0) {
        throw InputError{fmt::format("no item is of the kind `{}`; the kinds are {}, condition-of-use", kind,
                                     fmt::join(kinds, ", "))};
    }
}

}  // namespace

const Manual& manual_with(const std::string& key, const Register& content) {
    const Manual* manual = content.manual(key);
    if (manual == nullptr) {
        std::vector<std::string> keys;
        for (const auto& one : content.manuals) {
            keys.push_back(one.key);
        }
        throw InputError{fmt::format("no manual has the key {}; the keys are {}", key, fmt::join(keys, ", "))};
    }
    return *manual;
}

bool passes(const AuditedItem& item, const AuditFilter& filter) {
    const auto from_section = [&](const std::string& source) {
        const std::string& wanted = filter.section;
        const auto colon = source.find(':');
        // A source can contain several places in one manual: "AX130751:1.3 Table 7".
        for (auto at = colon; at != std::string::npos; at = source.find(' ', at + 1)) {
            const std::string place = source.substr(0, colon + 1) + source.substr(at + 1);
            const char next = place.size() > wanted.size() ? place[wanted.size()] : ' ';
            if (place.rfind(wanted, 0) == 0 && (next == ' ' || next == '.' || wanted.back() == ':')) {
                return true;
            }
        }
        return false;
    };
    const auto& sources = item.item->sources;
    return (filter.section.empty() || std::any_of(sources.begin(), sources.end(), from_section)) &&
           (filter.kind.empty() || filter.kind == item.kind || filter.kind == item.word) &&
           (filter.status.empty() || filter.status == item.status());
}

bool passes(const AuditedStatement& statement, const Manual& manual, const AuditFilter& filter) {
    const Section* section = manual.describing(statement.statement->section);
    const auto is_from = [&](const std::string& ref) {
        return filter.section == manual.key + ":" || is_within(manual.key + ":" + ref, filter.section);
    };
    return (filter.section.empty() || is_from(statement.statement->section) ||
            (section != nullptr && is_from(section->ref))) &&
           (filter.kind.empty() || filter.kind == "statement") &&
           (filter.status.empty() || filter.status == statement.status);
}

AuditFilter resolved(AuditFilter filter, const Register& content, const std::vector<PartAudit>& audits) {
    if (!filter.section.empty() && filter.section.find(':') == std::string::npos) {
        filter.section = with_key(filter.section, content, audits);
    }
    if (!filter.section.empty()) {
        check_section(filter.section, content);
    }
    if (!filter.kind.empty()) {
        check_kind(filter.kind, audits);
    }
    return filter;
}

}  // namespace canproof::host
