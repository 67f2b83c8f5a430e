// SPDX-License-Identifier: Apache-2.0
// Divides doubles. The FPU of a Cortex-M4F cannot divide doubles, and the division of the library takes up to 790
// instructions.
#pragma once

namespace canproof::ax130751 {

/// Returns dividend / divisor, rounded to the nearest double: the same number as the division of the language, with
/// these exceptions. Subnormal operands count as 0. A quotient below 4.5e-308 in size may become 0. One of 8.9e307 or
/// more may become infinity. 0 / 0 gives 0. Infinity divided by anything stays infinity.
double quotient(double dividend, double divisor) noexcept;

}  // namespace canproof::ax130751
