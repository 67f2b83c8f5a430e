// The register that the program was built with.
#pragma once

#include <string>

#include "host/speccompiler/register.hpp"

namespace canproof::host {

const Register& built_in_register();
/// Throws InputError when there is no device of that name.
const Part& device_named(const std::string& name);

}  // namespace canproof::host
