// Text that goes into one line.
#pragma once

#include <string>

namespace canproof::host {

/// On one line: each run of spaces, tabs and line ends is one space, none at either end.
std::string one_line(const std::string& text);

/// The text, or its first words, about 90 characters, and `…`.
std::string brief(const std::string& text);

}  // namespace canproof::host
