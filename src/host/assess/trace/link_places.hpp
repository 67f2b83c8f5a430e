// Where links from code to the register stand: above what does it, few at a time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// The greatest number of requirements that one place of the firmware names today. It falls as lists move to `by` in
/// the register or to the functions that do it; the aim is 3.
constexpr std::size_t most_links = 20;

/// The links of one source that stand badly, each a sentence: more than `most` requirements in one place, or nothing
/// directly below that could do it (a function, a table, a member). `name` stands in the sentences.
std::vector<std::string> misplaced_in(const std::string& name, const std::vector<std::string>& lines, std::size_t most);

/// Those of all sources of src/ below `root`. Throws InputError for a file that cannot be read.
std::vector<std::string> misplaced_links(const std::filesystem::path& root, std::size_t most = most_links);

}  // namespace canproof::host
