// SPDX-License-Identifier: Apache-2.0
// The description of the conformance slave from which its devices are made.
#pragma once

#include "host/sim/devices/generic_device.hpp"

namespace canproof::test {

/// Returns the description: from its register here (slave/slave.cpp), or from its generated tables on the
/// microcontroller (src/target/tests/slave.cpp).
const host::GenericDescription& slave();

}  // namespace canproof::test
