// SPDX-License-Identifier: Apache-2.0
// Determines the nesting depth of a TOML text before it is parsed.
#pragma once

#include <optional>
#include <string>

namespace canproof::host {

/// Greatest nesting depth; the register needs four levels. The parser makes a table for each part of a dotted key and
/// recurses over them.
constexpr unsigned deepest_toml = 32;

/// Returns the line of the first key with more parts, or of the first value in more brackets, than `deepest_toml`;
/// nothing when there is none.
std::optional<unsigned> too_deep_in(const std::string& text);

}  // namespace canproof::host
