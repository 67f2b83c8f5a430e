// The command line as data: what completion and the manual page are made from.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace canproof::host {

struct OptionWords {
    std::string name;  ///< `--bus`, or that of a positional, `DEVICE`
    std::string description;
    bool takes_value{false};
    bool positional{false};
};

struct CommandWords {
    std::vector<std::string> path;  ///< `eds`, `check`; empty for the program itself
    std::string description;
    std::vector<OptionWords> options;
    std::vector<std::string> below;  ///< names of subcommands

    /// The path with this between its words.
    std::string joined(const std::string& between) const;
};

/// The program and each command below it, a command before those below it.
std::vector<CommandWords> command_tree(const CLI::App& app);

}  // namespace canproof::host
