// SPDX-License-Identifier: Apache-2.0
// The commands `spec check` and `spec statements`: faults of the requirements register, and the statements of a manual.
#include "host/app/cli/spec_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "host/app/cli/sound_register.hpp"
#include "host/assess/manual/text_coverage.hpp"
#include "host/assess/trace/audit_filter.hpp"
#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"
#include "host/base/standard_streams.hpp"
#include "host/register/advice.hpp"
#include "host/register/embedded_spec.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

namespace {

std::size_t count_items(const Register& content) {
    std::size_t items = 0;
    for (const auto& part : content.parts) {
        content.for_each_item(part, [&](const Item&, const char*) { ++items; });
    }
    return items;
}

const Manual& manual_with_statements(const std::string& key, const Register& content) {
    const Manual& manual = manual_with(key, content);
    if (manual.statements.empty()) {
        throw InputError{fmt::format("{} has no statements; write them below {}/", key,
                                     std::filesystem::path{manual.place.file}.replace_extension().generic_string())};
    }
    return manual;
}

void print_statement(const Manual& manual, const Statement& statement) {
    const char* state = statement.is_open() ? "open" : statement.reason.empty() ? "covered" : "explained";
    fmt::print("  {:<22} {:<10} {}\n", statement.id(manual.key), state, statement.text);
    if (!statement.is_open()) {
        fmt::print("  {:<22} {:<10} {}\n", "", "",
                   statement.reason.empty() ? fmt::format("[{}]", fmt::join(statement.covered, ", "))
                                            : fmt::format("({})", statement.reason));
    }
}

int print_by_section(const Manual& manual) {
    std::map<const Section*, std::vector<const Statement*>> by_section;
    std::size_t open = 0;
    for (const auto& statement : manual.statements) {
        by_section[manual.describing(statement.section)].push_back(&statement);
        open += statement.is_open() ? 1 : 0;
    }
    std::size_t bare = 0;
    for (const auto& section : manual.sections) {
        const auto found = by_section.find(&section);
        const bool is_bare = found == by_section.end();
        if (is_bare && !section.normative) {
            continue;
        }
        fmt::print("{} {}{}\n", section.ref, section.title, is_bare ? ": normative, and no statement" : "");
        bare += is_bare ? 1 : 0;
        for (const auto* statement : is_bare ? std::vector<const Statement*>{} : found->second) {
            print_statement(manual, *statement);
        }
    }
    fmt::print("{} statement(s), {} open; {} normative section(s) without a statement\n", manual.statements.size(),
               open, bare);
    return open + bare == 0 ? 0 : 1;
}

int print_coverage(const Manual& manual, const std::string& file) {
    constexpr std::size_t longest_manual = std::size_t{4} << 20U;
    const TextCoverage found = cover_text(manual, read_file(file, longest_manual));
    for (const auto& mark : found.missing) {
        fmt::print("passage not in the text: {}\n", mark);
    }
    for (const auto& ref : found.not_located) {
        fmt::print("no heading of section {}: its text counts as part of the section before\n", ref);
    }
    for (const auto& line : found.uncovered) {
        fmt::print("{}: {}: {}\n", line.line, line.section, line.words);
    }
    fmt::print("{} passage(s), {} not in the text\n", found.marks, found.missing.size());
    fmt::print("letters and digits of normative sections: {:.1f} % of {} covered, {} line(s) not fully covered\n",
               found.normative.percent(), found.normative.all, found.uncovered.size());
    fmt::print("letters and digits of the whole text: {:.1f} % of {} covered\n", found.whole.percent(),
               found.whole.all);
    return found.missing.empty() ? 0 : 1;
}

void print_check(const Faults& faults, const Faults& advice, std::size_t items, std::size_t statements) {
    for (const auto& fault : faults) {
        tell(fault.text());
    }
    for (const auto& one : advice) {
        tell("warning: " + one.text());
    }
    const std::size_t left_out = faults.left_out() + advice.left_out();
    if (left_out != 0) {
        tell(fmt::format("{} more fault(s) and warning(s) are not listed", left_out));
    }
    fmt::print("{} item(s), {} statement(s), {} fault(s), {} warning(s)\n", items, statements,
               faults.size() + faults.left_out(), advice.size() + advice.left_out());
}

nlohmann::ordered_json json_of(const Faults& faults, const char* what) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const auto& fault : faults) {
        all.push_back({{"file", fault.place.file}, {"line", fault.place.line}, {what, fault.what}, {"fix", fault.fix}});
    }
    return all;
}

void print_check_json(const Faults& faults, const Faults& advice, std::size_t items, std::size_t statements) {
    const nlohmann::ordered_json json{{"items", items},
                                      {"statements", statements},
                                      {"faults", json_of(faults, "fault")},
                                      {"warnings", json_of(advice, "warning")},
                                      {"left_out", faults.left_out() + advice.left_out()}};
    fmt::print("{}\n", json.dump(2));
}

}  // namespace

int check_spec(const SpecCheckOptions& options) {
    if (!std::filesystem::is_directory(options.spec)) {
        throw InputError{fmt::format("{} is no folder; name the register with --spec", options.spec)};
    }
    const SpecFiles files = read_spec_files(options.spec);
    if (files.empty()) {
        throw InputError{fmt::format("{} has no .toml file; name the folder of a register with --spec", options.spec)};
    }
    const LoadResult loaded = load_register(with_shared_rules(files, embedded_spec()));
    const Faults advice = loaded.faults.empty() ? advice_on(loaded.content) : Faults{};
    const std::size_t items = count_items(loaded.content);
    if (items == 0 && loaded.faults.empty()) {
        throw InputError{fmt::format("the register in {} has no items; name another folder with --spec", options.spec)};
    }
    std::size_t statements = 0;
    for (const auto& manual : loaded.content.manuals) {
        statements += manual.statements.size();
    }
    if (options.json) {
        print_check_json(loaded.faults, advice, items, statements);
    } else {
        print_check(loaded.faults, advice, items, statements);
    }
    return loaded.faults.empty() && (advice.empty() || !options.strict) ? 0 : 1;
}

int list_statements(const StatementsOptions& options) {
    const Register content = sound_register(options.spec);
    const Manual& manual = manual_with_statements(options.key, content);
    return options.text.empty() ? print_by_section(manual) : print_coverage(manual, options.text);
}

}  // namespace canproof::host
