// Threats to the services of a device.
#pragma once

#include "host/assess/documents/analysis.hpp"
#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Threats to each service that the device has, sorted by the foundational requirements of IEC 62443.
Document threats(const Part& part, const Analysis& analysis);

}  // namespace canproof::host
