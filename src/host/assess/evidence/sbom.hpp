// The parts of the program for tools that read CycloneDX.
#pragma once

#include <string>

#include "host/assess/evidence/provenance.hpp"

namespace canproof::host {

/// CycloneDX 1.5: this program and the Debian packages that it is built from.
std::string write_sbom(const Provenance& provenance);

}  // namespace canproof::host
