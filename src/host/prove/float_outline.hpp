// SPDX-License-Identifier: Apache-2.0
// Facts that hold for a sum, product or quotient of two floating-point numbers without a computation: whether it is
// NaN, its sign, and how its size compares with those of the operands.
#pragma once

#include "host/prove/term_graph.hpp"

namespace canproof::host::prove {

enum class FloatJoin { sum, product, quotient };

/// Returns a condition that holds for each `result` of joining `a` and `b`, rounded to nearest as IEEE 754 defines it,
/// unless the result is NaN. Rounding is monotone and keeps a or b itself, so it keeps each of these comparisons.
Term outline_of(FloatJoin join, const Term& a, const Term& b, const Term& result);

/// Returns the bits of the result, computed by this processor. `width` is the width of a and b: 32 or 64.
Bits joined_bits(FloatJoin join, unsigned width, Bits a, Bits b);

/// Returns the condition under which joining `a` and `b` gives NaN: an operand is NaN, or the operation is inf - inf,
/// 0 * inf, 0 / 0 or inf / inf.
Term gives_nan(FloatJoin join, const Term& a, const Term& b);

/// Returns the bits of the double nearest to a signed integer of `width` bits, computed by this processor.
Bits double_bits(Bits integer, unsigned width);
/// Returns a condition that holds for the double nearest to a signed integer: its sign, and its bounds.
Term outline_of_integer(const Term& integer, const Term& result);

/// Returns the sign of a floating-point number: true for a negative one and for -0.
Term sign_of(const Term& number);
/// Returns the bits of a number with the sign +. Among numbers that are not NaN, these integers have the order of the
/// magnitudes.
Term magnitude_of(const Term& number);

}  // namespace canproof::host::prove
