// SPDX-License-Identifier: Apache-2.0
// The register's files as C++, embedded in the program.
#pragma once

#include <string>

#include "host/register/spec_files.hpp"

namespace canproof::host {

std::string write_embedded(const SpecFiles& files);

}  // namespace canproof::host
