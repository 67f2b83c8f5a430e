// The conformance slave as its devices are made. On the target, where no register is read, src/target/tests/support has
// a file of this name in its place, with the same rows from generated tables.
#pragma once

#include "host/sim/devices/generic_device.hpp"
#include "tests/support/slave_register.hpp"

namespace canproof::test {

inline const host::GenericDescription& slave() {
    static const host::GenericDescription description = host::describe(slave_part());
    return description;
}

}  // namespace canproof::test
