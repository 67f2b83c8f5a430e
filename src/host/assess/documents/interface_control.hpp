// SPDX-License-Identifier: Apache-2.0
// The interface control document: the device's data on the bus, as shipped.
#pragma once

#include "host/assess/documents/analysis.hpp"
#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns COB-IDs, PDOs with their default mapping, services, timing, emergency codes and objects. Lists only those
/// shared requirements that concern the device.
Document interface_control(const Register& content, const Part& part, const Analysis& analysis);

}  // namespace canproof::host
