// SPDX-License-Identifier: Apache-2.0
// Tests which additional filters of an AX060805 start again at a write (manual, 4.3.10 to 4.3.12).
#include <gtest/gtest.h>

#include <vector>

#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// Test fixture with a moving average of 100 samples for each angle. A level unit has just been turned to pitch 30 and
/// Euler roll 40 degrees, so that the averages are still near 0.
class Ax060805FilterRestart : public InclinometerTest {
  protected:
    void turn_after_rest() {
        turn(0.0, 0.0);
        power_on();
        switch_filter_off();
        angle_digits(100);
        for (std::uint8_t sub = 1; sub <= 3; ++sub) {
            write(0x2051, sub, 100, 2);
            write(0x2050, sub, 1, 1);
        }
        pass(500);
        turn(30.0, 40.0);
        pass(10);
        for (const int angle : angles()) {
            EXPECT_LT(angle, 500);
        }
    }
    /// In hundredths of a degree: pitch 30, tilt roll asin(cos 30 sin 40) = 33.83, gravity angle acos(cos 30 cos 40) =
    /// 48.44.
    const std::vector<int> turned{3000, 3383, 4844};
};

}  // namespace

TEST_F(Ax060805FilterRestart, NewFilterRate2052hRestartsTheFiltersOfAllThreeAngles) {
    verifies<req::INC_AVG_015>();
    turn_after_rest();
    write(0x2052, 0, 20, 2);
    EXPECT_EQ(angles(), turned);
}

TEST_F(Ax060805FilterRestart, NewFilterTypeOrConstantRestartsTheFilterOfItsAngleOnly) {
    verifies<req::INC_AVG_012>();
    for (const bool type : {false, true}) {
        for (std::size_t angle = 0; angle < 3; ++angle) {
            turn_after_rest();
            const std::vector<int> before = angles();
            const auto sub = static_cast<std::uint8_t>(angle + 1);
            write(type ? 0x2050 : 0x2051, sub, type ? 2 : 90, type ? 1 : 2);
            std::vector<int> expected = before;
            expected[angle] = turned[angle];
            EXPECT_EQ(angles(), expected) << (type ? "2050h:" : "2051h:") << angle + 1;
        }
    }
}

}  // namespace canproof::test
