// SPDX-License-Identifier: Apache-2.0
// Finds passages in the text of a manual by their marks. A mark is a short hash of a passage.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include "host/assess/manual/manual_text.hpp"
#include "host/register/mark.hpp"

namespace canproof::host {

/// Returns, for each mark, the positions in `text.letters()` at which its passage begins. Leaves out marks that are not
/// found. A passage begins at the start of a word. If a passage ends at the end of a word at some of these positions,
/// the other positions are left out.
std::map<Mark, std::vector<std::size_t>> find_marks(const ManualText& text, const std::set<Mark>& marks);

}  // namespace canproof::host
