// SPDX-License-Identifier: Apache-2.0
// Writes a text as a TOML string.
#pragma once

#include <string>

namespace canproof::host {

/// Returns the text in quotation marks as a basic string of TOML. Control characters become \uXXXX.
std::string toml_string(const std::string& text);

}  // namespace canproof::host
