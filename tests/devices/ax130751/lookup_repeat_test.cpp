// SPDX-License-Identifier: Apache-2.0
// Tests 3yz2h (Auto Repeat) of a lookup table of the AX130751 that is written after all other parameters (manual,
// 1.5.4).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Ax130751LookupRepeat = Ax130751Blocks;

}  // namespace

TEST_F(Ax130751LookupRepeat, AutoRepeatWrittenLastStartsAProfileThatHasEnded) {
    verifies<req::AOR_LT_012, req::AOR_LT_013>();
    set8(0x3015, 1, 1);  // time response
    for (int point = 2; point <= 11; ++point) {
        set32(0x3016, point, 1);  // the profile takes 10 x 1 ms from Y 0 to 100
    }
    extra_as_percent(1);
    set8(0x3011, 0, 4);  // 2500h:1 (EC Extra Received Process Value)
    set8(0x3010, 0, canopen);
    extra(1, 100);
    pass(30);
    EXPECT_EQ(get16(0x3018, 0), 100) << "the end of the profile";
    set8(0x3012, 0, 1);
    pass(3);
    int below_the_end = 0;
    for (int ms = 0; ms < 10; ++ms) {
        pass(1);
        below_the_end += get16(0x3018, 0) < 100 ? 1 : 0;
    }
    EXPECT_EQ(below_the_end, 9) << "each round of 10 ms has one millisecond at Y 100";
}

}  // namespace canproof::test
