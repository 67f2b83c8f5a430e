// The audit as JSON, for other programs.
#pragma once

#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/audit_filter.hpp"

namespace canproof::host {

/// `parts`, each with its `items`, `sections` (normative ones), `statements`, `gaps` and `suspects`; `counts_by` says
/// whether the manual is covered by `statement` or by `section`. With a filter the items and statements that pass it,
/// and nothing else of a part. `findings` are sentences about the whole by their name: orphans, regressions. An item
/// names its code and tests by `evidence`, whose `tests` and `failed` say how many ran.
std::string write_audit_json(const Register& content, const std::vector<PartAudit>& audits, const AuditFilter& filter,
                             const std::map<std::string, std::vector<std::string>>& findings,
                             const Evidence& evidence = {});

}  // namespace canproof::host
