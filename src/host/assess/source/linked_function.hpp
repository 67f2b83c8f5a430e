// SPDX-License-Identifier: Apache-2.0
// Finds the code to which a link applies. A link is a static_assert with implements<> for a requirement, and applies to
// the function or the statements directly below it.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace canproof::host {

/// The first and the last line of a range. Lines count from 1; both are 0 when there is no line.
using LineRange = std::pair<std::size_t, std::size_t>;

/// Returns the lines of the function below the link (implements<> assertion) at line `link`. For a link inside a
/// function, returns the lines of the statements below it. They end with the first block that they open, or with the
/// block around the link, whichever ends first. `lines` must come from code_only().
LineRange function_below(const std::vector<std::string>& lines, std::size_t link);

/// Returns the lines of the condition on which the code at line `link` runs: the head of the innermost `if`, `for`,
/// `while` or `switch` around this code. For code in an `else`, this is the head of its `if`. Returns no line when the
/// innermost block is that of a function. `lines` must come from code_only().
LineRange condition_around(const std::vector<std::string>& lines, std::size_t link);

}  // namespace canproof::host
