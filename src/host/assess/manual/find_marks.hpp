// Where the passages of a manual stand that marks name.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include "host/assess/manual/manual_text.hpp"
#include "host/register/mark.hpp"

namespace canproof::host {

/// The positions in `text.letters()` at which the passage of each mark begins; a mark that is not found is left out. A
/// passage begins with a word. One that ends with a word hides the places of the same mark that do not.
std::map<Mark, std::vector<std::size_t>> find_marks(const ManualText& text, const std::set<Mark>& marks);

}  // namespace canproof::host
