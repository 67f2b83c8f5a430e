// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace canproof::host {

/// Returns the value of a decimal number such as `-12`, `0.5` or `1e-3`. Returns nothing for any other text: an empty
/// one, one with blanks, a hexadecimal number, infinity, NaN, or a number that is too large for a double.
std::optional<double> decimal_number(const std::string& text);

/// Returns the value of a decimal number, or of a hexadecimal integer of up to 16 digits such as `0x1F`. Returns
/// nothing for any other text.
std::optional<double> decimal_or_hexadecimal(const std::string& text);

}  // namespace canproof::host
