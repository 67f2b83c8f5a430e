// SPDX-License-Identifier: Apache-2.0
// Removes blanks at both ends of a text.
#pragma once

#include <string>
#include <string_view>

namespace canproof::host {

/// Returns the text without the characters of `blanks` at its two ends. The result refers to `text`.
std::string_view trimmed_view(std::string_view text, std::string_view blanks = " \t");

/// Returns the same as trimmed_view(), but as a new string.
std::string trimmed(std::string_view text, std::string_view blanks = " \t");

}  // namespace canproof::host
