// SPDX-License-Identifier: Apache-2.0
// Tests the unlatch input of the relay of the AX130751, which the tests set up by SDO (manual, 1.4).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/relay_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST_F(Ax130751Relay, UnlatchingFollowsItsStateMachine) {
    verifies<req::AOR_RELAY_005, req::AOR_RELAY_020, req::AOR_RELAY_007>();
    set8(0x2242, 1, 3);
    connect(0x2270, 1);
    EXPECT_TRUE(control(1));
    extra(1, 100);
    EXPECT_FALSE(relay_on());
    extra(1, 0);
    EXPECT_FALSE(relay_on()) << "the control is still ON";
    EXPECT_FALSE(control(0));
    EXPECT_TRUE(control(1)) << "works as before";
    extra(1, 100);
    control(0);
    EXPECT_FALSE(control(1)) << "deaf while unlatched";
    extra(1, 0);
    EXPECT_FALSE(relay_on());
    set8(0x2242, 1, 1);
    extra(1, 100);
    EXPECT_TRUE(relay_on()) << "no effect on normal logic";
}

TEST_F(Ax130751Relay, UnlatchingPutsARelayWithInverseLatchOn) {
    verifies<req::AOR_RELAY_006, req::AOR_RELAY_021>();
    control(1);
    set8(0x2242, 1, 4);
    connect(0x2270, 1);
    EXPECT_TRUE(relay_on());
    EXPECT_FALSE(control(0));
    extra(1, 100);
    EXPECT_TRUE(relay_on());
    extra(1, 0);
    EXPECT_TRUE(relay_on());
    EXPECT_TRUE(control(1));
    EXPECT_FALSE(control(0));
}

// Section 1.4: the delays are those of control and enable.
TEST_F(Ax130751Relay, UnlatchingPutsALatchedRelayOffWithoutItsDelay) {
    verifies<req::AOR_RELAY_005, req::AOR_RELAY_014, req::AOR_RELAY_020>();
    set8(0x2242, 1, 3);
    connect(0x2270, 1);
    EXPECT_TRUE(control(1));
    set32(0x22A1, 1, 30);
    set32(0x22A2, 1, 20);
    set8(0x22A0, 1, 1);
    extra(1, 100);
    EXPECT_FALSE(relay_on());
    extra(1, 0);
    control(0);
    EXPECT_FALSE(control(1));
    pass(29);
    EXPECT_FALSE(relay_on()) << "the ON delay applies to the control";
    extra(1, 100);  // would have been the end of the delay
    pass(50);
    EXPECT_FALSE(relay_on());
}

TEST_F(Ax130751Relay, UnlatchingPutsARelayWithInverseLatchOnAfterItsOnDelay) {
    verifies<req::AOR_RELAY_006, req::AOR_RELAY_012>();
    control(1);
    set8(0x2242, 1, 4);
    connect(0x2270, 1);
    EXPECT_FALSE(control(0));
    set32(0x22A1, 1, 30);
    set8(0x22A0, 1, 1);
    extra(1, 100);
    pass(29);
    EXPECT_FALSE(relay_on());
    pass(1);
    EXPECT_TRUE(relay_on());
}

TEST_F(Ax130751Relay, OverrideAndKeepPrecedeTheUnlatchInput) {
    verifies<req::AOR_RELAY_005, req::AOR_RELAY_010, req::AOR_RELAY_027>();
    set8(0x2242, 1, 3);
    connect(0x2270, 1);
    connect(0x2290, 2);
    connect(0x2280, 3);
    set8(0x2293, 1, 1);  // override state ON
    set8(0x2282, 1, 5);  // response 5: enabled while the input is OFF; otherwise the relay keeps its state
    pass(1);
    EXPECT_TRUE(control(1));
    extra(3, 100);
    extra(1, 100);
    EXPECT_TRUE(relay_on()) << "kept";
    extra(3, 0);
    EXPECT_FALSE(relay_on()) << "the control drives the relay again: unlatched";
    extra(2, 100);
    EXPECT_TRUE(relay_on()) << "overridden";
    extra(2, 0);
    EXPECT_FALSE(relay_on());
}

}  // namespace canproof::test
