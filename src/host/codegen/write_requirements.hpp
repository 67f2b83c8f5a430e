// SPDX-License-Identifier: Apache-2.0
// Requirements as C++ types.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns a C++ type for each valid (not retired) id of a device, or of the shared rules, so that code and tests can
/// name the id.
std::string write_requirements(const Register& content, const Part& part);

}  // namespace canproof::host
