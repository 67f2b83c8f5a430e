// SPDX-License-Identifier: Apache-2.0
// Requirements as C++ types.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns each id of the part as a type that code and tests name.
std::string write_requirements(const Register& content, const Part& part);

}  // namespace canproof::host
