// The bill of materials.
#pragma once

#include <string>

#include "host/assess/evidence/package_records.hpp"
#include "host/assess/evidence/provenance.hpp"

namespace canproof::host {

/// CycloneDX 1.6: the Debian packages that this build was made with, with scope, licence and the SHA-256 of the .deb
/// where apt knows it, and the vulnerabilities on record (VEX).
std::string write_sbom(const Provenance& provenance, const PackageRecords& records);

}  // namespace canproof::host
