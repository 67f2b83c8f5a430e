// device.toml as the firmware's NodeProfile.
#pragma once

#include <string>

#include "host/codegen/cpp_text.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// What device.toml says of the node, as a NodeProfile.
std::string write_profile(const Part& part, Cells cells = Cells::constant);

}  // namespace canproof::host
