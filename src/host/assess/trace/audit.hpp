// SPDX-License-Identifier: Apache-2.0
// The audit. It follows each manual section and statement to requirement, decision, table or object, code, test and
// verdict, and reports missing links.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/assess/trace/evidence.hpp"
#include "host/assess/trace/section_index.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// One item of the register with its evidence.
struct AuditedItem {
    const Item* item{nullptr};
    std::string word;                    ///< requirement, object, table …
    std::string kind;                    ///< kind of a requirement: functional, range …
    std::vector<std::string> demanded;   ///< kinds of verification that the register requires
    std::vector<std::string> missing;    ///< demanded kinds without a passed run
    bool failed{false};                  ///< a test that claims the item has failed
    bool without_code{false};            ///< no code in src/ implements it or names the code generated from it
    std::vector<std::string> decisions;  ///< ids of decisions that affect it
    std::string suspect;  ///< reason why its code and tests may no longer match it; empty when its review is up to date

    bool open() const { return failed || without_code || !missing.empty(); }
    /// Returns failed, open, suspect or shown.
    std::string status() const;
};

struct AuditedSection {
    const Section* section{nullptr};
    std::vector<std::string> covered_by;  ///< ids of items that have it as their source
    bool covered{false};                  ///< it has a statement; in a manual without statements, an item has it as its
                                          ///< source
};

/// A statement of the manual with its evidence.
struct AuditedStatement {
    const Statement* statement{nullptr};
    std::string id;      ///< AX130751:1.3/2
    std::string status;  ///< worst status of its items: failed, open, suspect or shown; without items: open, or
                         ///< explained with a reason

    bool open() const { return status != "shown" && status != "explained"; }
};

struct PartAudit {
    const Part* part{nullptr};
    std::vector<AuditedItem> items;
    std::vector<AuditedSection> sections;      ///< normative sections
    std::vector<AuditedStatement> statements;  ///< statements of the manual in the register's order
    std::vector<std::string> gaps;             ///< one sentence each
    std::vector<std::string> suspects;         ///< one sentence each
};

/// Audits one part: a device with its manual, or the shared part, which has no manual of its own. `part` belongs to
/// `content` and is not a shared part that comes with an installed canproof.
PartAudit audit_part(const Register& content, const Part& part, const Evidence& evidence);
/// Audits all parts of the project in the register's order. Shared rules that come with an installed canproof are left
/// out, because canproof itself proves them.
std::vector<PartAudit> audit_all(const Register& content, const Evidence& evidence);

/// Returns the firmware's code and tests without a requirement, and badly placed links, one sentence each. Tests of the
/// tools around the firmware need no requirement.
std::vector<std::string> orphans(const Evidence& evidence);

/// Returns the places at which code implements an item or names the code generated from it.
std::vector<std::string> code_of(const std::string& id, const Evidence& evidence);

}  // namespace canproof::host
