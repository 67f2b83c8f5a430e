// SPDX-License-Identifier: Apache-2.0
// Starts a program that ends with this program, however this program ends.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace canproof::host {

/// Starts a program with these descriptors as its standard input and output, in its own process group. The kernel kills
/// the program when the calling thread ends, also when a signal kills this program. `words` contains the program (a
/// path, or a name to find in PATH) and its arguments. Throws InputError when the program cannot be started.
pid_t start_dependent_process(const std::vector<std::string>& words, int in, int out);

}  // namespace canproof::host
