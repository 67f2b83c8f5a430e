// The register that the program was built with.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

const Register& built_in_register();
/// By its name or one of its part numbers. Throws InputError when there is no such device.
const Part& device_named(const std::string& name);

}  // namespace canproof::host
