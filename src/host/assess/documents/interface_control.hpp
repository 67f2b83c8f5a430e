// What the device has on the bus, as shipped.
#pragma once

#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// COB-IDs, PDOs as mapped by default, services, timing, objects.
Document interface_control(const Register& content, const Part& part);

}  // namespace canproof::host
