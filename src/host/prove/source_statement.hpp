// SPDX-License-Identifier: Apache-2.0
// Reads a C++ statement of a harness from its source.
#pragma once

#include <string>

namespace canproof::host::prove {

/// Returns the text from the line `place` to its first semicolon, on one line. `place` is `file:line`, relative to the
/// current folder. Returns an empty text when there is no such line.
std::string statement_at(const std::string& place);

}  // namespace canproof::host::prove
