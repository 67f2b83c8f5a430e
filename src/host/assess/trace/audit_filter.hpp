// SPDX-License-Identifier: Apache-2.0
// Selects the items and statements that an audit lists.
#pragma once

#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"

namespace canproof::host {

/// A filter for the output of the audit. An empty field accepts everything.
struct AuditFilter {
    std::string section;  ///< "AX130751:1.3", or its beginning: "AX130751:1" also selects 1.3
    std::string kind;     ///< kind of a requirement, or the word of another item; `statement`: only statements
    std::string status;   ///< failed, open, suspect or shown; for a statement also `explained`
    bool empty() const { return section.empty() && kind.empty() && status.empty(); }
};

/// Returns the manual with this key. Throws InputError with the existing keys.
const Manual& manual_with(const std::string& key, const Register& content);

bool passes(const AuditedItem& item, const AuditFilter& filter);
/// Returns the same for a statement of that manual. A statement about an object also belongs to the section that
/// describes the object.
bool passes(const AuditedStatement& statement, const Manual& manual, const AuditFilter& filter);

/// Returns the filter with a complete section: the key of the manual is added when only one manual of these audits has
/// the section. Throws InputError for an unknown section, for one that several manuals have, and for a kind that no
/// item has.
AuditFilter resolved(AuditFilter filter, const Register& content, const std::vector<PartAudit>& audits);

}  // namespace canproof::host
