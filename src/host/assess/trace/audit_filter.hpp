// SPDX-License-Identifier: Apache-2.0
// Selects the items and statements that an audit lists.
#pragma once

#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"

namespace canproof::host {

/// A filter for the output of the audit. An empty field accepts everything.
struct AuditFilter {
    /// a section such as "AX130751:1.3", with all sections below it: "AX130751:1" also selects 1.3
    std::string section;
    /// kind of a requirement, or kind of another item such as `table`; `statement` selects only statements
    std::string kind;
    std::string status;  ///< failed, open, suspect or shown; for statements also explained
    bool empty() const { return section.empty() && kind.empty() && status.empty(); }
};

/// Returns the manual with this key. Throws InputError, with a list of the existing keys, when there is none.
const Manual& manual_with(const std::string& key, const Register& content);

bool passes(const AuditedItem& item, const AuditFilter& filter);
/// Returns whether a statement of `manual` passes the filter. A statement about an object also belongs to the section
/// that describes the object.
bool passes(const AuditedStatement& statement, const Manual& manual, const AuditFilter& filter);

/// Returns the filter with the complete name of its section, such as `AX130751:1.3` for `1.3`. Adds the key of the
/// manual if only one manual of these audits has the section. Throws InputError for an unknown section, for a section
/// that several manuals have, and for a kind that no item has.
AuditFilter resolved(AuditFilter filter, const Register& content, const std::vector<PartAudit>& audits);

}  // namespace canproof::host
