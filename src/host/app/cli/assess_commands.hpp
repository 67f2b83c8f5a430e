// The commands that judge: fuzz, audit, coverage, misra, evidence, mutate, diff.
#pragma once

#include <memory>

#include "host/app/cli/command.hpp"

namespace CLI {
class App;
}

namespace canproof::host {

/// Adds them to `app`. The result owns their options: keep it until what was chosen is done.
std::shared_ptr<void> add_assess_commands(CLI::App& app, Chosen& chosen);

}  // namespace canproof::host
