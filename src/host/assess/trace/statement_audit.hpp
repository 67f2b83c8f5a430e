// SPDX-License-Identifier: Apache-2.0
// The audit of a manual's statements: which items cover each statement, and whether they are shown.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"

namespace canproof::host {

/// Returns positions in `statements` by section of the manual, in its order. A statement about an object belongs to the
/// section that describes the object.
std::map<std::string, std::vector<std::size_t>> by_section(const Manual& manual,
                                                           const std::vector<AuditedStatement>& statements);

/// Adds the statements of each part's manual to its audit, and their gaps: a statement with neither an item nor a
/// reason, and a normative section without a statement. A manual without statements stays as it is. `audits` contains
/// the audited items of all parts of the project.
void audit_statements(const Register& content, std::vector<PartAudit>& audits);

/// Returns how many statements of an audit have each status.
std::map<std::string, std::size_t> count_statements(const PartAudit& audit);

}  // namespace canproof::host
