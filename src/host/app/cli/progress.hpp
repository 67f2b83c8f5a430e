// SPDX-License-Identifier: Apache-2.0
// Shows the progress of a long command.
#pragma once

#include <cstddef>

namespace canproof::host {

/// Prints `done` of `all` as one line on standard error; prints nothing when standard error is not a terminal.
void show_progress(std::size_t done, std::size_t all);

}  // namespace canproof::host
