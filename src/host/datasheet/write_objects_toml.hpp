// The objects of a data sheet, as a file of the register.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// [[object]] after [[object]], each with `source`: every entry as the part has it.
std::string write_objects_toml(const Part& part, const std::string& source);

}  // namespace canproof::host
