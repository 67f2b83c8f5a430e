// SPDX-License-Identifier: Apache-2.0
// One binary function block (AX060805, 3.8): A F(a1 f1(X1) + b1, a2 f2(X2) + b2) + B.
//
// Every operation is total: it returns a value or an undefined signal for every bit pattern of its operands.
#pragma once

#include <array>
#include <cstddef>

#include "devices/ax060805/firmware/signal.hpp"
#include "generated/ax060805/tables.hpp"

namespace canproof::ax060805 {

using UnaryFunction = generated::ax060805::unary_function::Function;
using BinaryFunction = generated::ax060805::binary_function::Function;

/// A linear function: the scale applies first, then the offset.
struct Linear {
    float scale{1.0F};
    float offset{0.0F};
};

struct FunctionInput {
    Signal source{};
    bool has_default{false};
    float default_value{0.0F};  ///< used when the source is undefined and has_default is set
    std::uint8_t unary{0U};     ///< number in the manual's Table 9; an unknown function does not change the value
    Linear linear{};
};

struct FunctionBlock {
    std::array<FunctionInput, 2U> inputs{};
    std::uint8_t operation{0U};  ///< number in the manual's Table 10; the result of an unknown function is undefined
    Linear output{};
};

/// Applies a unary function of the manual's Table 9. Integer functions operate on to_discrete(x) and return a whole
/// number. An unknown function returns x.
float apply_unary(std::uint8_t number, float x) noexcept;

/// Applies a binary function of the manual's Table 10. The result is undefined for operation 0, for unknown operations,
/// and when an operand or the result is NaN.
Signal apply_binary(std::uint8_t number, float x, float y) noexcept;

/// Evaluates the block by the manual's equation 4. The result is undefined when an input has neither a signal nor a
/// default, when the operation is 0 or unknown, and when an operand or the result is NaN.
Signal evaluate(const FunctionBlock& block) noexcept;

}  // namespace canproof::ax060805
