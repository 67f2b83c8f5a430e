// SPDX-License-Identifier: Apache-2.0
// Assigns a service of the protocol layer to each object by its index, as CiA 301 does.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Sets `service`, `stored` and `live` of every entry. Objects outside the communication area get no service.
void assign_services(Part& part);

}  // namespace canproof::host
