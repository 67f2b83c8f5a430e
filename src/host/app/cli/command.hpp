// How a command becomes part of the command line.
#pragma once

#include <functional>

namespace canproof::host {

/// What the program does once the words are read; it returns the exit status.
using Chosen = std::function<int()>;

/// Base of the commands: each owns its options, which its callbacks name.
class Command {
  public:
    Command() = default;
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;
};

}  // namespace canproof::host
