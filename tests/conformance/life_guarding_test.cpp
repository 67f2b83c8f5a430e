// SPDX-License-Identifier: Apache-2.0
// Tests how failed life guarding reacts to a new guard time or life time factor, and how running life guarding reacts
// to a reset (CiA 301, 7.2.8.2.2.1; CAN-CBX-AO412, 7.9.10, 7.9.11), node 3.
#include "generated/canopen/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

using LifeGuarding = CbxTest;

TEST_F(LifeGuarding, LifeGuardingErrorContinuesWhenGuardTimeOrLifeTimeFactorChanges) {
    verifies<req::CO_GUARD_006, req::CO_GUARD_007>();
    write("603#2B0C100064000000");  // 100Ch guard time: 100 ms
    write("603#2F0D100001000000");  // 100Dh life time factor: 1
    send("703#R1");
    EXPECT_EQ(pass(100), (Frames{"100:083#3081110100000000"}));
    EXPECT_EQ(send("603#2B0C1000C8000000"), (Frames{"583#600C100000000000"})) << "the error does not end";
    EXPECT_EQ(send("603#2F0D100002000000"), (Frames{"583#600D100000000000"})) << "the error does not end";
    EXPECT_EQ(send("703#R1"), (Frames{"083#0000000100000000", "703#FF"}));
}

TEST_F(LifeGuarding, RunningLifeGuardingEndsWithAReset) {
    verifies<req::CO_GUARD_002, req::CO_NMT_005, req::CO_NMT_006>();
    for (const char* reset : {"000#8103", "000#8203"}) {
        write("603#2B0C100064000000");  // 100Ch guard time: 100 ms
        write("603#2F0D100001000000");  // 100Dh life time factor: 1
        write("603#2310100173617665");  // stores both values
        EXPECT_EQ(send("703#R1"), (Frames{"703#7F"}));
        EXPECT_TRUE(pass(50).empty());
        EXPECT_EQ(send(reset), (Frames{"703#00"}));
        EXPECT_TRUE(pass(100).empty()) << "life guarding waits for the first request";
        EXPECT_EQ(send("703#R1"), (Frames{"703#7F"}));
        EXPECT_EQ(pass(100), (Frames{"100:083#3081110100000000"}));
        send("000#8103");
    }
}

}  // namespace canproof::test
