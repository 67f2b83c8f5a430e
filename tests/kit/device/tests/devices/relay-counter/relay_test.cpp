// SPDX-License-Identifier: Apache-2.0
// Tests the relays (section 5 of the data sheet).
#include "devices/relay-counter/firmware/relay.hpp"

#include "generated/relay_counter/requirements.hpp"
#include "generated/relay_counter/tables.hpp"
#include "tests/devices/relay-counter/relay_counter_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST(RelayCounterRelay, RelayFollowsItsCommandInOperationalOnly) {
    verifies<req::RC_T_RELAY>();
    EXPECT_TRUE(relay_counter::contact_is_closed(1, true));
    EXPECT_FALSE(relay_counter::contact_is_closed(0, true));
    EXPECT_FALSE(relay_counter::contact_is_closed(0, false));
    EXPECT_FALSE(relay_counter::contact_is_closed(1, false));
}

TEST(RelayCounterRelay, RelayTableHasARowForEachCommandAndState) {
    verifies<req::RC_T_RELAY>();
    namespace table = generated::relay_counter::relay_contact;
    for (const bool operational : {false, true}) {
        EXPECT_NE(table::find(0, operational), nullptr);
        EXPECT_NE(table::find(1, operational), nullptr);
        EXPECT_EQ(table::find(2, operational), nullptr);
    }
}

TEST_F(RelayCounterTest, RelaysFollowTheirCommandsAndOpenOutsideOperational) {
    verifies<req::RC_S_RELAY, req::RC_OD_2000>();
    send("000#0105");
    EXPECT_EQ(write(0x2000, 1, 1, 1), 0U);
    EXPECT_TRUE(device->outputs().relay[0]);
    EXPECT_FALSE(device->outputs().relay[1]);
    EXPECT_EQ(write(0x2000, 2, 1, 1), 0U);
    EXPECT_TRUE(device->outputs().relay[1]);
    send("000#8005");
    EXPECT_FALSE(device->outputs().relay[0]);
    EXPECT_FALSE(device->outputs().relay[1]);
    send("000#0105");
    EXPECT_TRUE(device->outputs().relay[0]);
    send("000#8105");
    pass(10);
    send("000#0105");
    EXPECT_FALSE(device->outputs().relay[0]);
}

}  // namespace canproof::test
