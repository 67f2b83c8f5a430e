// SPDX-License-Identifier: Apache-2.0
// Tests the math blocks of the AX130751 (manual, 1.7): the eighteen operators of Table 21, and chains of functions.
#include "devices/ax130751/firmware/math_block.hpp"

#include <cmath>

#include "generated/ax130751/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax130751;

constexpr std::uint8_t plus = 12;
constexpr std::uint8_t minus = 13;
constexpr std::uint8_t times = 14;
constexpr std::uint8_t divided_by = 15;
constexpr std::uint8_t minimum = 16;
constexpr std::uint8_t maximum = 17;

/// Returns an input whose value is in percent and whose scaling is 0 to 100 %.
MathInput percent(double value, double gain = 1.0) {
    return {{value, 0.0, 100.0, SignalState::valid}, 0.0, 100.0, gain, 0};
}
MathInput result_of(std::uint8_t function, double gain = 1.0) {
    MathInput input = percent(0.0, gain);
    input.own_function = function;
    return input;
}
const MathInput unused{{}, 0.0, 100.0, 1.0, 0};

double run(const std::array<MathInput, 4>& inputs, const std::array<std::uint8_t, 3>& operators) {
    return MathBlock{}.advance({inputs, operators}).value;
}

}  // namespace

TEST(MathBlock, OperatorsFollowTable21) {
    verifies<req::AOR_T21, req::AOR_MATH_003, req::AOR_MATH_012>();
    struct Row {
        int number;
        double less, equal, greater;  // 0.4 with 0.6, 0.6 with 0.6, 0.6 with 0.4
    };
    const std::array<Row, 12> rows{{
        {0, 0, 1, 0},   // operator =
        {1, 1, 0, 1},   // operator !=
        {2, 0, 0, 1},   // operator >
        {3, 0, 1, 1},   // operator >=
        {4, 1, 0, 0},   // operator <
        {5, 1, 1, 0},   // operator <=
        {6, 1, 1, 1},   // operator or: values from 0.5 on are true, so 0.6 is true and 0.4 is false
        {7, 0, 0, 0},   // operator nor
        {8, 0, 1, 0},   // operator and
        {9, 1, 0, 1},   // operator nand
        {10, 1, 0, 1},  // operator xor
        {11, 0, 1, 0},  // operator xnor
    }};
    for (const auto& row : rows) {
        const auto number = static_cast<std::uint8_t>(row.number);
        EXPECT_EQ(apply_operator(number, 0.4, 0.6), row.less) << row.number;
        EXPECT_EQ(apply_operator(number, 0.6, 0.6), row.equal) << row.number;
        EXPECT_EQ(apply_operator(number, 0.6, 0.4), row.greater) << row.number;
    }
    // the logical operators 6 to 11 with two false inputs (0.4)
    EXPECT_EQ(apply_operator(6, 0.4, 0.4), 0.0);
    EXPECT_EQ(apply_operator(7, 0.4, 0.4), 1.0);
    EXPECT_EQ(apply_operator(8, 0.4, 0.4), 0.0);
    EXPECT_EQ(apply_operator(9, 0.4, 0.4), 1.0);
    EXPECT_EQ(apply_operator(10, 0.4, 0.4), 0.0);
    EXPECT_EQ(apply_operator(11, 0.4, 0.4), 1.0);
    EXPECT_DOUBLE_EQ(apply_operator(12, 0.25, 0.5), 0.75);
    EXPECT_DOUBLE_EQ(apply_operator(13, 0.75, 0.5), 0.25);
    EXPECT_DOUBLE_EQ(apply_operator(14, 0.5, 0.5), 0.25);
    EXPECT_DOUBLE_EQ(apply_operator(15, 0.25, 0.5), 0.5);
    EXPECT_DOUBLE_EQ(apply_operator(16, 0.25, 0.5), 0.25);
    EXPECT_DOUBLE_EQ(apply_operator(17, 0.25, 0.5), 0.5);
}

TEST(MathBlock, LogicalOperatorReadsAMathInputOfHalfScaleOrMoreAsTrue) {
    verifies<req::AOR_MATH_012, req::AOR_K_TRUE_FROM>();
    EXPECT_EQ(apply_operator(8, 0.5, 0.5), 1.0);
    EXPECT_EQ(apply_operator(8, 0.499999, 1.0), 0.0);
}

TEST(MathBlock, InputsAreFractionsOfTheirScaling) {
    verifies<req::AOR_MATH_001, req::AOR_MATH_017, req::AOR_MATH_018>();
    const auto fraction = [](double value, double scaling_1, double scaling_2) {
        return math_fraction({{value, 0.0, 0.0, SignalState::valid}, scaling_1, scaling_2, 1.0, 0});
    };
    EXPECT_DOUBLE_EQ(fraction(2.5, 0.0, 10.0), 0.25);
    EXPECT_DOUBLE_EQ(fraction(-40.0, -40.0, 210.0), 0.0);
    EXPECT_DOUBLE_EQ(fraction(85.0, -40.0, 210.0), 0.5);
    EXPECT_DOUBLE_EQ(fraction(500.0, -40.0, 210.0), 1.0);
    EXPECT_DOUBLE_EQ(fraction(-50.0, -40.0, 210.0), 0.0);
    EXPECT_DOUBLE_EQ(fraction(75.0, 100.0, 0.0), 0.25) << "falling";
    EXPECT_DOUBLE_EQ(fraction(5.0, 5.0, 5.0), 0.0) << "no span";
    EXPECT_DOUBLE_EQ(fraction(6.0, 5.0, 5.0), 0.0);
    EXPECT_DOUBLE_EQ(fraction(4.0, 5.0, 5.0), 0.0);
    EXPECT_DOUBLE_EQ(fraction(std::nan(""), -40.0, 210.0), 0.0);
}

TEST(MathBlock, InputFractionHasStepsOfAMillionth) {
    verifies<req::AOR_MATH_021>();
    const auto fraction = [](double value) {
        return math_fraction({{value, 0.0, 0.0, SignalState::valid}, 0.0, 1.0, 1.0, 0});
    };
    EXPECT_EQ(fraction(0.12345649), 0.123456);
    EXPECT_EQ(fraction(0.12345651), 0.123457);
    EXPECT_EQ(fraction(0.00000049), 0.0);
    EXPECT_EQ(fraction(0.00000051), 0.000001);
    EXPECT_EQ(fraction(0.99999949), 0.999999);
    EXPECT_EQ(fraction(0.99999951), 1.0);
}

TEST(MathBlock, ResultIsClampedAtABillion) {
    verifies<req::AOR_MATH_022>();
    // Returns 1 / 0.000001 / `divisor`, with the sign of `gain`. The second input, 0.0001 percent, is a millionth.
    const auto quotient = [](double divisor, double gain) {
        return run({percent(100, gain), percent(0.0001), percent(100 * divisor), unused},
                   {divided_by, divided_by, plus});
    };
    EXPECT_NEAR(quotient(0.001001, 1.0), 1.0e6 / 0.001001, 1.0);
    EXPECT_EQ(quotient(0.000999, 1.0), 1.0e9);
    EXPECT_NEAR(quotient(0.001001, -1.0), -1.0e6 / 0.001001, 1.0);
    EXPECT_EQ(quotient(0.000999, -1.0), -1.0e9);
}

TEST(MathBlock, ResultBelow1eMinus290InSizeIsZero) {
    verifies<req::AOR_MATH_027>();
    const auto sum = [](double gain) {
        return run({percent(100, gain), percent(0), unused, unused}, {plus, plus, plus});
    };
    EXPECT_EQ(sum(1.1e-290), 1.1e-290);
    EXPECT_EQ(sum(1.0e-290), 1.0e-290) << "not less";
    EXPECT_EQ(sum(0.9e-290), 0.0);
    EXPECT_EQ(sum(-1.1e-290), -1.1e-290);
    EXPECT_EQ(sum(-0.9e-290), 0.0);
    EXPECT_FALSE(std::signbit(sum(-0.9e-290)));
}

TEST(MathBlock, EqualInputsCompareEqualAfterDifferentScalings) {
    verifies<req::AOR_MATH_003, req::AOR_MATH_021>();
    for (int tenth = 0; tenth <= 1000; ++tenth) {
        const MathInput a{{physical_value(tenth, 1), 0.0, 0.0, SignalState::valid}, 0.0, 100.0, 1.0, 0};
        const MathInput b{{physical_value((3 * tenth) + 70, 2), 0.0, 0.0, SignalState::valid}, 0.7, 30.7, 1.0, 0};
        ASSERT_EQ(run({a, b, unused, unused}, {0, plus, plus}), 1.0) << tenth;
    }
}

TEST(MathBlock, ExampleOfJoystickAndPotentiometerFollowsTheManual) {
    verifies<req::AOR_MATH_001, req::AOR_MATH_002, req::AOR_MATH_019>();
    // input 1 (joystick) has a gain of 0.75, input 2 (potentiometer) a gain of 0.25
    const auto sum = [](double joystick, double potentiometer) {
        return run({percent(joystick, 0.75), percent(potentiometer, 0.25), unused, unused}, {plus, plus, plus});
    };
    EXPECT_DOUBLE_EQ(sum(0, 0), 0.0);
    EXPECT_DOUBLE_EQ(sum(100, 0), 0.75);
    EXPECT_DOUBLE_EQ(sum(100, 100), 1.0);
    EXPECT_DOUBLE_EQ(sum(40, 60), 0.45);  // 0.3 + 0.15
}

TEST(MathBlock, EachFunctionUsesThePreviousResult) {
    verifies<req::AOR_MATH_002, req::AOR_MATH_023>();
    // ((0.2 + 0.6) * 0.5) - 0.1 = 0.3
    EXPECT_DOUBLE_EQ(run({percent(20), percent(60), percent(50), percent(10)}, {plus, times, minus}), 0.3);
}

TEST(MathBlock, DivisionByZeroGivesZero) {
    verifies<req::AOR_MATH_004>();
    EXPECT_EQ(run({percent(50), percent(0), unused, unused}, {divided_by, plus, plus}), 0.0);
    EXPECT_DOUBLE_EQ(run({percent(50), percent(0), percent(25), unused}, {divided_by, plus, plus}), 0.25);
}

TEST(MathBlock, NegativeDifferenceIsClampedToZero) {
    verifies<req::AOR_MATH_005>();
    EXPECT_EQ(run({percent(20), percent(50), unused, unused}, {minus, plus, plus}), 0.0);
    EXPECT_DOUBLE_EQ(run({percent(20), percent(50), percent(40), unused}, {minus, plus, plus}), 0.4);
}

TEST(MathBlock, NegativeDifferenceIsNotClampedToZeroWhenAnInputOfTheFunctionHasANegativeGain) {
    verifies<req::AOR_MATH_005>();
    // -0.2 - 0.5 = -0.7; + 0.9 = 0.2
    EXPECT_DOUBLE_EQ(run({percent(20, -1), percent(50), percent(90), unused}, {minus, plus, plus}), 0.9 - 0.7);
    // -0.2 - -0.5 = 0.3
    EXPECT_DOUBLE_EQ(run({percent(20, -1), percent(50, -1), unused, unused}, {minus, plus, plus}), 0.5 - 0.2);
    // function 1 is -0.2 + 0.3; function 2 is 0.1 - 0.5, clamped to 0, because the gain of input 1 does not affect it
    EXPECT_EQ(run({percent(20, -1), percent(30), percent(50), unused}, {plus, minus, plus}), 0.0);
}

TEST(MathBlock, NegativeResultKeepsItsSignThroughTheChain) {
    verifies<req::AOR_MATH_005>();
    // -0.2 - 0.5 = -0.7; -0.7 * 0.5 = -0.35 is not clamped, because it is no difference; -0.35 + 0.9 = 0.55
    EXPECT_DOUBLE_EQ(run({percent(20, -1), percent(50), percent(50), percent(90)}, {minus, times, plus}), 0.9 - 0.35);
    // -0.2 - 0.5 = -0.7; -0.7 - -0.2 = -0.5 is not clamped, because a gain is negative; -0.5 + 0.9 = 0.4
    EXPECT_DOUBLE_EQ(run({percent(20, -1), percent(50), percent(20, -1), percent(90)}, {minus, minus, plus}),
                     0.9 - 0.5);
}

TEST(MathBlock, GainOfZeroClampsANegativeDifference) {
    verifies<req::AOR_MATH_005>();
    // 0 - 0.5 is clamped to 0; then 0 + 0.9 = 0.9
    EXPECT_EQ(run({percent(20, 0), percent(50), percent(90), unused}, {minus, plus, plus}), 0.9);
    // -0.2 - 0.5 = -0.7; -0.7 - 0 is clamped to 0; then 0 + 0.9 = 0.9
    EXPECT_EQ(run({percent(20, -1), percent(50), percent(50, 0), percent(90)}, {minus, minus, plus}), 0.9);
}

TEST(MathBlock, NegativeGainOnAFedBackResultKeepsANegativeDifferenceUnclamped) {
    verifies<req::AOR_MATH_013, req::AOR_MATH_009, req::AOR_MATH_026>();
    // function 1 is 0.2 - 0.5 = -0.3, for function 2 clamped to 0; input 3 is -0.3 * -1 = 0.3; function 2 is 0 + 0.3
    EXPECT_DOUBLE_EQ(run({percent(20), percent(50), result_of(1, -1.0), unused}, {minus, plus, plus}), 0.5 - 0.2);
    // with a gain of 1 the result of function 1 is 0: 0 + 0 + 0.9
    EXPECT_DOUBLE_EQ(run({percent(20), percent(50), result_of(1), percent(90)}, {minus, plus, plus}), 0.9);
}

TEST(MathBlock, InputInErrorCountsAsZero) {
    verifies<req::AOR_MATH_006>();
    MathInput failed = percent(80);
    failed.signal.state = SignalState::error;
    EXPECT_DOUBLE_EQ(run({percent(20), failed, unused, unused}, {plus, plus, plus}), 0.2);
    EXPECT_DOUBLE_EQ(run({failed, percent(30), unused, unused}, {17, plus, plus}), 0.3);
}

TEST(MathBlock, FunctionThatLacksOneOfItsTwoInputsIsSkipped) {
    verifies<req::AOR_MATH_007, req::AOR_MATH_016>();
    EXPECT_DOUBLE_EQ(run({percent(20), percent(30), unused, percent(10)}, {plus, times, plus}), 0.6);
    EXPECT_DOUBLE_EQ(run({percent(20), percent(30), percent(50), unused}, {plus, times, times}), 0.25);
    EXPECT_FALSE(MathBlock{}.advance({{percent(20), unused, percent(30), percent(40)}, {plus, plus, plus}}).done);
    EXPECT_FALSE(MathBlock{}.advance({{unused, percent(20), unused, unused}, {plus, plus, plus}}).done);
    EXPECT_FALSE(MathBlock{}.advance({{unused, unused, unused, unused}, {plus, plus, plus}}).done);
}

TEST(MathBlock, InputFromALaterFunctionHasItsResultOfThePreviousCycle) {
    verifies<req::AOR_MATH_015>();
    // Input 1 is function 3 of the same block, which adds 0.1 in each cycle: a counter.
    MathBlock block;
    const MathConfig config{{result_of(3), percent(10), unused, percent(0)}, {plus, plus, plus}};
    EXPECT_DOUBLE_EQ(block.advance(config).value, 0.1);
    EXPECT_DOUBLE_EQ(block.advance(config).value, 0.2);
    EXPECT_DOUBLE_EQ(block.advance(config).value, 0.1 + 0.1 + 0.1);
    block.reset();
    EXPECT_DOUBLE_EQ(block.advance(config).value, 0.1);
}

TEST(MathBlock, InputFromAnEarlierFunctionHasItsResultOfThisCycle) {
    verifies<req::AOR_MATH_009>();
    // function 1 = 0.6; function 2 = 0.6 * 0.5 = 0.3; function 3 = 0.3 + function 1 = 0.3 + 0.6 = 0.9
    EXPECT_DOUBLE_EQ(run({percent(60), percent(0), percent(50), result_of(1)}, {plus, times, plus}), 0.9);
}

TEST(MathBlock, ChangeOfTheResultOfFunction1RequestsAnotherCycle) {
    verifies<req::AOR_MATH_015>();
    MathBlock block;
    const std::array<std::uint8_t, 3> operators{plus, plus, plus};
    // Function 1 = function 1 + 0.1; the other functions are not used.
    const MathConfig counts{{result_of(1), percent(10), unused, unused}, operators};
    EXPECT_DOUBLE_EQ(block.advance(counts).value, 0.1);
    EXPECT_FALSE(block.is_settled());
    EXPECT_DOUBLE_EQ(block.advance(counts).value, 0.2);
    EXPECT_FALSE(block.is_settled());
    const MathConfig stays{{result_of(1), percent(0), unused, unused}, operators};
    EXPECT_DOUBLE_EQ(block.advance(stays).value, 0.2);
    EXPECT_TRUE(block.is_settled());
}

TEST(MathBlock, ChangeOfTheResultOfFunction2RequestsAnotherCycle) {
    verifies<req::AOR_MATH_015>();
    MathBlock block;
    // Function 1 = the larger of function 2 and 0.5; function 2 = function 1 + input 3.
    const auto config = [](double third) {
        return MathConfig{{result_of(2), percent(50), percent(third), unused}, {maximum, plus, plus}};
    };
    EXPECT_DOUBLE_EQ(block.advance(config(0)).value, 0.5);
    EXPECT_DOUBLE_EQ(block.advance(config(0)).value, 0.5);
    EXPECT_TRUE(block.is_settled());
    EXPECT_DOUBLE_EQ(block.advance(config(10)).value, 0.6) << "0.5, as before, + 0.1";
    EXPECT_FALSE(block.is_settled());
    EXPECT_DOUBLE_EQ(block.advance(config(10)).value, 0.7) << "0.6 + 0.1";
}

TEST(MathBlock, ChangeOfTheResultOfFunction3RequestsAnotherCycle) {
    verifies<req::AOR_MATH_015>();
    MathBlock block;
    // Function 1 = the larger of function 3 and 0.5; function 2 = function 1; function 3 = function 2 + input 4.
    const auto config = [](double fourth) {
        return MathConfig{{result_of(3), percent(50), percent(0), percent(fourth)}, {maximum, plus, plus}};
    };
    EXPECT_DOUBLE_EQ(block.advance(config(0)).value, 0.5);
    EXPECT_DOUBLE_EQ(block.advance(config(0)).value, 0.5);
    EXPECT_TRUE(block.is_settled());
    EXPECT_DOUBLE_EQ(block.advance(config(10)).value, 0.6);
    EXPECT_FALSE(block.is_settled());
    EXPECT_DOUBLE_EQ(block.advance(config(10)).value, 0.7);
}

TEST(MathBlock, ChangeOfADifferenceBelowZeroRequestsAnotherCycle) {
    verifies<req::AOR_MATH_005, req::AOR_MATH_013, req::AOR_MATH_015>();
    MathBlock block;
    // Function 1 = the smaller of 0.2 and function 2 times -1; function 2 = function 1 - input 3; function 3 = function
    // 2 + function 1.
    const auto config = [](double third) {
        return MathConfig{{result_of(2, -1.0), percent(20), percent(third), result_of(1)}, {minimum, minus, plus}};
    };
    EXPECT_DOUBLE_EQ(block.advance(config(50)).value, 0.0) << "0; 0 - 0.5; 0 + 0";
    EXPECT_DOUBLE_EQ(block.advance(config(50)).value, 0.2) << "0.2 of 0.5; 0.2 - 0.5; 0 + 0.2";
    EXPECT_DOUBLE_EQ(block.advance(config(50)).value, 0.2) << "0.2 of 0.3; 0.2 - 0.5; 0 + 0.2";
    EXPECT_TRUE(block.is_settled());
    EXPECT_DOUBLE_EQ(block.advance(config(30)).value, 0.2) << "0.2 of 0.3; 0.2 - 0.3; 0 + 0.2";
    EXPECT_FALSE(block.is_settled()) << "-0.1 after -0.3, though both count as 0 to function 3";
    EXPECT_DOUBLE_EQ(block.advance(config(30)).value, 0.1) << "0.1 of 0.1; 0.1 - 0.3; 0 + 0.1";
}

TEST(MathBlock, ReplacingADifferenceByASumRequestsAnotherCycle) {
    verifies<req::AOR_MATH_005, req::AOR_MATH_015>();
    MathBlock block;
    // Function 1 = function 2 + 0.2. Function 2 is first the difference function 1 - 0.5, clamped to 0, and then the
    // sum function 1 + (-0.5), which is not clamped.
    const MathConfig difference{{result_of(2), percent(20), percent(50), unused}, {plus, minus, plus}};
    const MathConfig sum{{result_of(2), percent(20), percent(50, -1.0), unused}, {plus, plus, plus}};
    EXPECT_DOUBLE_EQ(block.advance(difference).value, 0.0);
    EXPECT_DOUBLE_EQ(block.advance(difference).value, 0.0);
    EXPECT_TRUE(block.is_settled());
    EXPECT_DOUBLE_EQ(block.advance(sum).value, 0.2 - 0.5);
    EXPECT_FALSE(block.is_settled());
    EXPECT_DOUBLE_EQ(block.advance(sum).value, -0.1 - 0.5) << "function 1 = -0.3 + 0.2";
}

TEST(MathBlock, SkippedFunctionFeedsBackZero) {
    verifies<req::AOR_MATH_007, req::AOR_MATH_015>();
    // Function 1 = function 2 + 0.1; function 2 = function 1 + input 3. Later, input 3 is not used, so function 2 is
    // skipped.
    MathBlock block;
    const std::array<std::uint8_t, 3> operators{plus, plus, plus};
    const MathConfig whole{{result_of(2), percent(10), percent(20), unused}, operators};
    EXPECT_DOUBLE_EQ(block.advance(whole).value, 0.1 + 0.2);
    EXPECT_DOUBLE_EQ(block.advance(whole).value, 0.3 + 0.1 + 0.2);
    const MathConfig without{{result_of(2), percent(10), unused, unused}, operators};
    EXPECT_DOUBLE_EQ(block.advance(without).value, 0.6 + 0.1) << "of the cycle before";
    EXPECT_FALSE(block.is_settled());
    EXPECT_DOUBLE_EQ(block.advance(without).value, 0.1);
}

TEST(MathBlock, OutputIsScaledBetweenOutputScaling1And2AndClamped) {
    verifies<req::AOR_MATH_008, req::AOR_MATH_024>();
    EXPECT_DOUBLE_EQ(math_output(0.25, 0.0, 100.0), 25.0);
    EXPECT_DOUBLE_EQ(math_output(0.5, -10.0, 10.0), 0.0);
    EXPECT_DOUBLE_EQ(math_output(-0.5, -10.0, 10.0), -10.0);
    EXPECT_DOUBLE_EQ(math_output(1.5, -10.0, 10.0), 10.0);
    EXPECT_DOUBLE_EQ(math_output(0.25, 100.0, 0.0), 75.0);
}

TEST(MathBlock, InputThatSelectsANonexistentFunctionUsesItsOwnSignal) {
    verifies<req::AOR_MATH_002>();
    // An input can select functions 1 to 3. Number 4 selects no function but the input's own signal, which is 0 % here.
    EXPECT_DOUBLE_EQ(run({percent(20), percent(60), result_of(4), unused}, {plus, plus, plus}), 0.8);
}

}  // namespace canproof::test
