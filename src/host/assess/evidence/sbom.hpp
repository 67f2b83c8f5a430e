// SPDX-License-Identifier: Apache-2.0
// The software bill of materials.
#pragma once

#include <string>

#include "host/assess/evidence/package_records.hpp"
#include "host/assess/evidence/provenance.hpp"

namespace canproof::host {

/// Returns CycloneDX 1.6: the Debian packages of this build with scope and licence, the SHA-256 of each .deb that apt
/// lists, and the recorded vulnerabilities (VEX).
std::string write_sbom(const Provenance& provenance, const PackageRecords& records);

}  // namespace canproof::host
