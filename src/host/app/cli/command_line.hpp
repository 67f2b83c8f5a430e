// SPDX-License-Identifier: Apache-2.0
// The command line of the program canproof: runs the subcommand that the arguments name.
#pragma once

namespace canproof::host {

/// Runs the subcommand that the arguments name. Returns the exit status: 0 done, 1 the checked object has faults, 2
/// wrong use or unreadable input.
int run_command_line(int argc, char** argv);

}  // namespace canproof::host
