// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/command_tree.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "host/base/utf8.hpp"
#include "host/selection/built_in.hpp"

namespace canproof::host {

namespace {

/// Kinds that `audit --kind` selects: of requirements, of other items, and two that are no items.
const std::vector<std::string> audited_kinds{"functional", "range",           "timing",      "protocol", "fault",
                                             "physical",   "storage",         "requirement", "object",   "table",
                                             "constant",   "enumeration",     "signal",      "decision", "hazard",
                                             "statement",  "condition-of-use"};

/// Returns the values that an option or argument takes, when there are only a few. CLI11 writes the set of an option
/// into the option's type, for example `TEXT:{eds,xdd}`.
std::vector<std::string> values_of(const CLI::Option& option) {
    if (option.get_positional() && option.get_name(true).rfind("DEVICE", 0) == 0) {
        return device_names();
    }
    if (option.check_lname("kind")) {
        return audited_kinds;
    }
    const std::string type = option.get_type_name();
    const auto first = type.find('{');
    const auto last = type.find('}');
    return first == std::string::npos || last == std::string::npos
               ? std::vector<std::string>{}
               : CLI::detail::split(type.substr(first + 1, last - first - 1), ',');
}

OptionWords words_of(const CLI::Option& option) {
    OptionWords made;
    made.positional = option.get_positional();
    made.name = made.positional ? option.get_name(true) : "--" + option.get_lnames().front();
    made.description = option.get_description();
    made.required = option.get_required();
    made.takes_value = option.get_items_expected_max() > 0;
    made.values = values_of(option);
    return made;
}

void add_command(const CLI::App& app, const std::vector<std::string>& path, std::vector<CommandWords>& into) {
    CommandWords made;
    made.path = path;
    made.description = app.get_description();
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional() || !option->get_lnames().empty()) {
            made.options.push_back(words_of(*option));
        }
    }
    const auto below = app.get_subcommands([](const CLI::App*) { return true; });
    for (const CLI::App* one : below) {
        made.below.push_back(one->get_name());
    }
    into.push_back(made);
    for (const CLI::App* one : below) {
        auto longer = path;
        longer.push_back(one->get_name());
        add_command(*one, longer, into);
    }
}

/// The command that the words of a command line name, such as `canproof eds check`.
struct NamedCommand {
    std::string path{"canproof"};
    std::size_t count{0};  ///< number of the words that name it
};

NamedCommand named_command(const CLI::App& app, const std::vector<std::string>& words) {
    const CLI::App* at = &app;
    NamedCommand named;
    for (const auto& word : words) {
        const auto found = at->get_subcommands([&word](const CLI::App* one) { return one->get_name() == word; });
        if (found.empty()) {
            break;
        }
        at = found.front();
        named.path += " " + word;
        ++named.count;
    }
    return named;
}

}  // namespace

std::string CommandWords::joined(const std::string& between) const {
    return fmt::format("{}", fmt::join(path, between));
}

std::vector<CommandWords> command_tree(const CLI::App& app) {
    std::vector<CommandWords> all;
    add_command(app, {}, all);
    return all;
}

std::string usage_error_words(const CLI::App& app, const std::vector<std::string>& words, const std::string& what) {
    return fmt::format("{}; `{} --help` lists arguments and options", shown_text(what), named_command(app, words).path);
}

std::string no_command_words(const CLI::App& app, const std::vector<std::string>& words) {
    const auto [path, count] = named_command(app, words);
    if (count < words.size()) {
        return fmt::format("there is no command `{0} {1}`; `{0} --help` lists the commands", path, words[count]);
    }
    return fmt::format("`{0}` needs a command; `{0} --help` lists the commands", path);
}

}  // namespace canproof::host
