// SPDX-License-Identifier: Apache-2.0
// The audit as CSV tables.
#pragma once

#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

/// Returns one row for each item of the requirements register: its sources, state, code and tests.
std::string write_requirements_csv(const std::vector<PartAudit>& audits, const Evidence& evidence);
/// Returns one row for each decision.
std::string write_decisions_csv(const std::vector<PartAudit>& audits);
/// Returns one row for each statement of a manual: the statement in the project's words, and the items that cover it or
/// the reason why none does.
std::string write_statements_csv(const std::vector<PartAudit>& audits);

}  // namespace canproof::host
