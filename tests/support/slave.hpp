// The conformance slave as its devices are made.
#pragma once

#include "host/sim/devices/generic_device.hpp"

namespace canproof::test {

/// From its register here (slave/slave.cpp), from its generated tables on the microcontroller
/// (src/target/tests/slave.cpp).
const host::GenericDescription& slave();

}  // namespace canproof::test
