// SPDX-License-Identifier: Apache-2.0
// The draft of a software failure mode and effects analysis (FMEA).
#pragma once

#include "host/assess/documents/analysis.hpp"
#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns detection, reaction and emergency code for each failure mode of the input signals, messages and memory, and
/// the failures of the outputs from the hazards.
Document failure_modes(const Register& content, const Part& part, const Analysis& analysis);

}  // namespace canproof::host
