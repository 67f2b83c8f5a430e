// SPDX-License-Identifier: Apache-2.0
#include "host/assess/trace/statement_audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/one_line.hpp"

namespace canproof::host {

namespace {

/// Returns the worse of two states; from worst to best: failed, open, suspect, shown.
const std::string& worse(const std::string& one, const std::string& other) {
    static const std::array<std::string, 4> order{"failed", "open", "suspect", "shown"};
    return std::find(order.begin(), order.end(), one) < std::find(order.begin(), order.end(), other) ? one : other;
}

const std::string shown = "shown";

/// Returns the state of each item and of each decision by id. The state of a decision is the worst state of the items
/// that it affects. Leaves out items that another project proves, such as shared rules of an installed canproof.
std::map<std::string, std::string> states_of(const std::vector<PartAudit>& audits) {
    std::map<std::string, std::string> states;
    for (const auto& audit : audits) {
        for (const auto& item : audit.items) {
            states[item.item->id] = item.status();
        }
    }
    for (const auto& audit : audits) {
        for (const auto& decision : audit.part->decisions) {
            std::string state = shown;
            for (const auto& id : decision.affects) {
                const auto found = states.find(id);
                state = found == states.end() ? state : worse(found->second, state);
            }
            states[decision.id] = state;
        }
    }
    return states;
}

AuditedStatement audited(const Statement& statement, const std::string& key,
                         const std::map<std::string, std::string>& states) {
    AuditedStatement made;
    made.statement = &statement;
    made.id = statement.id(key);
    made.status = !statement.reason.empty() ? "explained" : statement.covered.empty() ? "open" : shown;
    for (const auto& id : statement.covered) {
        const auto found = states.find(id);
        made.status = found == states.end() ? made.status : worse(found->second, made.status);
    }
    return made;
}

void add_gaps(const Manual& manual, PartAudit& audit) {
    for (const auto& one : audit.statements) {
        if (one.statement->is_open()) {
            audit.gaps.push_back(fmt::format("{}: no item covers the statement, and the statement has no reason ({})",
                                             one.id, brief(one.statement->text)));
        }
    }
    const auto statements = by_section(manual, audit.statements);
    for (auto& section : audit.sections) {
        section.covered = statements.count(section.section->ref) != 0;
        if (!section.covered) {
            audit.gaps.push_back(fmt::format("{}:{} ({}): the section is normative, but it has no statement",
                                             manual.key, section.section->ref, section.section->title));
        }
    }
}

}  // namespace

std::map<std::string, std::vector<std::size_t>> by_section(const Manual& manual,
                                                           const std::vector<AuditedStatement>& statements) {
    std::map<std::string, std::string> section_of;
    for (const auto& section : manual.sections) {
        for (const auto& object : section.objects) {
            section_of.emplace(object, section.ref);
        }
    }
    std::map<std::string, std::vector<std::size_t>> all;
    for (std::size_t i = 0; i < statements.size(); ++i) {
        const std::string& place = statements[i].statement->section;
        const auto described = section_of.find(place);
        all[described == section_of.end() ? place : described->second].push_back(i);
    }
    return all;
}

void audit_statements(const Register& content, std::vector<PartAudit>& audits) {
    const auto states = states_of(audits);
    for (auto& audit : audits) {
        const Manual* manual = content.manual(audit.part->info.manual);
        if (manual == nullptr || manual->statements.empty()) {
            continue;
        }
        for (const auto& statement : manual->statements) {
            audit.statements.push_back(audited(statement, manual->key, states));
        }
        add_gaps(*manual, audit);
    }
}

std::map<std::string, std::size_t> count_statements(const PartAudit& audit) {
    std::map<std::string, std::size_t> count;
    for (const auto& one : audit.statements) {
        ++count[one.status];
    }
    return count;
}

}  // namespace canproof::host
