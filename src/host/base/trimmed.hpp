// Text without blanks at its ends.
#pragma once

#include <string>
#include <string_view>

namespace canproof::host {

/// Returns the part of the text between the characters of `blanks` at its two ends. It refers to `text`.
std::string_view trimmed_view(std::string_view text, std::string_view blanks = " \t");

/// Returns the same part as a text of its own.
std::string trimmed(std::string_view text, std::string_view blanks = " \t");

}  // namespace canproof::host
