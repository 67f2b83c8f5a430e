// Where links from code to the register stand: above what does it, few at a time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// The greatest number of items that one place may name.
constexpr std::size_t most_links = 3;

/// The links of one source that stand badly, each a sentence: more than `most_links` items in one place, or nothing
/// directly below that could do it (a function, a statement of it, a table, a member). `name` stands in the sentences.
std::vector<std::string> misplaced_in(const std::string& name, const std::vector<std::string>& lines);

/// Those of all sources of src/ below `root`. Throws InputError for a file that cannot be read.
std::vector<std::string> misplaced_links(const std::filesystem::path& root);

}  // namespace canproof::host
