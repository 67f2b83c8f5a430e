// SPDX-License-Identifier: Apache-2.0
// Formats text and numbers for HTML and SVG.
#pragma once

#include <cstdint>
#include <string>

namespace canproof::host {

/// Returns the text with escaped `& < > "`, for use in elements and in attributes in double quotes.
std::string escaped(const std::string& text);

/// Returns a decimal number with groups of three digits: `-1,234,567.8`.
std::string grouped(std::string number);
std::string grouped(std::uint64_t number);

}  // namespace canproof::host
