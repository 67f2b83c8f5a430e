// SPDX-License-Identifier: Apache-2.0
// Finds the passages of a manual that marks identify.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include "host/assess/manual/manual_text.hpp"
#include "host/register/mark.hpp"

namespace canproof::host {

/// Returns the positions in `text.letters()` at which the passage of each mark begins; marks that are not found are
/// left out. A passage begins with a word. If a mark has places that end with a word, its other places are left out.
std::map<Mark, std::vector<std::size_t>> find_marks(const ManualText& text, const std::set<Mark>& marks);

}  // namespace canproof::host
