// SPDX-License-Identifier: Apache-2.0
// A statement of a harness as it stands in its source.
#pragma once

#include <string>

namespace canproof::host::prove {

/// Returns the text from the line `place` (`file:line`, from the current folder) to its first semicolon, as one line.
/// Returns an empty text when there is no such line.
std::string statement_at(const std::string& place);

}  // namespace canproof::host::prove
