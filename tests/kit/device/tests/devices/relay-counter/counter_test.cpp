// SPDX-License-Identifier: Apache-2.0
// Tests the counter (section 6 of the data sheet).
#include "generated/relay_counter/requirements.hpp"
#include "tests/devices/relay-counter/relay_counter_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST_F(RelayCounterTest, CounterCountsEachChangeOfTheInputFromOffToOn) {
    verifies<req::RC_COUNT_001, req::RC_S_COUNT_INPUT, req::RC_OD_2010>();
    EXPECT_FALSE(relay_counter::Inputs{}.count_input);
    EXPECT_EQ(read(0x2010).value, 0U);
    for (const bool input : {true, true, false, true}) {
        inputs.count_input = input;
        set_inputs();
    }
    EXPECT_EQ(read(0x2010).value, 2U);
}

TEST_F(RelayCounterTest, CounterStartsFromZeroAfterResetNode) {
    verifies<req::RC_COUNT_001>();
    inputs.count_input = true;
    set_inputs();
    EXPECT_EQ(read(0x2010).value, 1U);
    send("000#8105");
    pass(10);
    EXPECT_EQ(read(0x2010).value, 0U);
    set_inputs();
    EXPECT_EQ(read(0x2010).value, 0U);
}

TEST_F(RelayCounterTest, InputThatIsOnAtPowerOnIsNotCounted) {
    verifies<req::RC_COUNT_001>();
    inputs.count_input = true;
    power_on();
    EXPECT_EQ(read(0x2010).value, 0U);
}

}  // namespace canproof::test
