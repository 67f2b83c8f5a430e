// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/math_block.hpp"

#include <cmath>
#include <cstdint>

#include "devices/ax130751/firmware/number_order.hpp"
#include "devices/ax130751/firmware/quotient.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax130751/constants.hpp"
#include "generated/ax130751/requirements.hpp"
#include "generated/ax130751/tables.hpp"

namespace canproof::ax130751 {

namespace {

using Operation = generated::ax130751::math_operator::Operation;

constexpr double truth(const bool value) noexcept {
    return value ? 1.0 : 0.0;
}

/// Clamps `value`, which must not be NaN, to `least`…`most`.
double held_within(const double value, const double least, const double most) noexcept {
    const std::uint64_t order = order_of(value);
    if (order < order_of(least)) {
        return least;
    }
    return (order > order_of(most)) ? most : value;
}

bool is_unchanged(const MathFunction& before, const MathFunction& now) noexcept {
    return is_same(before.value, now.value) && is_same(before.with_sign, now.with_sign);
}

Operation operation_of(const std::uint8_t number) noexcept {
    namespace table = generated::ax130751::math_operator;
    return cell_or(table::find(number), &table::Row::operation, Operation::plus);
}

double compare(const Operation operation, const double a, const double b) noexcept {
    switch (operation) {
        case Operation::equal:
            return truth(is_same(a, b));
        case Operation::not_equal:
            return truth(!is_same(a, b));
        case Operation::greater:
            return truth(a > b);
        case Operation::greater_or_equal:
            return truth(a >= b);
        case Operation::less:
            return truth(a < b);
        case Operation::less_or_equal:
        default:
            return truth(a <= b);
    }
}

double combine(const Operation operation, const bool a, const bool b) noexcept {
    switch (operation) {
        case Operation::logic_or:
            return truth(a || b);
        case Operation::logic_nor:
            return truth(!(a || b));
        case Operation::logic_and:
            return truth(a && b);
        case Operation::logic_nand:
            return truth(!(a && b));
        case Operation::logic_xor:
            return truth(a != b);
        case Operation::logic_xnor:
        default:
            return truth(a == b);
    }
}

static_assert(implements<req::AOR_MATH_004>);
double calculate(const Operation operation, const double a, const double b) noexcept {
    switch (operation) {
        case Operation::minus:
            return a - b;
        case Operation::times:
            return a * b;
        case Operation::divided_by:
            return is_same(b, 0.0) ? 0.0 : quotient(a, b);
        case Operation::minimum:
            return std::fmin(a, b);
        case Operation::maximum:
            return std::fmax(a, b);
        case Operation::plus:
        default:
            return a + b;
    }
}

/// Clamps a result, so that a feedback loop of quotients and products never becomes infinite or NaN. A result near 0
/// counts as 0: a loop that fades would otherwise reach subnormal numbers, whose products take many instructions.
static_assert(implements<req::AOR_MATH_022> && implements<req::AOR_MATH_027>);
double held_finite(const double value) noexcept {
    constexpr double bound = 1.0e9;
    constexpr double least = 1.0e-290;
    const double held = held_within(value, -bound, bound);
    return (order_of(std::fabs(held)) < order_of(least)) ? 0.0 : held;
}

}  // namespace

static_assert(implements<req::AOR_MATH_001> && implements<req::AOR_MATH_006> && implements<req::AOR_MATH_018>);
double math_fraction(const MathInput& input) noexcept {
    if ((!input.signal.is_valid()) || is_same(input.scaling_1, input.scaling_2)) {
        return 0.0;
    }
    const double fraction = quotient(input.signal.value - input.scaling_1, input.scaling_2 - input.scaling_1);
    // Rounds to millionths, so that equal inputs stay equal after different scalings.
    constexpr double steps = 1000000.0;
    const double held = greater(fraction, 0.0);  // 0 also for NaN
    static_assert(implements<req::AOR_MATH_017> && implements<req::AOR_MATH_021>);
    return quotient(std::round(held_within(held, 0.0, 1.0) * steps), steps);
}

static_assert(implements<req::AOR_T21> && implements<req::AOR_MATH_003> && implements<req::AOR_MATH_012>);
double apply_operator(const std::uint8_t number, const double a, const double b) noexcept {
    const Operation operation = operation_of(number);
    const double true_from = generated::ax130751::true_from;
    switch (operation) {
        case Operation::equal:
        case Operation::not_equal:
        case Operation::greater:
        case Operation::greater_or_equal:
        case Operation::less:
        case Operation::less_or_equal:
            return compare(operation, a, b);
        case Operation::logic_or:
        case Operation::logic_nor:
        case Operation::logic_and:
        case Operation::logic_nand:
        case Operation::logic_xor:
        case Operation::logic_xnor:
            return combine(operation, a >= true_from, b >= true_from);
        case Operation::plus:
        case Operation::minus:
        case Operation::times:
        case Operation::divided_by:
        case Operation::minimum:
        case Operation::maximum:
        default:
            return calculate(operation, a, b);
    }
}

static_assert(implements<req::AOR_MATH_013> && implements<req::AOR_MATH_009> && implements<req::AOR_MATH_014>);
double MathBlock::input_value(const MathInput& input) const noexcept {
    if ((input.own_function == 0U) || (input.own_function > math_functions)) {
        static_assert(implements<req::AOR_MATH_019>);
        return math_fraction(input) * input.gain;
    }
    static_assert(implements<req::AOR_MATH_015>);
    const MathFunction& fed_back = results_[input.own_function - 1U];
    const bool is_inverted = input.gain < 0.0;  // a negative difference keeps its sign only with a negative gain (1.7)
    static_assert(implements<req::AOR_MATH_026>);
    return (is_inverted ? fed_back.with_sign : fed_back.value) * input.gain;
}

static_assert(implements<req::AOR_MATH_002> && implements<req::AOR_MATH_007>);
MathResult MathBlock::advance(const MathConfig& config) noexcept {
    // Function n combines the result of the chain so far with input n + 1; the chain begins with input 1.
    const MathInput& first = config.inputs[0U];
    bool chained = first.signal.is_available();
    double chain = input_value(first);
    bool negative_gain = first.gain < 0.0;
    MathResult result{};
    const std::array<MathFunction, math_functions> before{results_};
    for (std::size_t function = 0U; function < math_functions; ++function) {
        const MathInput& second = config.inputs[function + 1U];
        static_assert(implements<req::AOR_MATH_023>);
        const std::uint8_t number = config.operators[function];
        const bool done = chained && second.signal.is_available();
        if (done) {
            const double raw = held_finite(apply_operator(number, chain, input_value(second)));
            const bool signed_result = negative_gain || (second.gain < 0.0);
            static_assert(implements<req::AOR_MATH_005>);
            const bool held_at_0 = (!signed_result) && (raw < 0.0) && (operation_of(number) == Operation::minus);
            chain = held_at_0 ? 0.0 : raw;
            results_[function] = MathFunction{chain, raw};
            negative_gain = false;
            result = MathResult{chain, true};
        } else {
            results_[function] = MathFunction{};
        }
        // Without input 2, function 1 has no result, and the other functions have no first operand.
        static_assert(implements<req::AOR_MATH_016>);
        chained = chained && (done || (function != 0U));
    }
    settled_ = is_unchanged(before[0U], results_[0U]) && is_unchanged(before[1U], results_[1U]) &&
               is_unchanged(before[2U], results_[2U]);
    return result;
}

static_assert(implements<req::AOR_MATH_008> && implements<req::AOR_MATH_024>);
double math_output(const double fraction, const double scaling_1, const double scaling_2) noexcept {
    return scaling_1 + (held_within(fraction, 0.0, 1.0) * (scaling_2 - scaling_1));
}

}  // namespace canproof::ax130751
