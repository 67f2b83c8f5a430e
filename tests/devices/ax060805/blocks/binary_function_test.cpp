// SPDX-License-Identifier: Apache-2.0
// Signals, unary and binary functions and field values of the AX060805 (sections 3.1, 3.8, 4.3.33), calculated by hand
// from the manual.
#include "devices/ax060805/firmware/binary_function.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "devices/ax060805/firmware/count_value.hpp"
#include "generated/ax060805/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax060805;

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();
constexpr float all_bits = 4294967296.0F;  // FFFFFFFFh as a float: rounded to 2^32

/// Returns the result of a binary function and expects that the result is defined.
float result(int operation, float x, float y) {
    const Signal signal = apply_binary(static_cast<std::uint8_t>(operation), x, y);
    EXPECT_EQ(signal.kind, SignalKind::continuous) << operation << " of " << x << " and " << y;
    return signal.continuous;
}

bool is_undefined(int operation, float x, float y) {
    return !is_defined(apply_binary(static_cast<std::uint8_t>(operation), x, y));
}

FunctionInput input(const Signal& source) {
    FunctionInput one;
    one.source = source;
    return one;
}

}  // namespace

TEST(SignalConversion, ConversionToADiscreteSignalTruncatesAndSaturates) {
    verifies<req::INC_SIG_004, req::INC_SIG_009, req::INC_SIG_010>();
    EXPECT_EQ(to_discrete(0.0F), 0U);
    EXPECT_EQ(to_discrete(0.99F), 0U);
    EXPECT_EQ(to_discrete(3.99F), 3U);
    EXPECT_EQ(to_discrete(-0.01F), 0U);
    EXPECT_EQ(to_discrete(-5.0e9F), 0U);
    EXPECT_EQ(to_discrete(4294967040.0F), 0xFFFFFF00U);  // the largest float below 2^32
    EXPECT_EQ(to_discrete(4294967296.0F), 0xFFFFFFFFU);
    EXPECT_EQ(to_discrete(infinite), 0xFFFFFFFFU);
    EXPECT_EQ(to_discrete(-infinite), 0U);
    EXPECT_EQ(to_discrete(no_number), 0U);
}

TEST(SignalConversion, ConversionToAContinuousSignalKeepsTheValueToSinglePrecision) {
    verifies<req::INC_SIG_003, req::INC_SIG_008>();
    EXPECT_EQ(as_continuous(discrete_signal(0U)), 0.0F);
    EXPECT_EQ(as_continuous(discrete_signal(16777216U)), 16777216.0F);
    EXPECT_EQ(as_continuous(discrete_signal(16777217U)), 16777216.0F);  // 2^24 + 1 has 25 bits
    EXPECT_EQ(as_continuous(discrete_signal(0xFFFFFFFFU)), 4294967296.0F);
    EXPECT_EQ(as_continuous(continuous_signal(-1.5F)), -1.5F);
    EXPECT_EQ(as_continuous(undefined_signal()), 0.0F);
}

TEST(UnaryFunctions, UnaryFunctionsFollowTable9) {
    verifies<req::INC_BIN_003, req::INC_T9>();
    EXPECT_EQ(apply_unary(0, -2.5F), -2.5F);
    EXPECT_EQ(apply_unary(1, 0.0F), 1.0F);
    EXPECT_EQ(apply_unary(1, 0.9F), 1.0F);   // 0 as an integer
    EXPECT_EQ(apply_unary(1, -7.0F), 1.0F);  // 0 as an integer
    EXPECT_EQ(apply_unary(1, 1.0F), 0.0F);
    EXPECT_EQ(apply_unary(1, 300.5F), 0.0F);
    EXPECT_EQ(apply_unary(2, 0.0F), all_bits);
    EXPECT_EQ(apply_unary(2, 4294967040.0F), 255.0F);  // the complement of FFFFFF00h is FFh
    EXPECT_EQ(apply_unary(2, 5.0e9F), 0.0F);           // the complement of FFFFFFFFh is 0
    EXPECT_EQ(apply_unary(3, -2.5F), 2.5F);
    EXPECT_EQ(apply_unary(3, 2.5F), 2.5F);
    EXPECT_EQ(apply_unary(4, -2.5F), -2.5F);  // operation 4 does not exist: the value stays unchanged
}

TEST(BinaryFunctions, ArithmeticFollowsTable10) {
    verifies<req::INC_BIN_004, req::INC_T10>();
    EXPECT_TRUE(is_undefined(0, 1.0F, 2.0F));
    EXPECT_EQ(result(1, 1.5F, -4.0F), -2.5F);
    EXPECT_EQ(result(2, 1.5F, -4.0F), 5.5F);
    EXPECT_EQ(result(3, 1.5F, -4.0F), -6.0F);
    EXPECT_EQ(result(4, 1.5F, -4.0F), -0.375F);
    EXPECT_EQ(result(5, 13.9F, 4.9F), 1.0F);  // 13 mod 4 = 1
    EXPECT_EQ(result(5, 17.0F, 5.0F), 2.0F);
    EXPECT_TRUE(is_undefined(21, 1.0F, 2.0F));
    EXPECT_TRUE(is_undefined(255, 1.0F, 2.0F));
}

TEST(BinaryFunctions, MaximumAndMinimumFollowTable10) {
    verifies<req::INC_BIN_004, req::INC_T10>();
    EXPECT_EQ(result(6, 2.0F, -3.0F), 2.0F);
    EXPECT_EQ(result(6, -3.0F, 2.0F), 2.0F);
    EXPECT_EQ(result(7, 2.0F, -3.0F), -3.0F);
    EXPECT_EQ(result(7, -3.0F, 2.0F), -3.0F);
}

TEST(BinaryFunctions, ComparisonsFollowTable10) {
    verifies<req::INC_BIN_004, req::INC_T10>();
    struct Row {
        int operation;
        float less, equal, greater;  // result for x < y, x = y, x > y
    };
    const std::vector<Row> rows{{8, 0.0F, 1.0F, 0.0F},  {9, 1.0F, 0.0F, 1.0F},  {10, 0.0F, 0.0F, 1.0F},
                                {11, 0.0F, 1.0F, 1.0F}, {12, 1.0F, 0.0F, 0.0F}, {13, 1.0F, 1.0F, 0.0F}};
    for (const auto& row : rows) {
        EXPECT_EQ(result(row.operation, 1.25F, 1.5F), row.less) << row.operation;
        EXPECT_EQ(result(row.operation, 1.5F, 1.5F), row.equal) << row.operation;
        EXPECT_EQ(result(row.operation, -0.0F, 0.0F), row.equal) << row.operation;
        EXPECT_EQ(result(row.operation, 1.75F, 1.5F), row.greater) << row.operation;
        EXPECT_EQ(result(row.operation, infinite, infinite), row.equal) << row.operation;
        EXPECT_EQ(result(row.operation, -infinite, 3.0F), row.less) << row.operation;
    }
}

TEST(BinaryFunctions, LogicFunctionsOfTable10WorkOnIntegers) {
    verifies<req::INC_BIN_004, req::INC_T10>();
    EXPECT_EQ(result(14, 0.0F, 0.0F), 0.0F);
    EXPECT_EQ(result(14, 0.9F, -1.0F), 0.0F);  // 0.9 and -1.0 are both 0 as unsigned integers
    EXPECT_EQ(result(14, 0.0F, 2.0F), 1.0F);
    EXPECT_EQ(result(14, 4.0F, 0.0F), 1.0F);
    EXPECT_EQ(result(15, 4.0F, 0.5F), 0.0F);
    EXPECT_EQ(result(15, 0.5F, 4.0F), 0.0F);
    EXPECT_EQ(result(15, 4.0F, 2.0F), 1.0F);  // logical, although 4 & 2 is 0
}

TEST(BinaryFunctions, BitOperationsFollowTable10) {
    verifies<req::INC_BIN_004, req::INC_T10>();
    EXPECT_EQ(result(16, 12.0F, 10.7F), 14.0F);  // 1100b | 1010b = 1110b
    EXPECT_EQ(result(17, 12.0F, 10.7F), 8.0F);
    EXPECT_EQ(result(18, 12.0F, 10.7F), 6.0F);
    EXPECT_EQ(result(19, 3.0F, 4.9F), 48.0F);
    EXPECT_EQ(result(20, 48.0F, 4.0F), 3.0F);
    EXPECT_EQ(result(20, 49.0F, 4.0F), 3.0F);
}

TEST(BinaryFunctions, DivisionAndModulusByZeroGiveZero) {
    verifies<req::INC_BIN_005>();
    for (const float x : {0.0F, 1.0F, -1.0F, infinite}) {
        EXPECT_EQ(result(4, x, 0.0F), 0.0F);
        EXPECT_EQ(result(4, x, -0.0F), 0.0F);
        EXPECT_EQ(result(5, x, 0.0F), 0.0F);
        EXPECT_EQ(result(5, x, 0.9F), 0.0F);   // 0 as an integer
        EXPECT_EQ(result(5, x, -3.0F), 0.0F);  // 0 as an integer
    }
}

TEST(BinaryFunctions, ShiftsBy32AndMoreGiveZero) {
    verifies<req::INC_BIN_006>();
    EXPECT_EQ(result(19, 1.0F, 31.0F), 2147483648.0F);
    EXPECT_EQ(result(19, 3.0F, 31.0F), 2147483648.0F);  // 3 << 31 keeps only the lower of the two bits of 3
    EXPECT_EQ(result(19, 1.0F, 32.0F), 0.0F);
    EXPECT_EQ(result(19, 1.0F, 33.0F), 0.0F);
    EXPECT_EQ(result(19, 1.0F, infinite), 0.0F);
    EXPECT_EQ(result(20, 2147483648.0F, 31.0F), 1.0F);
    EXPECT_EQ(result(20, 4294967040.0F, 32.0F), 0.0F);
    EXPECT_EQ(result(20, 4294967040.0F, 5.0e9F), 0.0F);
}

TEST(BinaryFunctions, NanInputOrResultMakesTheOutputUndefined) {
    verifies<req::INC_BIN_007, req::INC_BIN_017>();
    for (int operation = 0; operation <= 20; ++operation) {
        EXPECT_TRUE(is_undefined(operation, no_number, 1.0F)) << operation;
        EXPECT_TRUE(is_undefined(operation, 1.0F, no_number)) << operation;
    }
    EXPECT_TRUE(is_undefined(2, infinite, infinite));
    EXPECT_TRUE(is_undefined(3, infinite, 0.0F));
    EXPECT_TRUE(is_undefined(4, infinite, -infinite));
    EXPECT_EQ(result(1, infinite, 5.0F), infinite);
    EXPECT_EQ(result(3, -infinite, 2.0F), -infinite);
}

TEST(FunctionBlocks, FunctionBlockFollowsEquation4) {
    verifies<req::INC_BIN_001>();
    FunctionBlock block;
    block.inputs[0] = input(continuous_signal(-10.0F));
    block.inputs[0].unary = 3;              // unary function 3 gives the absolute value: 10
    block.inputs[0].linear = {0.5F, 1.0F};  // 10 * 0.5 + 1 = 6
    block.inputs[1] = input(discrete_signal(4U));
    block.inputs[1].linear = {-2.0F, 5.0F};  // 4 * -2 + 5 = -3
    block.operation = 2;                     // 6 - -3 = 9
    block.output = {10.0F, 0.25F};           // 9 * 10 + 0.25 = 90.25
    const Signal result = evaluate(block);
    EXPECT_EQ(result.kind, SignalKind::continuous);
    EXPECT_EQ(result.continuous, 90.25F);
}

TEST(FunctionBlocks, UndefinedInputUsesItsDefaultOrMakesTheOutputUndefined) {
    verifies<req::INC_BIN_002, req::INC_BIN_014, req::INC_SIG_002>();
    FunctionBlock block;
    block.operation = 1;
    block.inputs[0] = input(continuous_signal(2.0F));
    EXPECT_FALSE(is_defined(evaluate(block)));
    block.inputs[1].default_value = 40.0F;
    EXPECT_FALSE(is_defined(evaluate(block)));
    block.inputs[1].has_default = true;
    EXPECT_EQ(evaluate(block).continuous, 42.0F);
    block.inputs[1].source = continuous_signal(1.0F);  // a signal takes precedence over its default
    EXPECT_EQ(evaluate(block).continuous, 3.0F);
    block.inputs[0].source = undefined_signal();
    EXPECT_FALSE(is_defined(evaluate(block)));
}

TEST(FunctionBlocks, UnaryFunctionScaleAndOffsetAlsoApplyToTheDefaultOfAnInput) {
    verifies<req::INC_BIN_002>();
    FunctionBlock block;
    block.operation = 1;
    block.inputs[0] = input(continuous_signal(0.0F));
    block.inputs[1].has_default = true;
    block.inputs[1].default_value = -3.0F;
    block.inputs[1].unary = 3;
    block.inputs[1].linear = {2.0F, 1.0F};
    EXPECT_EQ(evaluate(block).continuous, 7.0F);  // |-3| * 2 + 1
}

TEST(FunctionBlocks, ZeroTimesInfinityAtTheOutputScaleIsUndefined) {
    verifies<req::INC_BIN_017>();
    FunctionBlock block;
    block.operation = 1;
    block.inputs[0] = input(continuous_signal(infinite));
    block.inputs[1] = input(continuous_signal(1.0F));
    block.output = {0.0F, 0.0F};  // 0 times infinity is undefined
    EXPECT_FALSE(is_defined(evaluate(block)));
}

TEST(CountValue, ValueIsScaledToCountsThenShiftedByTheOffsetAndRounded) {
    verifies<req::INC_FV_001>();
    EXPECT_EQ(count_value(44.4F, {1, 0.0F}), 44);
    EXPECT_EQ(count_value(44.5F, {1, 0.0F}), 45);
    EXPECT_EQ(count_value(-44.5F, {1, 0.0F}), -45);
    EXPECT_EQ(count_value(12.25F, {10, 0.0F}), 123);  // 12.25 * 10 = 122.5, rounded up
    EXPECT_EQ(count_value(10.0F, {10, -3.5F}), 97);   // 10 * 10 - 3.5 = 96.5: the offset is in counts
    EXPECT_EQ(count_value(-1.0F, {1000, 0.0F}), -1000);
}

TEST(CountValue, ValueInCountsSaturatesAtTheLimitsOfInteger16) {
    verifies<req::INC_FV_002>();
    EXPECT_EQ(count_value(32.767F, {1000, 0.0F}), 32767);
    EXPECT_EQ(count_value(40.0F, {1000, 0.0F}), 32767);
    EXPECT_EQ(count_value(-40.0F, {1000, 0.0F}), -32768);
    EXPECT_EQ(count_value(0.0F, {1, 4294967296.0F}), 32767);
    EXPECT_EQ(count_value(0.0F, {1, -4294967296.0F}), -32768);
    EXPECT_EQ(count_value(infinite, {1, 0.0F}), 32767);
    EXPECT_EQ(count_value(no_number, {1, 0.0F}), 0);
}

TEST(CountValue, OffsetIsAddedToAReceivedCountBeforeTheCountIsScaled) {
    verifies<req::INC_RPDO_001>();
    EXPECT_EQ(value_of_count(250, {1000, 0.0F}), 250.0F);  // one count per unit
    EXPECT_EQ(value_of_count(250, {100, -50.0F}), 20.0F);  // ten counts per unit
    EXPECT_EQ(value_of_count(250, {10, 50.0F}), 3.0F);     // a hundred counts per unit
    EXPECT_EQ(value_of_count(250, {500, 0.0F}), 125.0F);   // two counts per unit
    EXPECT_EQ(value_of_count(-32768, {1000, 0.0F}), -32768.0F);
    EXPECT_EQ(value_of_count(32767, {1000, 0.5F}), 32767.5F);
}

TEST(CountValue, FilterLatencyIsRoundedToMillisecondsAndClampedTo16Bits) {
    verifies<req::INC_LATENCY_001>();
    EXPECT_EQ(whole_milliseconds(31.83F), 32U);
    EXPECT_EQ(whole_milliseconds(31.4F), 31U);
    EXPECT_EQ(whole_milliseconds(65535.4F), 65535U);
    EXPECT_EQ(whole_milliseconds(1.8e9F), 65535U);
    EXPECT_EQ(whole_milliseconds(-1.0F), 0U);
    EXPECT_EQ(whole_milliseconds(no_number), 0U);
}

}  // namespace canproof::test
