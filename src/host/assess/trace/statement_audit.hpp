// The audit of a manual's statements: which item covers each, and whether that item is shown.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"

namespace canproof::host {

/// Positions in `statements` by the section of the manual that they belong to, in its order. A statement about an
/// object belongs to the section that describes it.
std::map<std::string, std::vector<std::size_t>> by_section(const Manual& manual,
                                                           const std::vector<AuditedStatement>& statements);

/// Adds the statements of each part's manual to its audit, and their gaps: a statement that nothing covers and no
/// reason explains, and a normative section without a statement. Leaves a manual without statements alone. `audits`
/// holds the audited items of all parts of the project.
void audit_statements(const Register& content, std::vector<PartAudit>& audits);

/// How many statements of an audit have each status.
std::map<std::string, std::size_t> count_statements(const PartAudit& audit);

}  // namespace canproof::host
