// The audit: manual section and statement → requirement → decision → table or object → code → test → verdict, and what
// is missing on the way.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/assess/trace/evidence.hpp"
#include "host/assess/trace/section_index.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// One item of the register with what shows it.
struct AuditedItem {
    const Item* item{nullptr};
    std::string word;                    ///< requirement, object, table …
    std::string kind;                    ///< of a requirement: functional, range …
    std::vector<std::string> demanded;   ///< kinds of verification that the register asks for
    std::vector<std::string> missing;    ///< those of them without a passed run
    bool failed{false};                  ///< a test that claims it has failed
    bool without_code{false};            ///< nothing in src/ implements it or names what was generated from it
    std::vector<std::string> decisions;  ///< ids of decisions that affect it
    std::string suspect;                 ///< why its code and tests may no longer fit it; empty when they were reviewed

    bool open() const { return failed || without_code || !missing.empty(); }
    /// failed, open, suspect or shown
    std::string status() const;
};

struct AuditedSection {
    const Section* section{nullptr};
    std::vector<std::string> covered_by;  ///< ids of items that have it as their source
    bool covered{false};                  ///< it has a statement; in a manual without any, an item has it as its source
};

/// A statement of the manual with what shows it.
struct AuditedStatement {
    const Statement* statement{nullptr};
    std::string id;  ///< AX130751:1.3/2
    std::string
        status;  ///< as its weakest item: failed, open, suspect or shown; open without items; explained by a reason

    bool open() const { return status != "shown" && status != "explained"; }
};

struct PartAudit {
    const Part* part{nullptr};
    std::vector<AuditedItem> items;
    std::vector<AuditedSection> sections;      ///< normative ones
    std::vector<AuditedStatement> statements;  ///< of its manual, in the register's order
    std::vector<std::string> gaps;             ///< each a sentence
    std::vector<std::string> suspects;         ///< each a sentence
};

/// Audits one part: a device with its manual, or the shared part (which has no manual of its own). `part` is one of
/// `content`, and no shared part that comes with canproof.
PartAudit audit_part(const Register& content, const Part& part, const Evidence& evidence);
/// All parts of the project, in the register's order: shared rules that come with canproof are proven there.
std::vector<PartAudit> audit_all(const Register& content, const Evidence& evidence);

/// Code of the firmware and tests of it without a requirement, and links that stand where they say little: each a
/// sentence. Tests of the tools around the firmware need none.
std::vector<std::string> orphans(const Evidence& evidence);

/// Where code implements an item or names what was generated from it.
std::vector<std::string> code_of(const std::string& id, const Evidence& evidence);

}  // namespace canproof::host
