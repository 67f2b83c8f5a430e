// SPDX-License-Identifier: Apache-2.0
// Checks that no output of a command is one of its other files.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

/// Throws InputError when an output is the same file as an input, as another output, or as a file that standard input
/// or output is redirected to. Compares the files and not their names: two names may lead to one file. A device such as
/// /dev/null may be named several times. Ignores empty names and names of inputs that do not exist.
void refuse_same_file(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

}  // namespace canproof::host
