// SPDX-License-Identifier: Apache-2.0
// The requirements register for tools that read ReqIF.
#pragma once

#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns ReqIF 1.2. Items, decisions and normative sections are SpecObjects; an item has its code, tests and review.
/// SpecRelations connect a decision with the affected items, and an item with the sections that it covers. Each part (a
/// device, or the shared rules) has its own specification.
std::string write_reqif(const Register& content, const std::vector<PartAudit>& audits, const Evidence& evidence);

}  // namespace canproof::host
