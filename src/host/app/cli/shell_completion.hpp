// SPDX-License-Identifier: Apache-2.0
// Makes the shell completion and the manual pages from the definition of the command line.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/app/cli/command_tree.hpp"

namespace canproof::host {

/// Returns the script that a shell (bash, zsh or fish) sources. It offers commands, options and files.
std::string shell_completion(const std::vector<CommandWords>& commands, const std::string& shell);

/// Returns a manual page in roff: canproof(1) for an empty `path`; otherwise the page of that command and its
/// subcommands, for example canproof-eds(1). Throws InputError when there is no such command.
std::string manual_page(const std::vector<CommandWords>& commands, const std::vector<std::string>& path,
                        const std::string& version);

/// Returns the page of the program and of each command that is no subcommand, by file name: `canproof-eds.1`.
std::map<std::string, std::string> manual_pages(const std::vector<CommandWords>& commands, const std::string& version);

}  // namespace canproof::host
