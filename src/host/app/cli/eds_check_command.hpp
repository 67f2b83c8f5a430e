// `canproof eds check`: what is wrong in a data sheet, and the sheet with the safe fixes.
#pragma once

#include <string>

namespace canproof::host {

struct EdsCheckOptions {
    std::string file;
    std::string fix;     ///< where to write the fixed sheet; empty: nowhere
    bool json{false};    ///< findings as JSON
    bool strict{false};  ///< warnings count as errors for the exit status
    bool rules{false};   ///< print every rule instead
};

/// Prints the findings; with `fix` those that are left in the fixed sheet, and what was fixed. Returns 1 for a finding
/// of severity error (with `strict` for any), else 0. Throws InputError for a file that cannot be read, is no EDS, or
/// cannot be written.
int check_eds_file(const EdsCheckOptions& options);

}  // namespace canproof::host
