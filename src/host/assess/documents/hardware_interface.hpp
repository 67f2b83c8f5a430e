// SPDX-License-Identifier: Apache-2.0
// The hardware-software interface: the signals between the firmware and its drivers.
#pragma once

#include "host/assess/documents/analysis.hpp"
#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the signals with type, unit, range and source, the inputs of the simulated world apart, the requirements of
/// kind physical, and the factory data.
Document hardware_interface(const Part& part, const Analysis& analysis);

}  // namespace canproof::host
