// SPDX-License-Identifier: Apache-2.0
// Assigns a service of the protocol layer to each object by its index, as CiA 301 does.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Sets `service`, `stored` and `live` of every entry. Objects outside the communication area get no service. Sets the
/// range of sub-index 0 of 1003h pre-defined error field to the value 0, the only one that can be written.
void assign_services(Part& part);

}  // namespace canproof::host
