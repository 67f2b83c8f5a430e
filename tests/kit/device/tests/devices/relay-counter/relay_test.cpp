// The relays (section 4).
#include "devices/relay-counter/firmware/relay.hpp"

#include "generated/relay_counter/requirements.hpp"
#include "generated/relay_counter/tables.hpp"
#include "tests/devices/relay-counter/relay_counter_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST(RelayCounterRelay, FollowsItsCommandInOperationalOnly) {
    verifies<req::RC_T_RELAY>();
    EXPECT_TRUE(relay_counter::contact_is_closed(1, NmtState::operational));
    EXPECT_FALSE(relay_counter::contact_is_closed(0, NmtState::operational));
    for (const NmtState state : {NmtState::initialising, NmtState::pre_operational, NmtState::stopped}) {
        EXPECT_FALSE(relay_counter::contact_is_closed(0, state));
        EXPECT_FALSE(relay_counter::contact_is_closed(1, state));
    }
}

TEST(RelayCounterRelay, HasARowForEachCommandAndState) {
    verifies<req::RC_T_RELAY>();
    namespace table = generated::relay_counter::relay_contact;
    for (const auto state :
         {NmtState::initialising, NmtState::pre_operational, NmtState::operational, NmtState::stopped}) {
        EXPECT_NE(table::find(0, state), nullptr);
        EXPECT_NE(table::find(1, state), nullptr);
        EXPECT_EQ(table::find(2, state), nullptr);
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
