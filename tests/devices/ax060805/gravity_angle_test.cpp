// SPDX-License-Identifier: Apache-2.0
// Tests the gravity angle of an AX060805 that is not mounted level (manual, 2.1.2, 2.1.4, 3.3).
#include <gtest/gtest.h>

#include <cmath>

#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr double radians = 3.14159265358979323846 / 180.0;

/// Test fixture with a unit that is mounted with pitch 30 degrees: 2200h (Initial Pitch Angle) is 30.
class Ax060805GravityAngle : public InclinometerTest {
  protected:
    void SetUp() override {
        InclinometerTest::SetUp();
        switch_filter_off();
        angle_digits(100);
        write_real(0x2200, 0, 30.0F);
    }
    /// Returns the gravity angle when gravity has these components in the machine's frame. In the unit's frame, turned
    /// by the pitch of 30 degrees about Y, they are (x cos 30 - z sin 30, y, x sin 30 + z cos 30). The sensed
    /// acceleration is gravity reversed.
    int in_machine_frame(double x, double y, double z) {
        const double sine = std::sin(30.0 * radians);
        const double cosine = std::cos(30.0 * radians);
        return angles_at(z * sine - x * cosine, -y, -x * sine - z * cosine)[2];
    }
};

}  // namespace

TEST_F(Ax060805GravityAngle, TurnOfAMachineAboutItsOwnZAxisKeepsTheGravityAngle) {
    verifies<req::INC_ANGLE_015>();
    // A tilt of 90 degrees is left out: the rounding error of its cosine, 0, would decide the sign of the pitch. This
    // test does not check the pitch.
    for (const double tilt : {0.0, 20.0, 89.0, 135.0, 180.0}) {
        for (double turn = 0.0; turn < 360.0; turn += 15.0) {
            const double across = std::sin(tilt * radians);
            EXPECT_NEAR(in_machine_frame(across * std::cos(turn * radians), across * std::sin(turn * radians),
                                         std::cos(tilt * radians)),
                        tilt * 100.0, 1.0)
                << "turned by " << turn;
        }
    }
}

/// The unit's own Z axis is 30 degrees from the vertical in each of the two positions, which differ by half a turn
/// about this axis. The machine's Z axis is 30 degrees from that of the unit: 30 + 30 = 60, or 30 - 30 = 0 degrees.
TEST_F(Ax060805GravityAngle, GravityAngleIsThatOfTheMachineNotThatOfTheUnit) {
    verifies<req::INC_INSTALL_002>();
    EXPECT_NEAR(angles_at(-0.5, 0.0, -0.8660254)[2], 6000, 1);
    EXPECT_NEAR(angles_at(0.5, 0.0, -0.8660254)[2], 0, 1);
}

/// The mean of the gravity angles 180 and 0 degrees is 90. The mean of pitch 90 and -90 degrees as Euler angles is 0.
TEST_F(Ax060805GravityAngle, MeanOfAnglesHalfATurnApartStaysInTheRangeOfTheAngle) {
    verifies<req::INC_AVG_018, req::INC_RANGE_007>();
    write_real(0x2200, 0, 0.0F);
    use_euler_angles();
    write(0x2052, 0, 5, 2);  // a filter sample every 5 ms
    write(0x2051, 1, 3, 2);
    write(0x2051, 3, 3, 2);
    feel(0.0, 0.0, 1.0);
    pass(5);
    write(0x2050, 3, 1, 1);  // moving average
    EXPECT_EQ(gravity_angle(), 18000);
    EXPECT_EQ(angles_at(0.0, 0.0, -1.0)[2], 9000);
    EXPECT_EQ(angles_at(0.0, 0.0, -1.0)[2], 6000);
    EXPECT_EQ(angles_at(0.0, 0.0, 1.0)[2], 6000);
    feel(1.0, 0.0, 0.0);
    pass(5);
    write(0x2050, 1, 1, 1);
    EXPECT_EQ(pitch(), 9000);
    EXPECT_EQ(angles_at(-1.0, 0.0, 0.0)[0], 0);
    EXPECT_EQ(angles_at(-1.0, 0.0, 0.0)[0], -3000);
}

/// Euler rolls of 170 and 200 degrees have the mean 185, that is, -175 degrees: this angle covers a whole turn.
TEST_F(Ax060805GravityAngle, MeanOfEulerRollsOnBothSidesOf180IsBetweenThem) {
    verifies<req::INC_AVG_018>();
    write_real(0x2200, 0, 0.0F);
    use_euler_angles();
    write(0x2052, 0, 5, 2);  // a filter sample every 5 ms
    write(0x2051, 2, 3, 2);
    feel(0.0, -std::sin(170.0 * radians), -std::cos(170.0 * radians));
    pass(5);
    write(0x2050, 2, 1, 1);  // moving average
    EXPECT_NEAR(angles_at(0.0, -std::sin(200.0 * radians), -std::cos(200.0 * radians))[1], -17500, 1);
}

}  // namespace canproof::test
