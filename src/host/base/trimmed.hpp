// Text without blanks at its ends.
#pragma once

#include <string>
#include <string_view>

namespace canproof::host {

/// Returns the text without the characters of `blanks` at its two ends.
std::string trimmed(std::string_view text, std::string_view blanks = " \t");

}  // namespace canproof::host
