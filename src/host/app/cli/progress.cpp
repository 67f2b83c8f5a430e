// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

namespace canproof::host {

void show_progress(std::size_t done, std::size_t all) {
    if (isatty(STDERR_FILENO) != 0) {
        fmt::print(stderr, "\r{} of {}{}", done, all, done == all ? "\n" : "");
    }
}

}  // namespace canproof::host
