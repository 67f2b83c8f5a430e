// How deep a TOML text goes, before a parser sees it.
#pragma once

#include <optional>
#include <string>

namespace canproof::host {

/// The register goes four levels deep. The parser makes a table of each part of a dotted key, and recurses over them.
constexpr unsigned deepest_toml = 32;

/// Line of the first key of more parts, or value in more brackets, than `deepest_toml`; nothing when there is none.
std::optional<unsigned> too_deep_in(const std::string& text);

}  // namespace canproof::host
