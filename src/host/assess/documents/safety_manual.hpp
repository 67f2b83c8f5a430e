// SPDX-License-Identifier: Apache-2.0
// The safety manual for the integrator of the device.
#pragma once

#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the chapters: scope, hazards, duties of the integrator with the conditions of use, limits, decisions for the
/// integrator, and reactions to faults.
Document safety_manual(const Register& content, const Part& part);

}  // namespace canproof::host
