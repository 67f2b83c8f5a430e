// The signals between the firmware and what drives it.
#pragma once

#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Signals with type, unit, range and source; factory data; what the driver has to do.
Document hardware_interface(const Part& part);

}  // namespace canproof::host
