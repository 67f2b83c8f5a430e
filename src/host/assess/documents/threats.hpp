// SPDX-License-Identifier: Apache-2.0
// The threats to the services of a device.
#pragma once

#include "host/assess/documents/analysis.hpp"
#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the threats to the services of the device in the order of the analysis, each with its foundational
/// requirement of IEC 62443.
Document threats(const Part& part, const Analysis& analysis);

}  // namespace canproof::host
