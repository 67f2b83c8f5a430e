// SPDX-License-Identifier: Apache-2.0
// The error matrix of a device: its errors with codes, lamps and requirements.
#pragma once

#include "host/assess/documents/analysis.hpp"
#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns each error of the device with its emergency code, its lamps (LEDs), and the requirements that name the code.
Document error_matrix(const Register& content, const Part& part, const Analysis& analysis);

}  // namespace canproof::host
