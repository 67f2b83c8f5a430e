// SPDX-License-Identifier: Apache-2.0
// The progress of a long command.
#pragma once

#include <cstddef>

namespace canproof::host {

/// Shows `done` of `all` in one line of standard error; without a terminal there, shows nothing.
void show_progress(std::size_t done, std::size_t all);

}  // namespace canproof::host
