// SPDX-License-Identifier: Apache-2.0
// Writes an XML device description (CiA 311) from the requirements register.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

std::string write_xdd(const Register& content, const Part& part);

}  // namespace canproof::host
