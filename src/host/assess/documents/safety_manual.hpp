// What whoever builds the device into a plant must know.
#pragma once

#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Hazards, what the integrator must keep and know, limits, reactions to faults.
Document safety_manual(const Register& content, const Part& part);

}  // namespace canproof::host
