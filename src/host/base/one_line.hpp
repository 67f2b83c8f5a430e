// SPDX-License-Identifier: Apache-2.0
// Converts text to a single line.
#pragma once

#include <string>

namespace canproof::host {

/// Returns the text on one line: each run of spaces, tabs and line breaks becomes one space, and none is left at either
/// end.
std::string one_line(const std::string& text);

/// Returns a text of at most 90 bytes unchanged. Otherwise returns the first words of the text, as many as fit in 90
/// bytes, and ` …`. A first word of more than 90 bytes is cut after its last whole character (UTF-8).
std::string brief(const std::string& text);

}  // namespace canproof::host
