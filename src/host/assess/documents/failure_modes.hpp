// SPDX-License-Identifier: Apache-2.0
// The draft of a software FMEA.
#pragma once

#include "host/assess/documents/analysis.hpp"
#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns detection, reaction and emergency code for each failure mode of the signals and messages.
Document failure_modes(const Register& content, const Part& part, const Analysis& analysis);

}  // namespace canproof::host
