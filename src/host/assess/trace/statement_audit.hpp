// SPDX-License-Identifier: Apache-2.0
// The audit of a manual's statements: which items cover each statement, and whether passed tests show these items.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"

namespace canproof::host {

/// Returns, for each section of the manual, the positions of the section's statements in `statements`. Leaves out
/// sections without statements. A statement about an object belongs to the section that describes the object.
std::map<std::string, std::vector<std::size_t>> by_section(const Manual& manual,
                                                           const std::vector<AuditedStatement>& statements);

/// Adds the statements of each device's manual to the device's audit, and their gaps: statements with neither an item
/// nor a reason, and normative sections without a statement. Does nothing for a manual without statements. `audits`
/// must contain the audited items of all devices and of the shared rules.
void audit_statements(const Register& content, std::vector<PartAudit>& audits);

/// Returns the number of statements of an audit for each status.
std::map<std::string, std::size_t> count_statements(const PartAudit& audit);

}  // namespace canproof::host
