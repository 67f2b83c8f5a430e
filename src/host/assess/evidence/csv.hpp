// The audit as CSV tables.
#pragma once

#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

/// A row an item of the register: sources, state, code, tests.
std::string write_requirements_csv(const std::vector<PartAudit>& audits, const Evidence& evidence);
/// A row a decision.
std::string write_decisions_csv(const std::vector<PartAudit>& audits);
/// A row a statement of a manual, in our words: what covers it, or why nothing does.
std::string write_statements_csv(const std::vector<PartAudit>& audits);

}  // namespace canproof::host
