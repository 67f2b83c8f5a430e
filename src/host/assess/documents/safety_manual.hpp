// SPDX-License-Identifier: Apache-2.0
// The safety manual for the integrator of the device.
#pragma once

#include "host/assess/documents/analysis.hpp"
#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the chapters: scope, hazards, duties of the integrator with the conditions of use, limits, decisions for the
/// integrator, and reactions to faults. Lists only those shared decisions that concern the device.
Document safety_manual(const Register& content, const Part& part, const Analysis& analysis);

}  // namespace canproof::host
