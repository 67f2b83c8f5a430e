// SPDX-License-Identifier: Apache-2.0
// The command line as data, from which the shell completion and the manual page are generated.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace canproof::host {

struct OptionWords {
    std::string name;  ///< such as `--bus`, or `DEVICE` for a positional argument
    std::string description;
    bool takes_value{false};
    bool positional{false};
    bool required{false};
    std::vector<std::string> values;  ///< all values of a fixed set, or the names of the devices; empty: any value
};

struct CommandWords {
    std::vector<std::string> path;  ///< words of the command, for example `eds`, `check`; empty for the program
    std::string description;
    std::vector<OptionWords> options;
    std::vector<std::string> below;  ///< names of the direct subcommands

    /// Returns the words of the path with `between` as separator.
    std::string joined(const std::string& between) const;
};

/// Returns the program and all its commands. A command is before its subcommands.
std::vector<CommandWords> command_tree(const CLI::App& app);

/// Returns one line for words of a user that CLI11 refuses with the message `what`. The line names the `--help` of the
/// command that the words begin with.
std::string usage_error_words(const CLI::App& app, const std::vector<std::string>& words, const std::string& what);

/// Returns the error message for words of a user that lead to no command: one word is unknown, or a subcommand is
/// missing. The message names the `--help` that lists the commands.
std::string no_command_words(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace canproof::host
