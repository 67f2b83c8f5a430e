// SPDX-License-Identifier: Apache-2.0
// `canproof eds check`: checks a data sheet. Can also write a copy with those fixes that do not change its meaning.
#pragma once

#include <string>

namespace canproof::host {

struct EdsCheckOptions {
    std::string file;
    std::string fix;     ///< file to write the fixed data sheet to; empty: none
    bool json{false};    ///< findings as JSON
    bool strict{false};  ///< warnings count as errors for the exit status
    bool rules{false};   ///< prints every rule and checks no file
};

/// Prints the findings. With `fix`, writes the fixed sheet and prints what was fixed and which findings are left.
/// Returns 1 for a finding of severity error (with `strict` for any finding), else 0. Throws InputError for a file that
/// cannot be read, is no EDS, or cannot be written.
int check_eds_file(const EdsCheckOptions& options);

}  // namespace canproof::host
