// SPDX-License-Identifier: Apache-2.0
// The slave of the LSS tests: the conformance slave, node 5, with vendor-ID 0000005Fh, product code AA020301h, revision
// 00010002h and serial number 20261121h. Requests are 7E5#…, answers 7E4#….
#pragma once

#include "tests/support/exchange.hpp"
#include "tests/support/lss_bench.hpp"

namespace canproof::test {

class Lss : public testing::Test, public LssBench {
  protected:
    void configure() { send("7E5#0401000000000000"); }
    void talk(const std::vector<Exchange>& table) { test::talk(static_cast<LssBench&>(*this), table); }
};

/// The four frames of the LSS service switch state selective, with the LSS address of the slave.
inline const std::vector<Exchange> own_address{{"7E5#405F000000000000", {}},
                                               {"7E5#41010302AA000000", {}},
                                               {"7E5#4202000100000000", {}},
                                               {"7E5#4321112620000000", {"7E4#4400000000000000"}}};

/// A slave that starts without a node-ID.
class Unconfigured : public Lss {
  protected:
    Unconfigured() : first_frames{start({255, 125000})} {}
    Frames first_frames;
};

}  // namespace canproof::test
