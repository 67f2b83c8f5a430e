// SPDX-License-Identifier: Apache-2.0
// Text in UTF-8.
#pragma once

#include <string>

namespace canproof::host {

/// Returns whether the text is UTF-8 (RFC 3629).
bool is_utf8(const std::string& text);
/// Returns the text as XML can contain it: the character U+FFFD replaces each byte that is not UTF-8, and each control
/// character.
std::string shown_text(const std::string& text);

}  // namespace canproof::host
