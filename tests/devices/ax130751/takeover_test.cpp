// What a block of the AX130751 keeps, and does not keep, while something else decides about it.
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Ax130751Takeover = Ax130751Test;

}  // namespace

// 1.2 Table 1: blinking begins with ON
TEST_F(Ax130751Takeover, BlinkingBeginsAnewAfterAnOverride) {
    verifies<req::AOR_DO_004>();
    write(0x6310, 1, 1020, 2);
    write(0x2241, 1, 3, 1);   // blinks while ON
    write(0x2223, 1, 40, 2);  // 40 ms
    write(0x2360, 1, 2, 1);   // overridden by 6220h:3
    write(0x2361, 1, 1, 1);
    write(0x2300, 1, 0, 2);  // to OFF
    write(0x6220, 1, 1, 1);
    start();
    pass(1);
    EXPECT_TRUE(device->outputs().out_on[0]);
    pass(10);
    write(0x6220, 3, 1, 1);
    pass(50);  // the old rhythm would be OFF from 40 ms to 80 ms
    EXPECT_FALSE(device->outputs().out_on[0]);
    write(0x6220, 3, 0, 1);
    pass(1);
    EXPECT_TRUE(device->outputs().out_on[0]);
    pass(39);
    EXPECT_TRUE(device->outputs().out_on[0]);
    pass(1);
    EXPECT_FALSE(device->outputs().out_on[0]) << "40 ms after the override";
}

// 1.5.4, 1.2: within the hysteresis as before, OFF before it was ever outside
TEST_F(Ax130751Takeover, ATableThatBecomesOneOverTimeTakesNoOldOn) {
    verifies<req::AOR_LT_010>();
    write(0x2522, 1, 100, 2);  // EC1: 0 to 100
    write(0x3011, 0, 4, 1);
    write(0x3010, 0, 1, 1);
    write(0x3015, 1, 1, 1);  // over time
    write(0x2500, 1, 100, 2);
    pass(5);
    EXPECT_NE(read(0x3018, 0), 0U) << "the profile runs";
    write(0x3015, 1, 0, 1);  // over data
    write(0x2500, 1, 0, 2);
    pass(5);
    write(0x2500, 1, 50, 2);
    pass(5);
    write(0x3015, 1, 1, 1);
    pass(5);
    EXPECT_EQ(read(0x3018, 0), 0U);
    write(0x2500, 1, 100, 2);
    pass(5);
    EXPECT_NE(read(0x3018, 0), 0U);
}

}  // namespace canproof::test
