// SPDX-License-Identifier: Apache-2.0
// The audit of the project. It follows each section and statement of a manual to its requirement, decision, table or
// object, and from there to code, test and test result. It reports every missing step.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/assess/trace/evidence.hpp"
#include "host/assess/trace/section_index.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// One item of the requirements register with its evidence.
struct AuditedItem {
    const Item* item{nullptr};
    std::string word;                   ///< kind of the item: requirement, object, table …
    std::string kind;                   ///< kind of a requirement: functional, range …; empty for other items
    std::vector<std::string> demanded;  ///< kinds of verification that the requirements register demands
    std::vector<std::string> missing;   ///< demanded kinds of verification without a passed test of that kind
    bool failed{false};                 ///< whether a test that verifies the item has failed
    /// whether the item needs code, but no code in src/ implements it or names the code generated from it
    bool without_code{false};
    std::vector<std::string> decisions;  ///< ids of the decisions that affect the item
    /// reason why the item is suspect, such as a change since its review; empty when its review is up to date
    std::string suspect;

    bool open() const { return failed || without_code || !missing.empty(); }
    /// Returns the first of these that applies: `failed` (a test failed), `open` (something is missing), `suspect`
    /// (changed since its review), `shown`.
    std::string status() const;
};

struct AuditedSection {
    const Section* section{nullptr};
    std::vector<std::string> covered_by;  ///< ids of items that name the section as their source
    /// whether the section has a statement; in a manual without statements, whether an item names it as its source
    bool covered{false};
};

/// A statement of the manual with its evidence.
struct AuditedStatement {
    const Statement* statement{nullptr};
    std::string id;  ///< key of the manual, section and number: AX130751:1.3/2
    /// worst status of the items that cover the statement: failed, open, suspect or shown; without items: explained if
    /// the statement has a reason, otherwise open
    std::string status;

    bool open() const { return status != "shown" && status != "explained"; }
};

struct PartAudit {
    const Part* part{nullptr};
    std::vector<AuditedItem> items;
    std::vector<AuditedSection> sections;      ///< normative sections
    std::vector<AuditedStatement> statements;  ///< statements of the manual in the order of the register
    std::vector<std::string> gaps;             ///< one sentence each
    std::vector<std::string> suspects;         ///< one sentence each
};

/// Audits one part of the register: a device with its manual, or the shared rules, which have no manual of their own.
/// `part` must belong to `content` and must not be a shared part that comes with an installed canproof.
PartAudit audit_part(const Register& content, const Part& part, const Evidence& evidence);
/// Audits all parts (each device, and the shared rules) in the order of the register. Leaves out shared rules that come
/// with an installed canproof, because canproof's own audit covers them.
std::vector<PartAudit> audit_all(const Register& content, const Evidence& evidence);

/// Returns one sentence for each source or test of the firmware without a requirement, and for each badly placed link
/// (implements<> assertion). Tests of the tools around the firmware need no requirement.
std::vector<std::string> orphans(const Evidence& evidence);

/// Returns the places where code implements an item, or the shared requirement that implements it, or names the code
/// generated from it.
std::vector<std::string> code_of(const std::string& id, const Evidence& evidence);

}  // namespace canproof::host
