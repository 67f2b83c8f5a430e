// SPDX-License-Identifier: Apache-2.0
// The arguments that are common to the commands that run devices on a bus.
#pragma once

#include "host/app/cli/run_command.hpp"

namespace CLI {
class App;
}

namespace canproof::host {

inline constexpr const char* node_help =
    "NODE: 1…127; 255 for a device that needs a node-ID from LSS; coding switches (cbx-ao412) take 0…255";

inline constexpr const char* factory_help =
    "KEY=VALUE: a value that a unit gets in the factory, such as serial_number; `signals` lists the keys; "
    "DEVICE.KEY=VALUE for one device";

/// Adds the options that are common to `run` and `panel`. `running` must outlive the parsing of the command line.
void add_run_options(CLI::App& command, RunOptions& running);

}  // namespace canproof::host
