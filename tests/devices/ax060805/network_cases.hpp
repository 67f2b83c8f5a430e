// SPDX-License-Identifier: Apache-2.0
// Test fixture that the network tests of the AX060805 share, node 127.
#pragma once

#include "tests/devices/ax060805/inclinometer_bench.hpp"

namespace canproof::test {

class Ax060805Network : public InclinometerTest {
  protected:
    void store_all() { write(0x1010, 1, 0x65766173, 4); }
    void configure_lss() { send("7E5#0401"); }
};

}  // namespace canproof::test
