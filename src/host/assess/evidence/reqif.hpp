// The register for tools that read ReqIF.
#pragma once

#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// ReqIF 1.2: items, decisions and normative sections as SpecObjects, each item with its code, tests and review; what a
/// decision affects and what covers a section as SpecRelations; one specification a part.
std::string write_reqif(const Register& content, const std::vector<PartAudit>& audits, const Evidence& evidence);

}  // namespace canproof::host
