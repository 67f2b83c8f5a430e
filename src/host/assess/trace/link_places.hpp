// SPDX-License-Identifier: Apache-2.0
// Checks the places of links, the implements<> assertions that name requirements: each is directly above the
// implementing code, and few are in one place.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// The greatest number of items that the links at one place in the code may name.
constexpr std::size_t most_links = 3;

/// Returns one sentence, which contains `name`, for each badly placed link of one source. A place is bad if it has more
/// than `most_links` items. It is also bad if no function, and no statement in a function, follows directly.
std::vector<std::string> misplaced_in(const std::string& name, const std::vector<std::string>& lines);

/// Returns the badly placed links of all sources in src/ below `root`. Throws InputError for a file that cannot be
/// read.
std::vector<std::string> misplaced_links(const std::filesystem::path& root);

}  // namespace canproof::host
