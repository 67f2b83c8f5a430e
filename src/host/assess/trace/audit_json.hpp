// SPDX-License-Identifier: Apache-2.0
// The audit as JSON for other programs.
#pragma once

#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/audit_filter.hpp"

namespace canproof::host {

/// Returns `parts`, each with its `items`, normative `sections`, `statements`, `gaps` and `suspects`. `counts_by` is
/// `statement` or `section`: the things of which the audit counts how many are covered. With a filter, a part contains
/// only the items and statements that pass it. `findings` contains sentences about the whole project by name: `orphans`
/// (code and tests without a requirement), `regressions` (tests that no longer notice a mutant). The numbers of tests
/// and of failed tests come from `evidence`.
std::string write_audit_json(const Register& content, const std::vector<PartAudit>& audits, const AuditFilter& filter,
                             const std::map<std::string, std::vector<std::string>>& findings,
                             const Evidence& evidence = {});

}  // namespace canproof::host
