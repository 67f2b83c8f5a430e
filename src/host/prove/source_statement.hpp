// SPDX-License-Identifier: Apache-2.0
// A statement of a harness as it stands in its source.
#pragma once

#include <string>

namespace canproof::host::prove {

/// `place` is `file:line`, from the current folder: the text from that line to its first semicolon, in one line. Empty
/// where there is no such line.
std::string statement_at(const std::string& place);

}  // namespace canproof::host::prove
