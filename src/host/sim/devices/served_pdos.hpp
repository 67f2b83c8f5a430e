// SPDX-License-Identifier: Apache-2.0
// Checks that a simulated node supports all PDOs of a data sheet.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Throws InputError for PDOs of `part` that the firmware does not support; the message contains place, number and
/// index of each. Such a PDO would have objects but never any frames. The firmware supports PDO1 to PDO8 of each
/// direction (max_pdos); CiA 301 allows 512.
void check_served_pdos(const Part& part);

}  // namespace canproof::host
