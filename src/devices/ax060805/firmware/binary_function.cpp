// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/firmware/binary_function.hpp"

#include <cmath>
#include <limits>

#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

namespace table9 = generated::ax060805::unary_function;
namespace table10 = generated::ax060805::binary_function;

constexpr std::uint32_t bits_of_discrete = 32U;

constexpr float truth(const bool value) noexcept {
    return value ? 1.0F : 0.0F;
}

static_assert(implements<req::INC_BIN_017>);
Signal defined_unless_nan(const float value) noexcept {
    return std::isnan(value) ? undefined_signal() : continuous_signal(value);
}

static_assert(implements<req::INC_BIN_005>);
float quotient(const float x, const float y) noexcept {
    return (y == 0.0F) ? 0.0F : (x / y);
}

float real_function(const BinaryFunction function, const float x, const float y) noexcept {
    switch (function) {
        case BinaryFunction::add:
            return x + y;
        case BinaryFunction::subtract:
            return x - y;
        case BinaryFunction::multiply:
            return x * y;
        case BinaryFunction::divide:
            return quotient(x, y);
        case BinaryFunction::maximum:
            return (x >= y) ? x : y;
        case BinaryFunction::minimum:
            return (x <= y) ? x : y;
        case BinaryFunction::equal:
            return truth((x <= y) && (x >= y));
        case BinaryFunction::not_equal:
            return truth((x < y) || (x > y));
        case BinaryFunction::greater:
            return truth(x > y);
        case BinaryFunction::greater_equal:
            return truth(x >= y);
        case BinaryFunction::less:
            return truth(x < y);
        case BinaryFunction::less_equal:
            return truth(x <= y);
        default:
            return std::numeric_limits<float>::quiet_NaN();  // undefined
    }
}

static_assert(implements<req::INC_BIN_005> && implements<req::INC_BIN_006>);
std::uint32_t integer_function(const BinaryFunction function, const std::uint32_t x, const std::uint32_t y) noexcept {
    switch (function) {
        case BinaryFunction::modulus:
            return (y == 0U) ? 0U : (x % y);
        case BinaryFunction::logical_or:
            return ((x != 0U) || (y != 0U)) ? 1U : 0U;
        case BinaryFunction::logical_and:
            return ((x != 0U) && (y != 0U)) ? 1U : 0U;
        case BinaryFunction::bitwise_or:
            return x | y;
        case BinaryFunction::bitwise_and:
            return x & y;
        case BinaryFunction::bitwise_xor:
            return x ^ y;
        case BinaryFunction::shift_left:
            return (y < bits_of_discrete) ? (x << y) : 0U;
        case BinaryFunction::shift_right:
        default:
            return (y < bits_of_discrete) ? (x >> y) : 0U;
    }
}

/// Returns an operand of the binary function after the operand's unary function, scale and offset; undefined when the
/// input has neither a signal nor a default.
Signal operand(const FunctionInput& input) noexcept {
    if (!is_defined(input.source) && !input.has_default) {
        return undefined_signal();
    }
    const float taken = is_defined(input.source) ? as_continuous(input.source) : input.default_value;
    return continuous_signal((input.linear.scale * apply_unary(input.unary, taken)) + input.linear.offset);
}

}  // namespace

static_assert(implements<req::INC_BIN_003> && implements<req::INC_T9>);
float apply_unary(const std::uint8_t number, const float x) noexcept {
    const auto* const row = table9::find(number);
    const UnaryFunction function = cell_or(row, &table9::Row::function, UnaryFunction::none);
    const bool of_integer = cell_or(row, &table9::Row::operand, table9::Operand::real) == table9::Operand::integer;
    const std::uint32_t whole = of_integer ? to_discrete(x) : 0U;
    const float operand = of_integer ? static_cast<float>(whole) : x;
    switch (function) {
        case UnaryFunction::logical_not:
            return truth(whole == 0U);
        case UnaryFunction::bitwise_not:
            return static_cast<float>(~whole);
        case UnaryFunction::absolute:
            return std::fabs(operand);
        case UnaryFunction::none:
        default:
            return operand;
    }
}

static_assert(implements<req::INC_BIN_004> && implements<req::INC_T10> && implements<req::INC_BIN_007>);
Signal apply_binary(const std::uint8_t number, const float x, const float y) noexcept {
    const auto* const row = table10::find(number);
    static_assert(implements<req::INC_BIN_017>);
    if ((row == nullptr) || std::isnan(x) || std::isnan(y)) {
        return undefined_signal();
    }
    if (row->operands == table10::Operands::integer) {
        return continuous_signal(static_cast<float>(integer_function(row->function, to_discrete(x), to_discrete(y))));
    }
    return defined_unless_nan(real_function(row->function, x, y));
}

static_assert(implements<req::INC_BIN_001> && implements<req::INC_BIN_002> && implements<req::INC_BIN_014>);
Signal evaluate(const FunctionBlock& block) noexcept {
    const Signal first = operand(block.inputs[0]);
    const Signal second = operand(block.inputs[1]);
    if (!is_defined(first) || !is_defined(second)) {
        return undefined_signal();
    }
    const Signal result = apply_binary(block.operation, first.continuous, second.continuous);
    if (!is_defined(result)) {
        return undefined_signal();
    }
    return defined_unless_nan((block.output.scale * result.continuous) + block.output.offset);
}

}  // namespace canproof::ax060805
