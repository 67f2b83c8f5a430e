// SPDX-License-Identifier: Apache-2.0
// Inverts a bit of the time of an AX188001's next reading. The device goes on to measure (node 127).
#include "generated/ax188001/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/changed_time.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST_F(TcsTest, VoltagesAreReadAtOnceWhenABitOfTheNextReadingTimeHasFlipped) {
    verifies<req::TCS_IN_024>();
    pass(160);
    heat(1, 100.0);
    EXPECT_NEAR(field_value(1).real(), 25.0F, 0.1F) << "the next reading is that of 165 ms";
    ASSERT_EQ(move_far_ahead(*device, Instant{165'000}), 1U);
    set_inputs();
    EXPECT_NEAR(field_value(1).real(), 100.0F, 0.1F);
    heat(1, 200.0);
    pass(164);
    EXPECT_NEAR(field_value(1).real(), 100.0F, 0.1F);
    pass(1);
    EXPECT_NEAR(field_value(1).real(), 200.0F, 0.1F) << "the reading 165 ms later";
}

}  // namespace canproof::test
