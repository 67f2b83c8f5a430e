// SPDX-License-Identifier: Apache-2.0
// Tests the ramps of the outputs of the AX130751, whose times are 2330h (AO Ramp Up) and 2331h (AO Ramp Down).
#include "devices/ax130751/firmware/ramp.hpp"

#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/blocks/at.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax130751;

// the ramp up takes 1 s for 10 units, the ramp down takes 500 ms
const RampTimes slow{10.0, milliseconds(1000), milliseconds(500)};

}  // namespace

TEST(Ramp, RisingRampCrossesTheWholeSpanInTheRampUpTime) {
    verifies<req::AOR_OUT_012, req::AOR_OUT_013, req::AOR_OUT_043>();
    Ramp ramp;
    EXPECT_DOUBLE_EQ(ramp.follow(10.0, slow, at(100)), 0.0);
    EXPECT_DOUBLE_EQ(ramp.follow(10.0, slow, at(350)), 2.5);
    EXPECT_DOUBLE_EQ(ramp.follow(10.0, slow, at(1099)), 9.99);
    EXPECT_DOUBLE_EQ(ramp.follow(10.0, slow, at(1100)), 10.0);
    EXPECT_DOUBLE_EQ(ramp.follow(10.0, slow, at(9000)), 10.0);
}

TEST(Ramp, FallingRampCrossesTheWholeSpanInTheRampDownTime) {
    verifies<req::AOR_OUT_012>();
    Ramp ramp;
    ramp.set(10.0);
    EXPECT_DOUBLE_EQ(ramp.follow(0.0, slow, at(0)), 10.0);
    EXPECT_DOUBLE_EQ(ramp.follow(0.0, slow, at(100)), 8.0);  // the ramp falls by 20 units per second
    EXPECT_DOUBLE_EQ(ramp.follow(0.0, slow, at(500)), 0.0);
}

TEST(Ramp, RampOverPartOfTheSpanTakesThatPartOfTheRampTime) {
    verifies<req::AOR_OUT_013, req::AOR_OUT_043>();
    Ramp ramp;
    ramp.set(4.0);
    EXPECT_DOUBLE_EQ(ramp.follow(5.0, slow, at(0)), 4.0);
    EXPECT_DOUBLE_EQ(ramp.follow(5.0, slow, at(50)), 4.5);
    EXPECT_DOUBLE_EQ(ramp.follow(5.0, slow, at(100)), 5.0);
}

TEST(Ramp, NewTargetIsApproachedFromThePresentValue) {
    verifies<req::AOR_OUT_012>();
    Ramp ramp;
    ramp.follow(10.0, slow, at(0));
    EXPECT_DOUBLE_EQ(ramp.follow(0.0, slow, at(400)), 4.0);
    EXPECT_DOUBLE_EQ(ramp.follow(0.0, slow, at(500)), 2.0);
    EXPECT_DOUBLE_EQ(ramp.follow(0.0, slow, at(600)), 0.0);
}

TEST(Ramp, NewRampTimesApplyAtOnce) {
    verifies<req::AOR_OUT_012>();
    Ramp ramp;
    ramp.follow(10.0, slow, at(0));
    const RampTimes fast{10.0, milliseconds(100), milliseconds(100)};
    EXPECT_DOUBLE_EQ(ramp.follow(10.0, fast, at(500)), 5.0);
    EXPECT_DOUBLE_EQ(ramp.follow(10.0, fast, at(520)), 7.0);
    const RampTimes slower_up{10.0, milliseconds(1000), milliseconds(100)};
    EXPECT_DOUBLE_EQ(ramp.follow(10.0, slower_up, at(520)), 7.0);
    EXPECT_DOUBLE_EQ(ramp.follow(10.0, slower_up, at(620)), 8.0);
    const RampTimes wider{20.0, milliseconds(1000), milliseconds(100)};
    EXPECT_DOUBLE_EQ(ramp.follow(10.0, wider, at(620)), 8.0);
    EXPECT_DOUBLE_EQ(ramp.follow(10.0, wider, at(670)), 9.0);
    ramp.follow(0.0, wider, at(670));
    const RampTimes slower_down{20.0, milliseconds(1000), milliseconds(1000)};
    EXPECT_DOUBLE_EQ(ramp.follow(0.0, slower_down, at(690)), 5.0);  // until 690 ms: 9 - 20 * 20 / 100 = 5
    EXPECT_DOUBLE_EQ(ramp.follow(0.0, slower_down, at(740)), 4.0);
}

TEST(Ramp, RampDoesNotDependOnHowOftenItIsRead) {
    verifies<req::AOR_OUT_012, req::AOR_OUT_013>();
    const RampTimes odd{10.0, milliseconds(7000),
                        milliseconds(7000)};  // 10 units in 7000 ms: a slope that is not exact in binary
    Ramp often;
    Ramp once;
    often.follow(10.0, odd, at(0));
    once.follow(10.0, odd, at(0));
    for (std::uint64_t ms = 1; ms <= 6000; ++ms) {
        often.follow(10.0, odd, at(ms));
    }
    EXPECT_EQ(once.follow(10.0, odd, at(6000)), 60000.0 / 7000.0);
    EXPECT_EQ(often.value_at(at(6000)), 60000.0 / 7000.0) << "to the last bit";
}

TEST(Ramp, RampWithZeroTimeOrZeroSpanReachesItsTargetAtOnce) {
    verifies<req::AOR_OUT_012>();
    Ramp ramp;
    EXPECT_DOUBLE_EQ(ramp.follow(7.0, {10.0, milliseconds(0), milliseconds(500)}, at(0)), 7.0);
    EXPECT_DOUBLE_EQ(ramp.follow(3.0, {0.0, milliseconds(1000), milliseconds(500)}, at(0)), 3.0);
}

TEST(Ramp, FrozenRampKeepsItsPresentValue) {
    verifies<req::AOR_OUT_009>();
    Ramp ramp;
    ramp.follow(10.0, slow, at(0));
    EXPECT_DOUBLE_EQ(ramp.hold(at(300)), 3.0);
    EXPECT_DOUBLE_EQ(ramp.hold(at(900)), 3.0);
    EXPECT_DOUBLE_EQ(ramp.value_at(at(900)), 3.0);
}

}  // namespace canproof::test
