// SPDX-License-Identifier: Apache-2.0
// The commands that assess the project: fuzz, audit, coverage, misra, evidence, mutate, inject, diff, prove.
#pragma once

#include <memory>

#include "host/app/cli/command.hpp"

namespace CLI {
class App;
}

namespace canproof::host {

/// Adds the commands to `app`. The returned object owns their options: keep it until the chosen command has run.
std::shared_ptr<void> add_assess_commands(CLI::App& app, Chosen& chosen);

}  // namespace canproof::host
