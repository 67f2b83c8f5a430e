// SPDX-License-Identifier: Apache-2.0
// The slave of the tests of transmit PDOs: the conformance slave, node 5. It has
//   TPDO1 on 185h, type 254: 2001h:1, 2001h:2 (UNSIGNED8);  TPDO2 on 285h, type 1: 2101h:1…4 (INTEGER16);
//   TPDO3 on 385h and TPDO4 on 485h: not valid. A change of value is an event.
#pragma once

#include "tests/support/exchange.hpp"
#include "tests/support/slave_bench.hpp"

namespace canproof::test {

class Tpdo : public testing::Test, public SlaveBench {
  protected:
    void start() { EXPECT_EQ(send("000#0105"), (Frames{"185#0000"})); }
    /// Sets the transmission type of TPDO1. The node must be in pre-operational.
    void set_type(const std::string& type) {
        EXPECT_EQ(send("605#2F001802" + type + "000000"), (Frames{"585#6000180200000000"}));
    }
    /// Switches TPDO2 off, so that a SYNC triggers TPDO1 only.
    void silence_tpdo2() { EXPECT_EQ(send("605#2301180185020080"), (Frames{"585#6001180100000000"})); }
    /// Makes TPDO1 not valid, sets 1800h:3 (inhibit time), and makes it valid again.
    void set_inhibit_time(const std::string& value) {
        talk(*this, {
                        {"605#2300180185010080", {"585#6000180100000000"}},
                        {"605#2B001803" + value + "0000", {"585#6000180300000000"}},
                        {"605#2300180185010000", {"585#6000180100000000"}},
                    });
    }
    void map_tpdo3(const std::vector<std::string>& entries) {
        send("605#2302180185030080");
        send("605#2F021A0000000000");
        int line = 0;
        for (const auto& entry : entries) {
            ++line;
            const std::string object = "021A0" + std::to_string(line);
            EXPECT_EQ(send("605#23" + object + entry), (Frames{"585#60" + object + "00000000"}));
        }
        send("605#2F021A000" + std::to_string(line) + "000000");
        EXPECT_EQ(send("605#2302180185030000"), (Frames{"585#6002180100000000"}));
    }
};

}  // namespace canproof::test
