// SPDX-License-Identifier: Apache-2.0
// Checks the places of links (implements<> assertions, which name requirements). Each link must be directly above the
// implementing code, and only few may be in one place.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// The greatest number of items that the links at one place in the code may name.
constexpr std::size_t most_links = 3;

/// Returns one sentence for each badly placed link (implements<> assertion) of a source. `name` is the source's name in
/// the sentences. A place is bad if its links name more than `most_links` items, or if neither a function nor a
/// statement in a function follows directly.
std::vector<std::string> misplaced_in(const std::string& name, const std::vector<std::string>& lines);

/// Returns the badly placed links of all sources in src/ below `root`. Throws InputError for a file that cannot be
/// read.
std::vector<std::string> misplaced_links(const std::filesystem::path& root);

}  // namespace canproof::host
