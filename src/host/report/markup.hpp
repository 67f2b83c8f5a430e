// SPDX-License-Identifier: Apache-2.0
// Formats text and numbers for HTML and SVG.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace canproof::host {

/// Returns the text with escaped `& < > "`, for use in elements and in attributes in double quotes.
std::string escaped(const std::string& text);

/// Returns a text in sentences as markup: escaped, with `code` between a pair of backticks as a `<code>` element.
std::string prose(const std::string& text);
/// Does the same as prose() above, but uses `plain` to convert the text outside of backticks.
std::string prose(const std::string& text, const std::function<std::string(const std::string&)>& plain);

/// Returns a name as markup that a browser may divide before a capital that follows a small letter, and after `_`, `/`
/// and `.`.
std::string breakable(const std::string& name);

/// Returns a decimal number with groups of three digits: `-1,234,567.8`.
std::string grouped(std::string number);
std::string grouped(std::uint64_t number);

}  // namespace canproof::host
