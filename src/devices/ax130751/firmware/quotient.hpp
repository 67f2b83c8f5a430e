// SPDX-License-Identifier: Apache-2.0
// Divides doubles. The FPU of a Cortex-M4F cannot divide doubles, and the division of the library takes up to 790
// instructions.
#pragma once

namespace canproof::ax130751 {

/// Returns dividend / divisor, rounded to the nearest double: the same number as the division of the language, except
/// far from all values of the device. A dividend, divisor or quotient below 4.5e-308 counts as 0, a quotient above
/// 4.4e307 as infinity, and so does a quotient by 0. An infinite dividend, or NaN, stays what it is.
double quotient(double dividend, double divisor) noexcept;

}  // namespace canproof::ax130751
