// SPDX-License-Identifier: Apache-2.0
// The audit as JSON for other programs.
#pragma once

#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/audit_filter.hpp"

namespace canproof::host {

/// Returns a JSON object with `parts` (one for each audit), the lists of `findings`, and the numbers of tests and of
/// failed tests in `evidence`. A part has its `items`, normative `sections`, `statements`, `gaps` and `suspects`. Its
/// `counts_by` is `statement` or `section`: what the audit counts for the coverage of the manual. With a filter, a part
/// has only the items and statements that pass it. `findings` has sentences about the project by name: `orphans` (code
/// and tests without a requirement), `regressions` (items whose mutants no test notices any more).
std::string write_audit_json(const Register& content, const std::vector<PartAudit>& audits, const AuditFilter& filter,
                             const std::map<std::string, std::vector<std::string>>& findings,
                             const Evidence& evidence = {});

}  // namespace canproof::host
