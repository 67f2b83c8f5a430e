// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/command_tree.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "host/base/utf8.hpp"

namespace canproof::host {

namespace {

OptionWords words_of(const CLI::Option& option) {
    OptionWords made;
    made.positional = option.get_positional();
    made.name = made.positional ? option.get_name(true) : "--" + option.get_lnames().front();
    made.description = option.get_description();
    made.required = option.get_required();
    made.takes_value = option.get_items_expected_max() > 0;
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
    const CLI::App* at = &app;
    std::string path = "canproof";
    for (const auto& word : words) {
        const auto found = at->get_subcommands([&word](const CLI::App* one) { return one->get_name() == word; });
        if (found.empty()) {
            break;
        }
        at = found.front();
        path += " " + word;
    }
    return fmt::format("{}; `{} --help` lists arguments and options", shown_text(what), path);
}

std::string no_command_words(const CLI::App& app, const std::vector<std::string>& words) {
    const CLI::App* at = &app;
    std::string path = "canproof";
    for (const auto& word : words) {
        const auto found = at->get_subcommands([&word](const CLI::App* one) { return one->get_name() == word; });
        if (found.empty()) {
            return fmt::format("there is no command `{0} {1}`; `{0} --help` lists the commands", path, word);
        }
        at = found.front();
        path += " " + word;
    }
    return fmt::format("`{0}` needs a command; `{0} --help` lists the commands", path);
}

}  // namespace canproof::host
