// SPDX-License-Identifier: Apache-2.0
// Tests angles of the AX060805 in attitudes where they are undefined: the Euler roll when X is vertical, every angle
// without gravity, the sign of half a turn (manual, 2.1.3 to 2.1.6, 3.3), node 127. Angles are read in hundredths of a
// degree.
#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax060805UndefinedAngles : public InclinometerTest {
  protected:
    void SetUp() override {
        InclinometerTest::SetUp();
        switch_filter_off();
        angle_digits(100);
    }
    std::uint32_t merit() { return read(0x4020); }
};

using Row = std::vector<int>;

}  // namespace

TEST_F(Ax060805UndefinedAngles, EulerRollFollowsTheFormulaDownTo0Point01DegreesFromTheVertical) {
    verifies<req::INC_ANGLE_005, req::INC_ANGLE_016>();
    use_euler_angles();
    EXPECT_EQ(angles_of(60.0, 40.0), (Row{6000, 4000, 6748}));  // acos(cos 60 cos 40) = 67.48
    EXPECT_EQ(angles_of(89.04, -120.0)[1], -12000);             // X is 0.96 degree from the vertical
    EXPECT_EQ(angles_of(89.04, -120.0)[0], 8904);
    EXPECT_EQ(angles_of(89.9, 35.0)[1], 3500);
    EXPECT_EQ(angles_of(-89.99, 70.0)[1], 7000);
}

TEST_F(Ax060805UndefinedAngles, EulerRollAtTheVerticalIsTheLastDefinedRoll) {
    verifies<req::INC_ANGLE_008, req::INC_ANGLE_016, req::INC_K_EXACT_ANGLE>();
    use_euler_angles();
    angles_of(60.0, 40.0);
    EXPECT_EQ(angles_at(1.0, 0.0, 0.0), (Row{9000, 4000, 9000}));
    angles_of(89.5, -120.0);
    EXPECT_EQ(angles_at(-1.0, 0.0, 0.0), (Row{-9000, -12000, 9000}));
    EXPECT_EQ(angles_at(1.0, 4e-7, 0.0)[1], -12000);  // 4e-7 is 0.000023 degrees
    EXPECT_EQ(angles_at(1.0, -2e-6, 0.0)[1], 9000);   // X is 0.00011 degrees from the vertical, so the roll is computed
                                                      // again, from gy
}

/// An acceleration below a tenth of g is too small to have a direction (INC-ANGLE-011), so the device computes no roll
/// from it.
TEST_F(Ax060805UndefinedAngles, EulerRollAtTheVerticalIsTheRollBeforeAFreeFall) {
    verifies<req::INC_ANGLE_008, req::INC_ANGLE_011>();
    use_euler_angles();
    const Row before = angles_of(60.0, 40.0);
    EXPECT_EQ(angles_at(0.0, 0.05, 0.02), before);
    EXPECT_EQ(angles_at(1.0, 0.0, 0.0), (Row{9000, 4000, 9000}));
    EXPECT_EQ(angles_at(0.0, -0.05, 0.02), (Row{9000, 4000, 9000})) << "a fall from the vertical";
    EXPECT_EQ(angles_at(-1.0, 0.0, 0.0), (Row{-9000, 4000, 9000}));
}

TEST_F(Ax060805UndefinedAngles, EulerRollIsZeroWhenTheDeviceStartsAtTheVertical) {
    verifies<req::INC_ANGLE_019>();
    use_euler_angles();
    write(0x1010, 1, 0x65766173, 4);
    feel(1.0, 0.0, 0.0);
    power_on();
    EXPECT_EQ(angles(), (Row{9000, 0, 9000}));
    feel(0.99995, 0.01, 0.0);
    power_on();
    EXPECT_EQ(roll(), -9000);  // X is 0.57 degrees from the vertical: the roll is atan2(-0.01, 0)
}

TEST_F(Ax060805UndefinedAngles, NewInitialAnglesAlsoApplyToTheRollFrozenAtTheVertical) {
    verifies<req::INC_ANGLE_008, req::INC_OD_2200, req::INC_OD_2210, req::INC_ANGLE_019>();
    use_euler_angles();
    angles_of(0.0, 40.0);
    angles_at(1.0, 0.0, 0.0);
    EXPECT_EQ(angles(), (Row{9000, 4000, 9000}));
    write_real(0x2210, 0, 30.0F);
    EXPECT_EQ(angles(), (Row{9000, 1000, 9000}));  // 40 - 30 = 10; X is still vertical
    write_real(0x2210, 0, 0.0F);
    EXPECT_EQ(roll(), 4000);
    write_real(0x2200, 0, 90.0F);  // with an initial pitch of 90, the machine is level
    EXPECT_EQ(angles(), (Row{0, 0, 0}));
    write_real(0x2200, 0, 0.0F);
    EXPECT_EQ(angles(), (Row{9000, 0, 9000}));  // the roll that is kept is that of the level machine: 0
}

/// Only one direction of gravity has been measured. After a change of the initial angles, the machine's X axis is
/// within 0.00002 degrees of this direction.
TEST_F(Ax060805UndefinedAngles, EulerRollIsZeroWhenNewInitialAnglesMakeTheOnlyMeasuredDirectionVertical) {
    verifies<req::INC_ANGLE_019>();
    use_euler_angles();
    feel(0.0, 3.0e-7, -1.0);
    pass(5);
    write_real(0x2200, 0, 90.0F);
    EXPECT_EQ(roll(), 0);
    pass(5);
    EXPECT_EQ(roll(), 0);
}

TEST_F(Ax060805UndefinedAngles, TiltRollIsMeasuredAtTheVertical) {
    verifies<req::INC_ANGLE_003, req::INC_ANGLE_016>();
    angles_of(0.0, 40.0);
    EXPECT_EQ(angles_at(1.0, 0.0, 0.0), (Row{9000, 0, 9000}));
    use_euler_angles();
    EXPECT_EQ(roll(), 4000);
}

TEST_F(Ax060805UndefinedAngles, FigureOfMeritIs1WithinOneDegreeOfTheVertical) {
    verifies<req::INC_FOM_001, req::INC_T5, req::INC_K_GIMBAL_LOCK>();
    use_euler_angles();
    angles_of(88.999, 30.0);
    EXPECT_EQ(merit(), 0U);  // X is 1.001 degrees from the vertical
    angles_of(89.001, 30.0);
    EXPECT_EQ(merit(), 1U);  // X is 0.999 degrees from the vertical
    angles_of(-89.001, -150.0);
    EXPECT_EQ(merit(), 1U);
    angles_at(1.0, 0.0, 0.0);
    EXPECT_EQ(merit(), 1U);
    angles_of(0.0, 90.0);
    EXPECT_EQ(merit(), 0U);
}

TEST_F(Ax060805UndefinedAngles, FigureOfMeritOfTiltAnglesIgnoresGimbalLock) {
    verifies<req::INC_FOM_001, req::INC_OD_2100>();
    angles_of(89.5, 30.0);
    EXPECT_EQ(merit(), 0U);
    write(0x2100, 0, 0, 1);
    EXPECT_EQ(merit(), 1U);
    write(0x2100, 0, 1, 1);
    EXPECT_EQ(merit(), 0U);
}

TEST_F(Ax060805UndefinedAngles, FigureOfMeritUsesTheMachineFrame) {
    verifies<req::INC_FOM_001, req::INC_INSTALL_002>();
    use_euler_angles();
    angles_at(1.0, 0.0, 0.0);
    EXPECT_EQ(merit(), 1U);
    write_real(0x2200, 0, 90.0F);
    EXPECT_EQ(merit(), 0U);  // the machine is level
    angles_at(0.0, 0.0, -1.0);
    EXPECT_EQ(merit(), 1U);  // the sensor unit is level, so the machine's X axis is vertical
}

TEST_F(Ax060805UndefinedAngles, AnglesWithoutGravityKeepTheirLastValue) {
    verifies<req::INC_ANGLE_011, req::INC_K_LEAST_GRAVITY, req::INC_T5, req::INC_FOM_001>();
    const Row before = angles_of(30.0, 0.0);
    acceleration_digits(1000);
    EXPECT_EQ(angles_at(0.0, 0.0, 0.0), before);
    EXPECT_EQ(merit(), 1U);
    EXPECT_EQ(accelerations(), (Row{0, 0, 0}));
    EXPECT_EQ(angles_at(0.0, 0.099, 0.0), before);
    EXPECT_EQ(merit(), 1U);
    EXPECT_EQ(angles_at(0.0, -0.101, 0.0), (Row{0, 9000, 9000}));
    EXPECT_EQ(merit(), 0U);
    EXPECT_EQ(angles_at(0.0, 0.0, -0.1), (Row{0, 0, 0})) << "0.1 g is not below 0.1 g";
    EXPECT_EQ(merit(), 0U);
}

TEST_F(Ax060805UndefinedAngles, NewInitialAnglesApplyAtOnceWithoutGravity) {
    verifies<req::INC_ANGLE_011, req::INC_OD_2200, req::INC_OD_2210>();
    angles_of(30.0, 0.0);
    angles_at(0.0, 0.0, 0.0);
    write_real(0x2200, 0, 10.0F);
    EXPECT_EQ(angles(), (Row{2000, 0, 2000}));
    pass(50);
    EXPECT_EQ(angles(), (Row{2000, 0, 2000}));
    EXPECT_EQ(merit(), 1U);
    write_real(0x2200, 0, 0.0F);
    write_real(0x2210, 0, 180.0F);  // the unit is mounted upside down: pitch 180 - 30 = 150, roll 180
    EXPECT_EQ(angles(), (Row{15000, 18000, 15000}));
}

TEST_F(Ax060805UndefinedAngles, NewAngleTypeAppliesAtOnceWithoutGravity) {
    verifies<req::INC_ANGLE_011, req::INC_OD_2100>();
    // Gravity is (0.5, 0.5, 0.7071): tilt angles -30 and 30, Euler roll atan2(0.5, 0.7071) = 35.26, gravity angle 45.
    EXPECT_EQ(angles_at(-0.5, -0.5, -0.70710678), (Row{-3000, 3000, 4500}));
    angles_at(0.0, 0.0, 0.0);
    write(0x2100, 0, 0, 1);
    EXPECT_EQ(angles(), (Row{-3000, 3526, 4500}));
    write(0x2100, 0, 1, 1);
    EXPECT_EQ(angles(), (Row{-3000, 3000, 4500}));
}

TEST_F(Ax060805UndefinedAngles, AnglesAfterASensorErrorWithoutGravityFollowNewSettings) {
    verifies<req::INC_ANGLE_011, req::INC_FV_007>();
    angles_of(30.0, 0.0);
    inputs.accelerometer_fault = true;
    angles_of(30.0, 0.0);
    write_real(0x2200, 0, 10.0F);
    EXPECT_EQ(pitch(), 3000);  // while the sensor has failed, the field values do not change
    inputs.accelerometer_fault = false;
    EXPECT_EQ(angles_at(0.0, 0.0, 0.0), (Row{2000, 0, 2000}));
    EXPECT_EQ(merit(), 1U);
}

TEST_F(Ax060805UndefinedAngles, AnglesAreZeroWithoutGravitySincePowerOn) {
    verifies<req::INC_ANGLE_020>();
    feel(0.0, 0.0, 0.0);
    power_on();
    EXPECT_EQ(angles(), (Row{0, 0, 0}));
    EXPECT_EQ(merit(), 1U);
}

TEST_F(Ax060805UndefinedAngles, HalfATurnIsPlus180DegreesFromEitherSide) {
    verifies<req::INC_ANGLE_014, req::INC_K_EXACT_ANGLE>();
    for (const double across : {0.0, 1e-8, -1e-8, 4e-7, -4e-7}) {  // 4e-7 is 0.000023 degrees
        EXPECT_EQ(angles_at(across, across, 1.0), (Row{18000, 18000, 18000})) << across;
    }
    use_euler_angles();
    for (const double across : {0.0, 1e-8, -1e-8, 4e-7, -4e-7}) {
        EXPECT_EQ(angles_at(0.0, across, 1.0), (Row{0, 18000, 18000})) << across;
    }
    EXPECT_EQ(angles_at(0.0, 0.001, 1.0)[1], -17994);  // 0.057 degrees beyond half a turn
}

/// A machine on its back, up to 0.000023 degrees on either side, has +180 degrees before the inversion.
TEST_F(Ax060805UndefinedAngles, Inversion2031hOfHalfATurnGivesMinus180Degrees) {
    verifies<req::INC_ANGLE_021>();
    write(0x2031, 1, 1, 1);
    write(0x2031, 2, 1, 1);
    for (const double across : {0.0, 4e-7, -4e-7}) {
        EXPECT_EQ(angles_at(across, across, 1.0), (Row{-18000, -18000, 18000})) << across;
    }
    use_euler_angles();
    EXPECT_EQ(angles_at(0.0, 0.0, 1.0), (Row{0, -18000, 18000}));
}

TEST_F(Ax060805UndefinedAngles, MachineOnItsBackHasAllAnglesAtPlus180DegreesInEachOf30Installations) {
    verifies<req::INC_ANGLE_014, req::INC_INSTALL_004>();
    for (const double pitch_of_unit : {-80.0, -35.0, 0.0, 20.0, 66.0}) {
        for (const double roll_of_unit : {-170.0, -135.0, -10.0, 0.0, 50.0, 170.0}) {
            angles_of(pitch_of_unit, roll_of_unit);
            write(0x2300, 0, 1, 1);
            EXPECT_EQ(angles(), (Row{0, 0, 0})) << pitch_of_unit << ' ' << roll_of_unit;
            feel(-inputs.acceleration_x, -inputs.acceleration_y, -inputs.acceleration_z);
            pass(5);
            EXPECT_EQ(angles(), (Row{18000, 18000, 18000})) << pitch_of_unit << ' ' << roll_of_unit;
        }
    }
}

}  // namespace canproof::test
