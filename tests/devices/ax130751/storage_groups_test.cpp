// SPDX-License-Identifier: Apache-2.0
// Tests that 1010h:2, 1010h:3 and 1010h:4 of the AX130751 each store one group of parameters (manual, 3.2.7).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Ax130751StorageGroups = Ax130751Test;

}  // namespace

TEST_F(Ax130751StorageGroups, SaveOfOneGroupStoresNoOtherGroup) {
    verifies<req::AOR_STORE_001, req::AOR_OD_1010, req::AOR_OD_1011>();
    for (const int group : {2, 3, 4}) {           // 1010h:2 communication, :3 application, :4 manufacturer
        EXPECT_EQ(write(0x1017, 0, 500, 2), "");  // 1017h (heartbeat time), a communication parameter; 0 as shipped
        EXPECT_EQ(write(0x6340, 1, 0, 1), "");    // 6340h:1 (AO Fault Mode), an application parameter; 1 as shipped
        EXPECT_EQ(write(0x5033, 0, 9, 1), "");    // 5033h (hysteresis), a manufacturer parameter; 25 as shipped
        store(group);
        power_on();
        EXPECT_EQ(read(0x1017, 0), group == 2 ? 500U : 0U) << group;
        EXPECT_EQ(read(0x6340, 1), group == 3 ? 0U : 1U) << group;
        EXPECT_EQ(read(0x5033, 0), group == 4 ? 9U : 25U) << group;
        EXPECT_EQ(write(0x1011, 1, 0x64616F6C, 4), "");  // 1011h:1 restore default parameters: "load"
        power_on();
    }
}

}  // namespace canproof::test
