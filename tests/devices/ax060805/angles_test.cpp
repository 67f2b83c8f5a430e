// SPDX-License-Identifier: Apache-2.0
// Angles, initial angles, Auto-Null and angle ranges of the AX060805 (manual, 2.1, 3.2 to 3.7, 4.3), node 127. Angles
// are read in hundredths of a degree, accelerations in thousandths of g.
#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax060805Angles : public InclinometerTest {
  protected:
    void SetUp() override {
        InclinometerTest::SetUp();
        switch_filter_off();
        angle_digits(100);
        acceleration_digits(1000);
    }
};

using Row = std::vector<int>;

}  // namespace

TEST_F(Ax060805Angles, LevelUnitReadsZeroAndMeasuresMinus1gOnZ) {
    verifies<req::INC_ANGLE_001, req::INC_ANGLE_006, req::INC_INSTALL_002, req::INC_S_ACCELERATION_X,
             req::INC_S_ACCELERATION_Y, req::INC_S_ACCELERATION_Z>();
    verifies<req::INC_OD_4000, req::INC_OD_4030, req::INC_OD_4040, req::INC_OD_4050>();
    EXPECT_EQ(angles(), (Row{0, 0, 0}));
    EXPECT_EQ(accelerations(), (Row{0, 0, -1000}));
    use_euler_angles();
    EXPECT_EQ(angles(), (Row{0, 0, 0}));
}

TEST_F(Ax060805Angles, AccelerationsArePositiveAlongTheirAxes) {
    verifies<req::INC_ANGLE_001, req::INC_S_ACCELERATION_X, req::INC_S_ACCELERATION_Y, req::INC_S_ACCELERATION_Z>();
    feel(0.25, -0.5, 0.75);
    pass(5);
    EXPECT_EQ(accelerations(), (Row{250, -500, 750}));
}

TEST_F(Ax060805Angles, AnglesComeFromTheReversedAcceleration) {
    verifies<req::INC_ANGLE_002, req::INC_ANGLE_003, req::INC_ANGLE_004>();
    // gx = -0.5: pitch atan2(0.5, 0.866) = 30
    EXPECT_EQ(angles_at(0.5, 0.0, -0.8660254), (Row{3000, 0, 3000}));
    // gy = 0.5: roll atan2(0.5, 0.866) = 30
    EXPECT_EQ(angles_at(0.0, -0.5, -0.8660254), (Row{0, 3000, 3000}));
}

TEST_F(Ax060805Angles, TiltAnglesAreTheDefaultAndAngleType2100hSelectsEulerAnglesAtOnce) {
    verifies<req::INC_ANGLE_009, req::INC_ANGLE_017, req::INC_ANGLE_005, req::INC_OD_2100>();
    // Gravity is (0.5, 0.5, 0.7071): tilt angles -30 and 30, Euler roll atan2(0.5, 0.7071) = 35.26, gravity angle 45.
    EXPECT_EQ(angles_at(-0.5, -0.5, -0.70710678), (Row{-3000, 3000, 4500}));
    write(0x2100, 0, 0, 1);
    EXPECT_EQ(angles(), (Row{-3000, 3526, 4500}));
    write(0x2100, 0, 1, 1);
    EXPECT_EQ(angles(), (Row{-3000, 3000, 4500}));
    EXPECT_EQ(refusal(0x2100, 0, 2, 1), "06090031");
}

TEST_F(Ax060805Angles, TiltAnglesAndEulerRollCoverTheWholeTurnAndEulerPitchHalfATurn) {
    verifies<req::INC_ANGLE_013, req::INC_ANGLE_018, req::INC_ANGLE_003, req::INC_ANGLE_005>();
    EXPECT_EQ(angles_at(0.5, 0.0, 0.8660254), (Row{15000, 18000, 15000}));
    EXPECT_EQ(angles_at(-0.5, 0.0, 0.8660254), (Row{-15000, 18000, 15000}));
    EXPECT_EQ(angles_at(0.0, 0.5, 0.8660254), (Row{18000, -15000, 15000}));
    EXPECT_EQ(angles_at(0.0, 0.0, 1.0), (Row{18000, 18000, 18000}));
    use_euler_angles();
    EXPECT_EQ(angles_at(0.5, 0.0, 0.8660254), (Row{3000, 18000, 15000}));
    EXPECT_EQ(angles_at(1.0, 0.0, 0.0)[0], 9000);
    EXPECT_EQ(angles_at(-1.0, 0.0, 0.0)[0], -9000);
}

TEST_F(Ax060805Angles, TiltAngleJumpsWhereGzChangesItsSign) {
    verifies<req::INC_ANGLE_007>();
    EXPECT_EQ(angles_at(0.5, -0.8660254, -0.0001), (Row{3000, 6000, 8999}));
    EXPECT_EQ(angles_at(0.5, -0.8660254, 0.0001), (Row{15000, 12000, 9001}));
    EXPECT_EQ(angles_at(0.5, -0.8660254, -0.0001),
              (Row{3000, 6000, 8999}));  // the first result again: there is no hysteresis
}

TEST_F(Ax060805Angles, AttitudeWithYaw90GivesTheSameAnglesAsWithYaw0) {
    verifies<req::INC_ANGLE_010>();
    const Row straight = angles_of(20.0, -50.0);
    // The tilt angles are: pitch 20, roll -asin 0.71985 = -46.04, gravity angle acos 0.60402 = 52.84.
    EXPECT_EQ(straight, (Row{2000, -4604, 5284}));
    // Yaw 90 does not turn gravity: sin 20 = 0.34202, cos 20 sin 50 = 0.71985, cos 20 cos 50 = 0.60402.
    EXPECT_EQ(angles_at(0.342020, 0.719846, -0.604023), straight);
    write(0x2100, 0, 0, 1);
    EXPECT_EQ(angles(), (Row{2000, -5000, 5284})) << "Euler angles";
}

TEST_F(Ax060805Angles, TiltRollIsMeasuredInGimbalLock) {
    verifies<req::INC_ANGLE_016>();
    angles_of(0.0, 40.0);
    EXPECT_EQ(angles_at(0.99995, -0.01, 0.0)[1], 57);  // atan2(0.01, sqrt(1)) = 0.573
}

TEST_F(Ax060805Angles, InitialAnglesConvertAnglesAndAccelerationsToTheMachineFrame) {
    verifies<req::INC_INSTALL_001, req::INC_INSTALL_002, req::INC_OD_2200, req::INC_OD_2210>();
    // In a unit mounted with pitch 30 and roll 90 on a level machine, gravity is (-0.5, 0.866, 0).
    EXPECT_EQ(angles_at(0.5, -0.8660254, 0.0), (Row{3000, 6000, 9000}));
    write_real(0x2200, 0, 30.0F);
    write_real(0x2210, 0, 90.0F);
    EXPECT_EQ(angles(), (Row{0, 0, 0}));
    EXPECT_EQ(accelerations(), (Row{0, 0, -1000}));
    // The X axis of the unit points where the forward axis of the machine would point after the pitch. So 1 g along it
    // is (cos 30, 0, -sin 30) in the machine frame.
    feel(1.0, 0.0, 0.0);
    pass(5);
    EXPECT_EQ(accelerations(), (Row{866, 0, -500}));
}

TEST_F(Ax060805Angles, InitialAnglesOutsideTheirRangesAreRefused) {
    verifies<req::INC_OD_2200, req::INC_OD_2210>();
    const auto bits = [](float value) { return bits_of(value); };
    EXPECT_EQ(refusal(0x2200, 0, bits(90.0F), 4), "");
    EXPECT_EQ(refusal(0x2200, 0, bits(90.001F), 4), "06090031");
    EXPECT_EQ(refusal(0x2200, 0, bits(-90.001F), 4), "06090032");
    EXPECT_EQ(refusal(0x2210, 0, bits(-180.0F), 4), "");
    EXPECT_EQ(refusal(0x2210, 0, bits(180.1F), 4), "06090031");
    EXPECT_EQ(refusal(0x2210, 0, bits(-180.1F), 4), "06090032");
}

TEST_F(Ax060805Angles, AutoNullTakesThePresentPositionAsLevel) {
    verifies<req::INC_INSTALL_003, req::INC_INSTALL_009, req::INC_INSTALL_004, req::INC_OD_2300>();
    angles_of(20.0, -135.0);
    write(0x2300, 0, 1, 1);
    EXPECT_EQ(read(0x2300), 0U);
    EXPECT_NEAR(real(0x2200), 20.0F, 1e-4F);
    EXPECT_NEAR(real(0x2210), -135.0F, 1e-4F);
    EXPECT_EQ(angles(), (Row{0, 0, 0}));
    pass(5);
    EXPECT_EQ(angles(), (Row{0, 0, 0}));
    EXPECT_EQ(refusal(0x2300, 0, 2, 1), "06090031");
}

TEST_F(Ax060805Angles, AutoNullUsesTheAnglesOfTheUnitItself_NotTheAnglesCorrectedByTheInstallation) {
    verifies<req::INC_INSTALL_003, req::INC_INSTALL_004>();
    angles_of(20.0, 10.0);
    write(0x2300, 0, 1, 1);
    angles_of(-35.0, 70.0);
    write(0x2300, 0, 1, 1);
    EXPECT_NEAR(real(0x2200), -35.0F, 1e-4F);
    EXPECT_NEAR(real(0x2210), 70.0F, 1e-4F);
    EXPECT_EQ(angles(), (Row{0, 0, 0}));
}

TEST_F(Ax060805Angles, Writing0ToAutoNullCommand2300hDoesNothing) {
    verifies<req::INC_INSTALL_010, req::INC_OD_2300>();
    write(0x2050, 2, 1, 1);
    angles_of(0.0, 40.0);
    pass(5);
    EXPECT_EQ(roll(), 2000);  // mean of 0 and 40
    write(0x2300, 0, 0, 1);
    EXPECT_EQ(roll(), 2000);  // writing 0 to 2300h (Auto-Null Command) does not restart the average
    angles_of(20.0, 10.0);
    write(0x2300, 0, 0, 1);
    EXPECT_EQ(real(0x2200), 0.0F);
    EXPECT_EQ(real(0x2210), 0.0F);
    EXPECT_EQ(pitch(), 2000);
}

TEST_F(Ax060805Angles, AutoNullUsesTheOutputOfTheInputFilter) {
    verifies<req::INC_INSTALL_003>();
    write(0x2002, 0, 1, 1);
    write(0x2003, 0, 1, 1);
    turn(10.0, 0.0);
    pass(5);  // after one sample the filter (1 Hz) has covered 3 % of the step
    write(0x2300, 0, 1, 1);
    EXPECT_NEAR(real(0x2200), 0.31F, 0.01F);
}

TEST_F(Ax060805Angles, AutoNullIsRefusedInGimbalLock_WithoutGravity_AndAtAnAccelerometerError) {
    verifies<req::INC_INSTALL_005>();
    const auto expect_refused = [this](const char* why) {
        EXPECT_EQ(refusal(0x2300, 0, 1, 1), "08000022") << why;
        EXPECT_EQ(real(0x2200), 7.0F) << why;
        EXPECT_EQ(real(0x2210), 8.0F) << why;
        EXPECT_EQ(read(0x2300), 0U) << why;
        EXPECT_EQ(refusal(0x2300, 0, 0, 1), "") << why;
    };
    write_real(0x2200, 0, 7.0F);
    write_real(0x2210, 0, 8.0F);
    angles_of(89.5, 30.0);
    expect_refused("gimbal lock");
    angles_at(0.0, 0.0, 0.05);
    expect_refused("weightless");
    angles_of(20.0, 20.0);
    inputs.accelerometer_fault = true;
    angles_of(10.0, 10.0);
    expect_refused("accelerometer error");
}

TEST_F(Ax060805Angles, FailedSensorKeepsItsAccelerationsWhenTheInitialAnglesChange) {
    verifies<req::INC_FV_007>();
    feel(0.25, -0.5, 0.75);
    pass(5);
    inputs.accelerometer_fault = true;
    feel(0.25, -0.5, 0.75);
    pass(5);
    write_real(0x2210, 0, 90.0F);
    pass(5);
    EXPECT_EQ(accelerations(), (Row{250, -500, 750}));
    inputs.accelerometer_fault = false;
    feel(0.25, -0.5, 0.75);
    pass(5);
    EXPECT_EQ(accelerations(), (Row{250, -750, -500})) << "rolled by 90 degrees: y = -z, z = y of the unit";
}

TEST_F(Ax060805Angles, AutoNullIsLostAtResetNodeUnlessStored) {
    verifies<req::INC_INSTALL_006, req::INC_OD_2300>();
    angles_of(20.0, 10.0);
    write(0x2300, 0, 1, 1);
    send("000#8100");
    EXPECT_EQ(real(0x2200), 0.0F);
    write(0x2300, 0, 1, 1);
    write(0x1010, 1, 0x65766173, 4);
    send("000#8100");
    EXPECT_NEAR(real(0x2200), 20.0F, 0.01F);
    EXPECT_NEAR(real(0x2210), 10.0F, 0.01F);
    EXPECT_EQ(read(0x2300), 0U);
}

TEST_F(Ax060805Angles, CalibrationCorrectsTheSensorPositionBeforeTheInitialAnglesApply) {
    verifies<req::INC_INSTALL_007, req::INC_OD_2400, req::INC_OD_2401, req::INC_INSTALL_011>();
    factory.calibration = {30.0F, 90.0F};
    power_on();
    switch_filter_off();
    angle_digits(100);
    EXPECT_EQ(angles_at(0.5, -0.8660254, 0.0), (Row{0, 0, 0}));
    EXPECT_EQ(real(0x2400), 30.0F);
    EXPECT_EQ(real(0x2401), 90.0F);
    EXPECT_EQ(refusal(0x2400, 0, 0, 4), "06010002");
    EXPECT_EQ(refusal(0x2401, 0, 0, 4), "06010002");
    // The unit is level after its calibration, so an initial roll of 10 gives the roll -10.
    write_real(0x2210, 0, 10.0F);
    EXPECT_EQ(angles(), (Row{0, -1000, 1000}));
}

TEST_F(Ax060805Angles, AdditionalFiltersRestartAtNewInitialAnglesAutoNullAndANewAngleType) {
    verifies<req::INC_INSTALL_008>();
    write(0x2050, 1, 1, 1);
    write(0x2051, 1, 100, 2);
    angles_of(20.0, 0.0);
    pass(2000);
    EXPECT_EQ(pitch(), 2000);
    write_real(0x2200, 0, 5.0F);
    EXPECT_EQ(pitch(), 1500);
    write_real(0x2210, 0, 180.0F);
    EXPECT_EQ(pitch(), 15500);  // the machine is upside down: 180 - 25 = 155 degrees
    write_real(0x2210, 0, 0.0F);
    write(0x2300, 0, 1, 1);
    EXPECT_EQ(pitch(), 0);
    write_real(0x2200, 0, 0.0F);
    angles_of(20.0, 180.0);
    pass(2000);
    EXPECT_EQ(pitch(), 16000);
    write(0x2100, 0, 0, 1);
    EXPECT_EQ(pitch(), 2000);
}

TEST_F(Ax060805Angles, AnglesAndAccelerationsAreInvertedByDataInversion2031hAnd2011h) {
    verifies<req::INC_FV_004, req::INC_FV_008, req::INC_OD_2011, req::INC_OD_2031>();
    EXPECT_EQ(angles_at(-0.5, -0.5, -0.70710678), (Row{-3000, 3000, 4500}));
    EXPECT_EQ(accelerations(), (Row{-500, -500, -707}));
    write(0x2031, 1, 1, 1);
    EXPECT_EQ(angles(), (Row{3000, 3000, 4500}));
    write(0x2031, 2, 1, 1);
    EXPECT_EQ(angles(), (Row{3000, -3000, 4500}));
    write(0x2031, 3, 1, 1);
    EXPECT_EQ(angles(), (Row{3000, -3000, -4500}));
    EXPECT_EQ(accelerations(), (Row{-500, -500, -707}));
    write(0x2011, 1, 1, 1);
    EXPECT_EQ(accelerations(), (Row{500, -500, -707}));
    write(0x2011, 2, 1, 1);
    EXPECT_EQ(accelerations(), (Row{500, 500, -707}));
    write(0x2011, 3, 1, 1);
    EXPECT_EQ(accelerations(), (Row{500, 500, 707}));
    EXPECT_EQ(angles(), (Row{3000, -3000, -4500}));
    EXPECT_EQ(refusal(0x2031, 1, 2, 1), "06090031");
    EXPECT_EQ(refusal(0x2011, 1, 2, 1), "06090031");
}

TEST_F(Ax060805Angles, ResolutionOfAnglesAndAccelerationsFollowsTheirDecimalDigits) {
    verifies<req::INC_FV_003, req::INC_OD_2010, req::INC_OD_2030>();
    angle_digits(1);
    acceleration_digits(1);
    angles_of(20.6, 0.0);
    EXPECT_EQ(pitch(), 21);
    EXPECT_EQ(accelerations(), (Row{0, 0, -1}));  // sin 20.6 = 0.352, cos 20.6 = 0.936
    write(0x2030, 1, 10, 2);
    EXPECT_EQ(pitch(), 206);
    write(0x2030, 1, 1000, 2);
    EXPECT_EQ(pitch(), 20600);
    write(0x2010, 1, 1000, 2);
    EXPECT_EQ(accelerations(), (Row{352, 0, -1}));
    for (const std::uint16_t index : std::vector<std::uint16_t>{0x2010, 0x2030}) {
        EXPECT_EQ(refusal(index, 2, 0, 2), "06090032");
        EXPECT_EQ(refusal(index, 2, 1001, 2), "06090031");
    }
}

TEST_F(Ax060805Angles, FieldValuesAreScaled_ShiftedByTheOffset_Rounded_AndSaturated) {
    verifies<req::INC_FV_001, req::INC_FV_002, req::INC_FV_005, req::INC_OD_2020, req::INC_OD_2040>();
    angle_digits(10);
    angles_of(20.04, 0.0);
    EXPECT_EQ(pitch(), 200);  // 200.4 is rounded to 200
    write_real(0x2040, 1, 0.3F);
    EXPECT_EQ(pitch(), 201);  // 200.4 + 0.3 = 200.7 is rounded to 201: the offset is added to the count
    write(0x2031, 1, 1, 1);
    EXPECT_EQ(pitch(), -200);  // -200.4 + 0.3 = -200.1 is rounded to -200
    write(0x2031, 1, 0, 1);
    write(0x2030, 1, 1000, 2);
    write_real(0x2040, 1, 20000.0F);
    EXPECT_EQ(pitch(), 32767);
    write_real(0x2040, 1, -4294967295.0F);
    EXPECT_EQ(pitch(), -32768);
    write_real(0x2040, 2, -7.0F);
    write_real(0x2040, 3, 7.0F);
    EXPECT_EQ(roll(), -7);
    EXPECT_EQ(gravity_angle(), 207);
    write_real(0x2020, 1, 10.0F);
    write_real(0x2020, 2, 20.0F);
    write_real(0x2020, 3, 30.0F);
    EXPECT_EQ(accelerations(), (Row{353, 20, -909}));  // sin 20.04 = 0.3427, cos 20.04 = 0.9395
}

TEST_F(Ax060805Angles, OffsetsRefuseInfinityNanAndValuesBeyondTheirLimits) {
    verifies<req::INC_OD_2020, req::INC_OD_2040>();
    for (const std::uint16_t index : std::vector<std::uint16_t>{0x2020, 0x2040}) {
        EXPECT_EQ(refusal(index, 1, bits_of(4294967295.0F), 4), "");
        EXPECT_EQ(refusal(index, 1, bits_of(-4294967295.0F), 4), "");
        EXPECT_EQ(refusal(index, 1, bits_of(4.3e9F), 4), "06090031");
        EXPECT_EQ(refusal(index, 1, bits_of(-4.3e9F), 4), "06090032");
        EXPECT_NE(refusal(index, 1, 0x7F800000U, 4), "");  // infinity
        EXPECT_NE(refusal(index, 1, 0x7FC00000U, 4), "");  // NaN
        EXPECT_NE(refusal(index, 1, 0xFFC00000U, 4), "");
    }
}

namespace {

class Ax060805AngleRanges : public Ax060805Angles {
  protected:
    void start_with(ax060805::AngleConfiguration range) {
        factory.range = range;
        power_on();
        switch_filter_off();
        angle_digits(10);
    }
};

}  // namespace

TEST_F(Ax060805AngleRanges, AngleRangeOfAFullTurnGivesPitchAndRollFrom0To360Degrees) {
    verifies<req::INC_RANGE_004, req::INC_RANGE_006, req::INC_RANGE_002, req::INC_RANGE_007, req::INC_T8>();
    start_with(ax060805::AngleConfiguration::full_turn);
    EXPECT_EQ(angles_of(0.0, 0.0)[2], 0);
    EXPECT_EQ(angles_of(0.0, 180.0)[2], 1800);
    EXPECT_EQ(angles_of(0.0, -90.0), (Row{0, 2700, 900}));
    EXPECT_EQ(angles_of(-30.0, 0.0), (Row{3300, 0, 300}));
    EXPECT_EQ(angles_of(30.0, 0.0), (Row{300, 0, 300}));
    write(0x2031, 1, 1, 1);
    EXPECT_EQ(angles(), (Row{-300, 0, 300}));
    EXPECT_EQ(angles_of(-30.0, 0.0), (Row{-3300, 0, 300}));  // the sign changes after the conversion to the angle range
}

TEST_F(Ax060805AngleRanges, AngleRangeOf90DegreesGivesTheDistanceFromLevel) {
    verifies<req::INC_RANGE_005, req::INC_RANGE_007, req::INC_T8>();
    start_with(ax060805::AngleConfiguration::right_angle);
    EXPECT_EQ(angles_of(0.0, 0.0)[2], 0);
    EXPECT_EQ(angles_of(0.0, 180.0)[2], 1800);
    EXPECT_EQ(angles_of(-30.0, 0.0), (Row{300, 0, 300}));
    EXPECT_EQ(angles_of(0.0, 150.0), (Row{0, 300, 1500}));
    EXPECT_EQ(angles_of(0.0, -150.0), (Row{0, 300, 1500}));
}

TEST_F(Ax060805AngleRanges, AngleRangeAsShippedIsPlusMinus180DegreesAndIsShownByNoObject) {
    verifies<req::INC_RANGE_001, req::INC_RANGE_002, req::INC_T8>();
    angle_digits(10);
    EXPECT_EQ(angles_of(0.0, -90.0), (Row{0, -900, 900}));
    EXPECT_EQ(angles_of(-30.0, 0.0), (Row{-300, 0, 300}));
    for (const std::uint16_t index : std::vector<std::uint16_t>{0x2101, 0x2110, 0x2220}) {
        EXPECT_EQ(refusal(index, 0, 0, 1), "06020000");
    }
}

TEST_F(Ax060805AngleRanges, VerticallyMountedUnitMeasuresRollOverAFullTurn) {
    verifies<req::INC_RANGE_003>();
    start_with(ax060805::AngleConfiguration::full_turn);
    use_euler_angles();
    write_real(0x2210, 0, 90.0F);  // initial roll 90: the unit is mounted on its side
    for (int roll_of_machine = 0; roll_of_machine < 360; roll_of_machine += 5) {
        const Row read_angles = angles_of(0.0, 90.0 + roll_of_machine);
        EXPECT_EQ(std::pair(read_angles[0], read_angles[1]), std::pair(0, roll_of_machine * 10));
    }
}

}  // namespace canproof::test
