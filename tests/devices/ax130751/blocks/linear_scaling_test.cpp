// SPDX-License-Identifier: Apache-2.0
// Tests the linear scaling of the AX130751 (manual, Figures 2 and 3), and integers with decimal digits.
#include "devices/ax130751/firmware/linear_scaling.hpp"

#include <cmath>

#include "devices/ax130751/firmware/block_signal.hpp"
#include "devices/ax130751/firmware/digital_reading.hpp"
#include "generated/ax130751/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

using namespace ax130751;

TEST(LinearScaling, OutputRisesBetweenThePointsAndIsClampedOutside) {
    verifies<req::AOR_OUT_003>();
    const LinearScaling joystick{0.5, 4.5, 4.0, 20.0};  // scales 0.5…4.5 V to 4…20 mA: 4 mA per volt
    EXPECT_DOUBLE_EQ(scale(-3.0, joystick), 4.0);
    EXPECT_DOUBLE_EQ(scale(0.5, joystick), 4.0);
    EXPECT_DOUBLE_EQ(scale(1.5, joystick), 8.0);
    EXPECT_DOUBLE_EQ(scale(2.5, joystick), 12.0);
    EXPECT_DOUBLE_EQ(scale(4.5, joystick), 20.0);
    EXPECT_DOUBLE_EQ(scale(9.0, joystick), 20.0);
}

TEST(LinearScaling, OutputFallsWhenItIsLargerAtTheFirstPointThanAtTheSecond) {
    verifies<req::AOR_OUT_004>();
    const LinearScaling inverse{0.0, 100.0, 10.0, -10.0};
    EXPECT_DOUBLE_EQ(scale(-1.0, inverse), 10.0);
    EXPECT_DOUBLE_EQ(scale(25.0, inverse), 5.0);  // 10 - 20 * 25 / 100
    EXPECT_DOUBLE_EQ(scale(50.0, inverse), 0.0);
    EXPECT_DOUBLE_EQ(scale(100.0, inverse), -10.0);
    EXPECT_DOUBLE_EQ(scale(101.0, inverse), -10.0);
}

TEST(LinearScaling, EndsOfTheScalingRangeCountAsWithinIt) {
    verifies<req::AOR_OUT_006, req::AOR_OUT_031>();
    const LinearScaling scaling{1.0, 2.0, 0.0, 1.0};
    EXPECT_EQ(position_of(0.999, scaling), ScalingPosition::below);
    EXPECT_EQ(position_of(1.0, scaling), ScalingPosition::within);
    EXPECT_EQ(position_of(2.0, scaling), ScalingPosition::within);
    EXPECT_EQ(position_of(2.001, scaling), ScalingPosition::above);
}

TEST(DecimalDigits, DecimalDigitsDivideTheIntegerByPowersOfTen) {
    verifies<req::AOR_OUT_005>();
    EXPECT_DOUBLE_EQ(physical_value(1234, 0), 1234.0);
    EXPECT_DOUBLE_EQ(physical_value(1234, 1), 123.4);
    EXPECT_DOUBLE_EQ(physical_value(-1234, 2), -12.34);
    EXPECT_DOUBLE_EQ(physical_value(1234, 3), 1.234);
    EXPECT_DOUBLE_EQ(physical_value(1234, 4), 0.1234);
    EXPECT_DOUBLE_EQ(physical_value(1234, 5), 0.1234) << "more than four, which no object holds, count as four";
    EXPECT_DOUBLE_EQ(physical_value(1234, 255), 0.1234);
}

TEST(DecimalDigits, SameValueWithOneOrTwoDecimalDigitsComparesEqual) {
    verifies<req::AOR_LOGIC_001>();
    for (int tenths = -3276; tenths <= 3276; ++tenths) {
        ASSERT_EQ(physical_value(tenths, 1), physical_value(tenths * 10, 2)) << tenths;
    }
}

TEST(DecimalDigits, ProcessValueIsTheNearestIntegerWithin16Bits) {
    verifies<req::AOR_LT_039>();
    EXPECT_EQ(process_value(12.344, 2), 1234);
    EXPECT_EQ(process_value(12.345, 1), 123);
    EXPECT_EQ(process_value(0.5, 0), 1);
    EXPECT_EQ(process_value(-0.5, 0), -1);
    EXPECT_EQ(process_value(40.0, 3), 32767);
    EXPECT_EQ(process_value(-40.0, 3), -32768);
    EXPECT_EQ(process_value(3.27664, 4), 32766);
    EXPECT_EQ(process_value(3.27666, 4), 32767);
    EXPECT_EQ(process_value(3.2769, 4), 32767);
    EXPECT_EQ(process_value(1.2345, 5), 12345) << "more than four digits count as four";
    EXPECT_EQ(process_value(-327.674, 2), -32767);
    EXPECT_EQ(process_value(-327.676, 2), -32768);
    EXPECT_EQ(process_value(-327.69, 2), -32768);
    EXPECT_EQ(process_value(3.0e9, 0), 32767);  // more than an INTEGER32 can hold
    EXPECT_EQ(process_value(-3.0e9, 0), -32768);
    EXPECT_EQ(process_value(std::nan(""), 0), -32768);
}

TEST(DigitalReading, HysteresisFollowsFigure1) {
    verifies<req::AOR_DO_002>();
    DigitalReading input;
    const auto read = [&input](double value) { return input.read({value, 1.0, 4.0, SignalState::valid}); };
    EXPECT_FALSE(read(2.0)) << "never yet outside";
    EXPECT_FALSE(read(3.999));
    EXPECT_TRUE(read(4.0));
    EXPECT_TRUE(read(5.0));
    EXPECT_TRUE(read(1.001));
    EXPECT_FALSE(read(1.0));
    EXPECT_FALSE(read(2.0));
}

TEST(DigitalReading, SignalsAtTheirLimits0And1AreReadAsOffAndOn) {
    verifies<req::AOR_DO_002>();
    DigitalReading input;
    EXPECT_TRUE(input.read({1.0, 0.0, 1.0, SignalState::valid}));
    EXPECT_FALSE(input.read({0.0, 0.0, 1.0, SignalState::valid}));
}

TEST(DigitalReading, EqualLimitsGiveOffAtTheLimitAndOnAbove) {
    verifies<req::AOR_DO_002>();
    DigitalReading input;
    EXPECT_FALSE(input.read({0.0, 0.0, 0.0, SignalState::valid}));
    EXPECT_TRUE(input.read({0.1, 0.0, 0.0, SignalState::valid}));
    EXPECT_FALSE(input.read({0.0, 0.0, 0.0, SignalState::valid}));
}

TEST(DigitalReading, SignalInErrorKeepsTheLastReadingAndAnUnavailableSignalIsReadAsOff) {
    verifies<req::AOR_OUT_032>();
    DigitalReading input;
    EXPECT_TRUE(input.read({9.0, 0.0, 1.0, SignalState::valid}));
    EXPECT_TRUE(input.read({0.0, 0.0, 1.0, SignalState::error}));
    EXPECT_FALSE(input.read({9.0, 0.0, 1.0, SignalState::not_available}));
}

}  // namespace canproof::test
