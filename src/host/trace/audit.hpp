// The audit: manual section → requirement → decision → code → test → verdict, and what is missing on the way.
#pragma once

#include <string>
#include <vector>

#include "host/speccompiler/register.hpp"
#include "host/trace/evidence.hpp"

namespace canproof::host {

/// One item of the register with what shows it.
struct AuditedItem {
    const Item* item{nullptr};
    std::string word;                    ///< requirement, object, table …
    std::vector<std::string> demanded;   ///< kinds of verification that the register asks for
    std::vector<std::string> missing;    ///< those of them without a passed run
    bool failed{false};                  ///< a test that claims it has failed
    std::vector<std::string> decisions;  ///< ids of decisions that affect it
};

struct AuditedSection {
    const Section* section{nullptr};
    std::vector<std::string> covered_by;  ///< ids
};

struct PartAudit {
    const Part* part{nullptr};
    std::vector<AuditedItem> items;
    std::vector<AuditedSection> sections;  ///< normative ones
    std::vector<std::string> gaps;         ///< each a sentence
};

/// Audits one part: a device with its manual, or the shared part (which has no manual of its own).
PartAudit audit_part(const Register& content, const Part& part, const Evidence& evidence);

}  // namespace canproof::host
