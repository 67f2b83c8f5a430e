// SPDX-License-Identifier: Apache-2.0
// Writes an electronic data sheet (CiA 306) from the requirements register.
#pragma once

#include <string>

#include "host/datasheet/eds_values.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the text of the sheet, with CRLF line breaks.
std::string write_eds(const Register& content, const Part& part, Reals reals = Reals::without_limits);

}  // namespace canproof::host
