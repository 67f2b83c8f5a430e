// `canproof diff`: what the changes since a revision touch.
#pragma once

#include <string>

namespace canproof::host {

struct DiffOptions {
    std::string root{"."};
    std::string revision;
    std::string verdicts;
    std::string old_verdicts;
    bool json{false};
};

/// Prints items, code, tests and verdicts. Returns the exit status.
int diff(const DiffOptions& options);

}  // namespace canproof::host
