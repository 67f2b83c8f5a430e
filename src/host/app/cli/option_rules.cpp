// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/option_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>

#include "host/base/number_text.hpp"
#include "host/base/utf8.hpp"

namespace canproof::host {

namespace {

/// Longest time that an option accepts, in seconds. Below this limit, neighbouring doubles are less than 1 µs apart.
constexpr double most_seconds = 4.0e9;

bool has_any_name(const CLI::Option& option, const std::vector<std::string>& names) {
    return std::any_of(names.begin(), names.end(), [&option](const auto& name) { return option.check_name(name); });
}

/// Returns the fault of a text that is not a whole number from 0 to 2^64 - 1; an empty text without a fault.
std::string whole_number_fault(const std::string& text) {
    char* end = nullptr;
    errno = 0;
    static_cast<void>(std::strtoull(text.c_str(), &end, 0));  // as CLI11 reads it: 16, 0x10 or 020
    const bool whole = text.find_first_of("0123456789") == 0 && errno == 0 && *end == '\0';
    return whole ? "" : fmt::format("`{}` is no whole number from 0 to {}", text, UINT64_MAX);
}

/// Returns the options and arguments of `command` that have none of these names, without --help and --version.
std::vector<CLI::Option*> all_but(CLI::App& command, std::vector<std::string> names) {
    names.insert(names.end(), {"--help", "--version"});
    return command.get_options([&names](const CLI::Option* one) { return !has_any_name(*one, names); });
}

}  // namespace

CLI::Validator number_from(const double low, const double high) {
    return {[low, high](const std::string& text) -> std::string {
                const auto value = decimal_number(text);
                const bool fits = value && *value >= low && *value <= high;
                return fits ? "" : fmt::format("`{}` is not a number from {} to {}", text, low, high);
            },
            fmt::format("NUMBER in [{} - {}]", low, high)};
}

CLI::Validator seconds_check() {
    return {[](const std::string& text) -> std::string {
                const auto value = decimal_number(text);
                const bool fits = value && *value >= 0.0 && *value <= most_seconds;
                return fits ? "" : text + " is no time from 0 to 4000000000 seconds; write a number such as 1.5";
            },
            "SECONDS"};
}

CLI::Validator utf8_text() {
    return {[](const std::string& text) -> std::string {
                return is_utf8(text) ? "" : fmt::format("`{}` is not UTF-8", shown_text(text));
            },
            ""};
}

void check_values(CLI::App& app) {
    const CLI::Validator not_empty{
        [](const std::string& text) -> std::string {
            return text.empty() ? "the value is empty; write a value, or leave the option out" : "";
        },
        ""};
    for (CLI::Option* const option : all_but(app, {"--land"})) {
        if (option->get_items_expected_max() > 0) {
            option->check(not_empty);
        }
        if (option->get_type_name().rfind("UINT", 0) == 0) {
            option->check(CLI::Validator{whole_number_fault, ""});
        }
    }
    for (CLI::App* const command : app.get_subcommands([](const CLI::App*) { return true; })) {
        check_values(*command);
    }
}

void stands_alone(CLI::App& command, CLI::Option* option, const std::vector<std::string>& allowed) {
    for (CLI::Option* const other : all_but(command, allowed)) {
        if (other != option) {
            option->excludes(other);
        }
    }
}

void leaves_out_options(CLI::App& command, CLI::App& below, const std::vector<std::string>& allowed) {
    for (CLI::Option* const option : all_but(command, allowed)) {
        below.excludes(option);
    }
}

}  // namespace canproof::host
