// SPDX-License-Identifier: Apache-2.0
// Determines the nesting depth of a TOML text before it is parsed.
#pragma once

#include <optional>
#include <string>

namespace canproof::host {

/// Greatest nesting depth of a TOML text. The register needs four levels. The parser makes a table for each part of a
/// dotted key and handles these tables by recursion.
constexpr unsigned deepest_toml = 32;

/// Returns the line of the first key with more than `deepest_toml` parts, or of the first value in more than
/// `deepest_toml` brackets. Returns nothing when there is none.
std::optional<unsigned> too_deep_in(const std::string& text);

}  // namespace canproof::host
