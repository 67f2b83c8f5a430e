// SPDX-License-Identifier: Apache-2.0
// Types that each command uses to add itself to the command line.
#pragma once

#include <functional>

namespace canproof::host {

/// The action of the command that the user chose. It returns the exit status of the program.
using Chosen = std::function<int()>;

/// Base of the commands. A command owns its options and cannot be copied, because its callbacks point to these options.
class Command {
  public:
    Command() = default;
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;
};

}  // namespace canproof::host
