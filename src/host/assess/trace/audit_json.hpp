// An audit for programs.
#pragma once

#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/audit_filter.hpp"

namespace canproof::host {

/// JSON: of each part its items (those that pass the filter) with kind, sources, code, tests, decisions and state, its
/// gaps and suspects; then orphans, and how many tests ran and failed.
std::string audit_json(const std::vector<PartAudit>& audits, const Evidence& evidence, const AuditFilter& filter);

}  // namespace canproof::host
