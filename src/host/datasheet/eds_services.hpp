// Which service of the protocol layer guards which object: CiA 301 says so by index.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Sets service, `stored` and `live` of every entry. Objects outside the communication area are plain values.
void assign_services(Part& part);

}  // namespace canproof::host
