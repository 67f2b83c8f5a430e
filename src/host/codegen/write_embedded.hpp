// The register's files as C++, for the program to carry.
#pragma once

#include <string>

#include "host/register/spec_files.hpp"

namespace canproof::host {

std::string write_embedded(const SpecFiles& files);

}  // namespace canproof::host
