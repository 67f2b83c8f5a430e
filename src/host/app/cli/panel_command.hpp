// SPDX-License-Identifier: Apache-2.0
// `canproof panel`: devices in real time, shown on a local page.
#pragma once

#include <cstdint>

#include "host/app/cli/run_command.hpp"

namespace canproof::host {

struct PanelOptions {
    RunOptions run;            ///< options of the run; the panel ignores `plain` and `seconds`
    std::uint16_t port{8404};  ///< port number; 0: any free port
};

/// Runs the panel until it is interrupted. Returns the exit status.
int run_panel(const PanelOptions& options);

}  // namespace canproof::host
