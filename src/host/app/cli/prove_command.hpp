// SPDX-License-Identifier: Apache-2.0
// The `prove` command: proves theorems about the firmware with the program canproof-prove in the same folder.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

/// Starts canproof-prove with the arguments `words` and waits for its end. Returns its exit status. Throws InputError
/// when the program does not exist.
int prove(const std::vector<std::string>& words);

}  // namespace canproof::host
