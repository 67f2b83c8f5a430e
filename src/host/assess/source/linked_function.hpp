// SPDX-License-Identifier: Apache-2.0
// Finds the function directly below a link, which is a static_assert with implements<> for a requirement.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace canproof::host {

/// Returns the first and the last line of the function below line `link` of a source. Lines count from 1. Returns {0,
/// 0} when there is no function. `lines` must come from code_only().
std::pair<std::size_t, std::size_t> function_below(const std::vector<std::string>& lines, std::size_t link);

}  // namespace canproof::host
