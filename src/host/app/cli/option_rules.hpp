// SPDX-License-Identifier: Apache-2.0
// Rules for the options of all commands: no option has an empty value, and no option is ignored silently.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace canproof::host {

/// Returns a check of a number from `low` to `high`, which no other text passes (CLI::Range() accepts `nan`).
CLI::Validator number_from(double low, double high);
/// Returns a check of a time in seconds.
CLI::Validator seconds_check();
/// Returns a check of a text that the command writes into a file of the project.
CLI::Validator utf8_text();
/// Refuses an empty value of each option and argument of `app` and of its commands: without this check, a command would
/// take '' as "no such option was given". Only `fuzz --land` has a meaning for ''. Also refuses a value of an option
/// without sign that is no such number: CLI11 takes -1 as the greatest number.
void check_values(CLI::App& app);
/// Refuses `option` together with any other option or argument of `command`, except `allowed` and --help.
void stands_alone(CLI::App& command, CLI::Option* option, const std::vector<std::string>& allowed);
/// Refuses the options and arguments of `command` together with `below`, its subcommand, except `allowed`.
void leaves_out_options(CLI::App& command, CLI::App& below, const std::vector<std::string>& allowed);

}  // namespace canproof::host
