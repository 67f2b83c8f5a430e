// Which items and statements an audit lists.
#pragma once

#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"

namespace canproof::host {

/// An empty field takes all.
struct AuditFilter {
    std::string section;  ///< "AX130751:1.3", or its beginning: "AX130751:1" takes 1.3 as well
    std::string kind;     ///< of a requirement, or the word of another item; `statement`: statements alone
    std::string status;   ///< failed, open, suspect or shown; of a statement `explained` too
    bool empty() const { return section.empty() && kind.empty() && status.empty(); }
};

/// Returns the manual with this key. Throws InputError, which names those that there are.
const Manual& manual_with(const std::string& key, const Register& content);

bool passes(const AuditedItem& item, const AuditFilter& filter);
/// The same for a statement of that manual. One about an object is in the section that describes it as well.
bool passes(const AuditedStatement& statement, const Manual& manual, const AuditFilter& filter);

/// Returns the filter with the manual's key in front of a section that only one manual of these audits has.
/// Throws InputError for a section that no manual has, or several have without a key, and for a kind that no item has.
AuditFilter resolved(AuditFilter filter, const Register& content, const std::vector<PartAudit>& audits);

}  // namespace canproof::host
