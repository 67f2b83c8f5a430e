// SPDX-License-Identifier: Apache-2.0
// Properties of the signals and functions of the AX060805 (manual, 3.1 and 3.8). They hold for every bit pattern of the
// inputs.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>

#include "devices/ax060805/firmware/binary_function.hpp"
#include "devices/ax060805/firmware/count_value.hpp"
#include "generated/ax060805/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax060805;

float from_bits(std::uint32_t bits) {
    float value = 0.0F;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

/// Returns a float with any of the 2^32 bit patterns. Special values, such as 2^32, infinity and NaN, occur more often.
float any_float() {
    return *rc::gen::oneOf(
        rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>()), from_bits),
        rc::gen::element(0.0F, -0.0F, 1.0F, -1.0F, 0.5F, 31.0F, 32.0F, 33.0F, 4294967040.0F, 4294967296.0F, INFINITY,
                         -INFINITY, NAN, 1.0e-45F, 3.4028235e38F),
        rc::gen::map(rc::gen::inRange(-100, 100), [](int n) { return static_cast<float>(n) / 4.0F; }));
}

/// Converts a continuous signal to a discrete one by the rule of section 3.1.6, in double precision.
std::uint64_t whole(float value) {
    if (std::isnan(value) || value <= 0.0F) {
        return 0;
    }
    const double cut = std::floor(static_cast<double>(value));
    return cut > 4294967295.0 ? 4294967295U : static_cast<std::uint64_t>(cut);
}

/// Calculates the integer operations of Table 10 in 64-bit arithmetic.
std::uint64_t integer_reference(int operation, std::uint64_t x, std::uint64_t y) {
    switch (operation) {
        case 5:
            return y == 0 ? 0 : x - (x / y) * y;
        case 14:
            return x + y > 0 ? 1 : 0;
        case 15:
            return x > 0 && y > 0 ? 1 : 0;
        case 16:
            return x + y - (x & y);
        case 17:
            return x - (x & ~y);
        case 18:
            return x + y - 2 * (x & y);
        case 19:
            return y > 31 ? 0 : (x << y) % 4294967296U;
        default:
            return y > 31 ? 0 : x / (std::uint64_t{1} << y);
    }
}

}  // namespace

RC_GTEST_PROP(SignalLaw, ConversionToADiscreteSignalTruncatesAndSaturatesEveryFloat, ()) {
    verifies<req::INC_SIG_004, req::INC_SIG_009, req::INC_SIG_010>("property");
    const float value = any_float();
    RC_ASSERT(to_discrete(value) == whole(value));
}

RC_GTEST_PROP(SignalLaw, ConversionToAContinuousSignalGivesTheNearestFloat, (std::uint32_t value)) {
    verifies<req::INC_SIG_008>("property");
    const auto continuous = static_cast<double>(as_continuous(discrete_signal(value)));
    // Two neighbouring floats just below 2^32 are 2^32 / 2^24 = 256 apart; rounding errs by at most half of this, 128.
    RC_ASSERT(std::fabs(continuous - static_cast<double>(value)) <= 128.0);
    if (value <= 16777216U) {
        RC_ASSERT(continuous == static_cast<double>(value));
    }
}

RC_GTEST_PROP(FunctionLaw, UnaryFunctionsGiveADefinedResultForEveryInput, ()) {
    verifies<req::INC_BIN_003>("property");
    const float x = any_float();
    const float negated = apply_unary(1, x);
    RC_ASSERT(negated == (whole(x) == 0 ? 1.0F : 0.0F));
    RC_ASSERT(apply_unary(2, x) == static_cast<float>(4294967295U - whole(x)));
    RC_ASSERT(std::isnan(x) || apply_unary(3, x) >= 0.0F);
    RC_ASSERT(std::isnan(x) || apply_unary(0, x) == x);
}

RC_GTEST_PROP(FunctionLaw, BinaryFunctionsNeverGiveNanButAnUndefinedResultForNanInputs, (std::uint8_t number)) {
    verifies<req::INC_BIN_007, req::INC_BIN_017>("property");
    const float x = any_float();
    const float y = any_float();
    for (const std::uint8_t operation : {number, static_cast<std::uint8_t>(number % 21U)}) {
        const Signal result = apply_binary(operation, x, y);
        const bool must_be_undefined = operation == 0 || operation > 20 || std::isnan(x) || std::isnan(y);
        if (must_be_undefined) {
            RC_ASSERT(!is_defined(result));
        }
        if (is_defined(result)) {
            RC_ASSERT(!std::isnan(result.continuous));
        } else {
            // If neither operand is NaN, operations 1 to 4 (sum, difference, product, quotient) give an undefined
            // result only with an infinite operand.
            RC_ASSERT(must_be_undefined || (operation <= 4 && (std::isinf(x) || std::isinf(y))));
        }
    }
}

RC_GTEST_PROP(FunctionLaw, IntegerFunctionsAgreeWith64BitArithmetic, ()) {
    verifies<req::INC_BIN_004, req::INC_BIN_005, req::INC_BIN_006>("property");
    const float x = any_float();
    const float y = any_float();
    RC_PRE(!std::isnan(x) && !std::isnan(y));
    for (const int operation : {5, 14, 15, 16, 17, 18, 19, 20}) {
        const Signal result = apply_binary(static_cast<std::uint8_t>(operation), x, y);
        RC_ASSERT(result.continuous == static_cast<float>(integer_reference(operation, whole(x), whole(y))));
    }
}

RC_GTEST_PROP(FunctionLaw, OppositeComparisonsGiveOppositeResults, ()) {
    verifies<req::INC_BIN_004>("property");
    const float x = any_float();
    const float y = any_float();
    RC_PRE(!std::isnan(x) && !std::isnan(y));
    const auto result = [&](int operation) {
        return apply_binary(static_cast<std::uint8_t>(operation), x, y).continuous;
    };
    RC_ASSERT(result(8) + result(9) == 1.0F);
    RC_ASSERT(result(10) + result(13) == 1.0F);
    RC_ASSERT(result(11) + result(12) == 1.0F);
    RC_ASSERT(result(8) + result(10) + result(12) == 1.0F);
    RC_ASSERT(result(6) >= x && result(6) >= y && (result(6) == x || result(6) == y));
    RC_ASSERT(result(7) <= x && result(7) <= y && (result(7) == x || result(7) == y));
}

RC_GTEST_PROP(FunctionLaw, FunctionBlockNeverGivesNan, ()) {
    verifies<req::INC_BIN_007>("property");
    FunctionBlock block;
    for (auto& input : block.inputs) {
        input.source = *rc::gen::element(0, 1, 2) == 0 ? undefined_signal() : continuous_signal(any_float());
        input.has_default = *rc::gen::arbitrary<bool>();
        input.default_value = any_float();
        input.unary = *rc::gen::arbitrary<std::uint8_t>();
        input.linear = {any_float(), any_float()};
    }
    block.operation = *rc::gen::inRange<std::uint8_t>(0, 24);
    block.output = {any_float(), any_float()};
    const Signal result = evaluate(block);
    RC_ASSERT(!is_defined(result) || !std::isnan(result.continuous));
}

RC_GTEST_PROP(CountValueLaw, ValueInCountsIsTheNearestIntegerWithin16Bits, ()) {
    verifies<req::INC_FV_001, req::INC_FV_002>("property");
    const float value = any_float();
    const auto digits = *rc::gen::inRange<std::uint16_t>(1, 1001);
    const float offset = any_float();
    const double counts = static_cast<double>(value * static_cast<float>(digits) + offset);
    const int result = count_value(value, {digits, offset});
    if (std::isnan(counts)) {
        RC_ASSERT(result == 0);
    } else {
        const double nearest = std::fmin(std::fmax(std::round(counts), -32768.0), 32767.0);
        RC_ASSERT(result == static_cast<int>(nearest));
    }
}

}  // namespace canproof::test
