// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/shell_completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

/// Returns the text in single quotes for a shell.
std::string quoted(const std::string& text) {
    std::string out{"'"};
    for (const char c : text) {
        out += c == '\'' ? std::string{"'\\''"} : std::string(1, c);
    }
    return out + "'";
}

/// Returns the words that may follow a command on the command line: its subcommands, then the values of its arguments
/// and its options.
std::vector<std::string> words_behind(const CommandWords& command) {
    std::vector<std::string> words = command.below;
    for (const auto& option : command.options) {
        if (option.positional) {
            words.insert(words.end(), option.values.begin(), option.values.end());
        } else {
            words.push_back(option.name);
        }
    }
    return words;
}

/// Returns the words of a command, each behind a slash; nothing for the program itself.
std::string place_of(const CommandWords& command) {
    return command.path.empty() ? "" : "/" + command.joined("/");
}

/// Returns the cases of a shell's `case` statement for words behind an option that takes a value: `offered` is set to
/// the option's values. Without a fixed set of values, the shell offers files. `text` writes the values.
template <typename Text>
std::string value_cases(const std::vector<CommandWords>& commands, const Text& text) {
    std::string cases;
    for (const auto& command : commands) {
        for (const auto& option : command.options) {
            if (!option.positional && option.takes_value) {
                cases += fmt::format("    {}) offered={} ;;\n", quoted(place_of(command) + " " + option.name),
                                     text(option.values));
            }
        }
    }
    return cases;
}

/// Returns the patterns of a shell's `case` statement, such as `/run|/eds/check`, one for each command.
std::string paths_of(const std::vector<CommandWords>& commands) {
    std::vector<std::string> paths;
    for (const auto& command : commands) {
        if (!command.path.empty()) {
            paths.push_back("/" + command.joined("/"));
        }
    }
    return fmt::format("{}", fmt::join(paths, "|"));
}

std::string bash_completion(const std::vector<CommandWords>& commands) {
    std::string cases;
    for (const auto& command : commands) {
        cases += fmt::format("    {}) offered={} ;;\n", command.path.empty() ? "''" : place_of(command),
                             quoted(fmt::format("{}", fmt::join(words_behind(command), " "))));
    }
    const std::string values = value_cases(
        commands, [](const std::vector<std::string>& all) { return quoted(fmt::format("{}", fmt::join(all, " "))); });
    return fmt::format(
        "# bash completion of canproof; source it, or write it to /etc/bash_completion.d/canproof\n"
        "_canproof() {{\n  local place= offered= at\n"
        "  for ((at = 1; at < COMP_CWORD; at++)); do\n"
        "    case \"$place/${{COMP_WORDS[at]}}\" in\n      {}) place=\"$place/${{COMP_WORDS[at]}}\" ;;\n    esac\n  "
        "done\n"
        "  case \"$place\" in\n{}  esac\n"
        "  local word=${{COMP_WORDS[COMP_CWORD]}} last=${{COMP_WORDS[COMP_CWORD-1]}}\n"
        "  [ \"$last\" = = ] && last=${{COMP_WORDS[COMP_CWORD-2]}}  # bash divides --option=value\n"
        "  [ \"$word\" = = ] && word=\n"
        "  case \"$place $last\" in\n{}  esac\n"
        "  mapfile -t COMPREPLY < <(compgen -W \"$offered\" -- \"$word\")\n"
        "}}\ncomplete -o default -o bashdefault -F _canproof canproof\n",
        paths_of(commands), cases, values);
}

/// Returns `word:description` in quotes for zsh's _describe.
std::string described(const std::string& word, const std::string& description) {
    return quoted(word + ":" + description);
}

std::string zsh_completion(const std::vector<CommandWords>& commands) {
    const auto description_of = [&](const CommandWords& command, const std::string& name) {
        auto path = command.path;
        path.push_back(name);
        const auto found =
            std::find_if(commands.begin(), commands.end(), [&path](const auto& one) { return one.path == path; });
        return found == commands.end() ? std::string{} : found->description;
    };
    std::string cases;
    for (const auto& command : commands) {
        std::vector<std::string> all;
        for (const auto& name : command.below) {
            all.push_back(described(name, description_of(command, name)));
        }
        for (const auto& option : command.options) {
            if (!option.positional) {
                all.push_back(described(option.name, option.description));
            }
            for (const auto& value : option.positional ? option.values : std::vector<std::string>{}) {
                all.push_back(described(value, option.description));
            }
        }
        cases += fmt::format("    {}) offered=({}) ;;\n", command.path.empty() ? "''" : place_of(command),
                             fmt::join(all, " "));
    }
    const std::string values = value_cases(
        commands, [](const std::vector<std::string>& all) { return fmt::format("({})", fmt::join(all, " ")); });
    return fmt::format(
        "#compdef canproof\n# zsh completion of canproof; write it to _canproof in a folder of $fpath\n"
        "_canproof() {{\n  local place= word\n  local -a offered\n"
        "  for word in \"${{(@)words[2,CURRENT-1]}}\"; do\n    case \"$place/$word\" in\n"
        "      {}) place=\"$place/$word\" ;;\n    esac\n  done\n  case \"$place\" in\n{}  esac\n"
        "  case \"$place $words[CURRENT-1]\" in\n{}  esac\n"
        "  _describe canproof offered || _files\n}}\n"
        "if [[ \"$funcstack[1]\" = _canproof ]]; then _canproof \"$@\"; else compdef _canproof canproof; fi\n",
        paths_of(commands), cases, values);
}

std::string fish_completion(const std::vector<CommandWords>& commands) {
    std::string text =
        "# fish completion of canproof; write it to ~/.config/fish/completions/canproof.fish\n"
        "function __canproof_at\n"
        "  set -l place ''\n"
        "  for word in (commandline -opc)[2..-1]\n"
        "    contains -- \"$place/$word\" $__canproof_commands; and set place \"$place/$word\"\n"
        "  end\n"
        "  test \"$place\" = \"$argv[1]\"\nend\n";
    std::vector<std::string> paths;
    for (const auto& command : commands) {
        if (!command.path.empty()) {
            paths.push_back(quoted(place_of(command)));
        }
    }
    text += fmt::format("set -g __canproof_commands {}\n", fmt::join(paths, " "));
    for (const auto& command : commands) {
        const std::string at = fmt::format("-n \"__canproof_at '{}'\"", place_of(command));
        if (!command.path.empty()) {
            auto above = command;
            above.path.pop_back();
            text += fmt::format("complete -c canproof -n \"__canproof_at '{}'\" -a {} -d {}\n", place_of(above),
                                quoted(command.path.back()), quoted(command.description));
        }
        for (const auto& option : command.options) {
            const std::string values =
                option.values.empty() ? "" : " -a " + quoted(fmt::format("{}", fmt::join(option.values, " ")));
            if (!option.positional) {
                const char* const value = !option.takes_value ? "" : values.empty() ? " -r" : " -x";
                text += fmt::format("complete -c canproof {} -l {}{}{} -d {}\n", at, option.name.substr(2), value,
                                    values, quoted(option.description));
            } else if (!values.empty()) {
                text += fmt::format("complete -c canproof {}{} -d {}\n", at, values, quoted(option.description));
            }
        }
    }
    return text;
}

/// Returns the text escaped for roff: backslashes, hyphens (as minus signs), and a control character at the beginning.
std::string roff(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\') {
            out += "\\e";
        } else if (c == '-') {
            out += "\\-";
        } else {
            out += c;
        }
    }
    return !out.empty() && (out.front() == '.' || out.front() == '\'') ? "\\&" + out : out;
}

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](const unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string synopsis_of(const CommandWords& command) {
    std::string text = "canproof";
    for (const auto& word : command.path) {
        text += " " + word;
    }
    for (const auto& option : command.options) {
        if (option.positional) {
            text += option.required ? " " + option.name : " [" + option.name + "]";
        }
    }
    return text + " [OPTION…]";
}

/// Returns references to the pages of all commands, in roff.
std::string other_pages(const std::vector<CommandWords>& commands) {
    std::string text;
    for (const auto& command : commands) {
        if (command.path.size() == 1) {
            text += fmt::format("{}.BR {} (1)", text.empty() ? "" : ",\n", roff("canproof-" + command.path.front()));
        }
    }
    return text + "\n";
}

}  // namespace

std::string shell_completion(const std::vector<CommandWords>& commands, const std::string& shell) {
    return shell == "zsh"    ? zsh_completion(commands)
           : shell == "fish" ? fish_completion(commands)
                             : bash_completion(commands);
}

std::string manual_page(const std::vector<CommandWords>& commands, const std::vector<std::string>& path,
                        const std::string& version) {
    const auto is_below = [&](const CommandWords& one) {
        return one.path.size() >= path.size() && std::equal(path.begin(), path.end(), one.path.begin());
    };
    const auto first = std::find_if(commands.begin(), commands.end(), is_below);
    if (first == commands.end()) {
        throw InputError{
            fmt::format("there is no command `{}`; `canproof --help` lists the commands", fmt::join(path, " "))};
    }
    const std::string name = path.empty() ? "canproof" : "canproof-" + first->joined("-");
    std::string text = fmt::format(
        ".TH {} 1 \"\" \"canproof {}\" \"User commands\"\n.SH NAME\n{} \\- {}\n", roff(upper(name)), roff(version),
        roff(name),
        roff(path.empty() ? "four CANopen devices, generated from their requirements" : first->description));
    text += path.empty() ? ".SH SYNOPSIS\n.B canproof\n.I COMMAND\n[OPTION…]\n.SH COMMANDS\n" : ".SH COMMANDS\n";
    for (const auto& command : commands) {
        if (command.path.empty() || !is_below(command)) {
            continue;
        }
        text += fmt::format(".SS \"{}\"\n{}.\n", roff(synopsis_of(command)), roff(command.description));
        for (const auto& option : command.options) {
            if (!option.description.empty()) {
                text += fmt::format(".TP\n.B {}{}\n{}.\n", roff(option.name),
                                    option.takes_value && !option.positional ? " VALUE" : "", roff(option.description));
            }
        }
    }
    text +=
        ".SH EXIT STATUS\n0: done without a finding. 1: a gap, a fault or a failed case. 2: wrong use, or an "
        "input or output that cannot be read or written. `fuzz` also ends with 130 when interrupted.\n";
    return text + ".SH SEE ALSO\n" + (path.empty() ? other_pages(commands) : ".BR canproof (1)\n");
}

std::map<std::string, std::string> manual_pages(const std::vector<CommandWords>& commands, const std::string& version) {
    std::map<std::string, std::string> pages;
    for (const auto& command : commands) {
        if (command.path.size() <= 1) {
            const std::string name = command.path.empty() ? "canproof" : "canproof-" + command.path.front();
            pages[name + ".1"] = manual_page(commands, command.path, version);
        }
    }
    return pages;
}

}  // namespace canproof::host
