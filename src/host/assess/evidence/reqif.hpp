// The register for tools that read ReqIF.
#pragma once

#include <string>
#include <vector>

#include "host/assess/trace/audit.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// ReqIF 1.2: items of the register as SpecObjects, links to decisions as SpecRelations, one specification a part.
std::string write_reqif(const Register& content, const std::vector<PartAudit>& audits);

}  // namespace canproof::host
