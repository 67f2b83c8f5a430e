// SPDX-License-Identifier: Apache-2.0
// A test fixture for the receive PDOs of the conformance slave, node 5:
//   RPDO1 on 205h: 2000h:1, 2000h:2 (UNSIGNED8);  RPDO2 on 305h: 2100h:1…4 (INTEGER16);  RPDO3, RPDO4: not valid.
#pragma once

#include <string>
#include <vector>

#include "tests/support/exchange.hpp"
#include "tests/support/slave_bench.hpp"

namespace canproof::test {

/// The slave is operational and its TPDOs are disabled, so that it sends only answers to the requests of the test.
class Rpdo : public testing::Test, public SlaveBench {
  protected:
    void SetUp() override {
        talk(*this, {
                        {"605#2300180185010080", {"585#6000180100000000"}},  // 1800h:1 TPDO1 COB-ID, bit 31 (not valid)
                        {"605#2301180185020080", {"585#6001180100000000"}},
                        {"000#0105", {}},
                    });
    }
    /// Enables RPDO3 on 405h with the mapping `entries`: the values of 1602h:1, 1602h:2 and so on, least significant
    /// byte first.
    void map_rpdo3(const std::vector<std::string>& entries) {
        send("605#2302140105040080");
        send("605#2F02160000000000");
        int line = 0;
        for (const auto& entry : entries) {
            ++line;
            const std::string object = "02160" + std::to_string(line);
            EXPECT_EQ(send("605#23" + object + entry), (Frames{"585#60" + object + "00000000"}));
        }
        EXPECT_EQ(send("605#2F0216000" + std::to_string(line) + "000000"), (Frames{"585#6002160000000000"}));
        EXPECT_EQ(send("605#2302140105040000"), (Frames{"585#6002140100000000"}));
    }
};

}  // namespace canproof::test
