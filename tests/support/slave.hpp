// SPDX-License-Identifier: Apache-2.0
// The description of the conformance slave, from which tests make devices.
#pragma once

#include "host/sim/devices/generic_device.hpp"

namespace canproof::test {

/// Returns the description of the conformance slave. On a PC it is made from the slave's requirements register
/// (slave/slave.cpp), on the microcontroller from generated tables (src/target/tests/slave.cpp).
const host::GenericDescription& slave();

}  // namespace canproof::test
