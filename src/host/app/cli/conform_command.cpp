// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/conform_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "generated/version.hpp"
#include "host/app/cli/make_bus.hpp"
#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"
#include "host/base/replace_folder.hpp"
#include "host/base/standard_streams.hpp"
#include "host/conform/link/bus_target.hpp"
#include "host/conform/link/virtual_target.hpp"
#include "host/conform/report/report_files.hpp"
#include "host/conform/report/report_records.hpp"
#include "host/conform/run/run_cases.hpp"
#include "host/datasheet/read_eds.hpp"
#include "host/selection/built_in.hpp"
#include "host/selection/chosen_devices.hpp"

namespace canproof::host {

namespace {

using conform::CaseResult;
using conform::Verdict;

int list_cases(const conform::CaseBook& book, const bool json) {
    if (json) {
        auto all = nlohmann::ordered_json::array();
        for (const conform::Case& one : book.cases) {
            all.push_back({{"id", one.id}, {"service", one.group}, {"public", one.numbers}, {"shows", one.shows}});
        }
        fmt::print("{}\n", nlohmann::ordered_json{{"cases", all}}.dump(2));
        return 0;
    }
    for (const conform::Case& one : book.cases) {
        fmt::print("{:<10} {:<44} {:<8} {}\n", one.group, one.id, fmt::format("{}", fmt::join(one.numbers, ",")),
                   one.shows);
    }
    return 0;
}

/// Returns the test cases in `folder`, or the built-in test cases if `folder` is empty. Throws InputError, which lists
/// every fault of the files.
conform::CaseBook read_cases(const std::string& folder) {
    if (folder.empty()) {
        return conform::built_in_cases();
    }
    std::map<std::string, std::string> files;
    for (const auto& file : open_folder(folder)) {
        if (file.path().extension() == ".toml") {
            files[file.path().string()] = read_file(file.path(), longest_toml_file);
        }
    }
    Faults faults;
    conform::CaseBook book = conform::parse_cases(files, faults);
    std::string faults_text;
    for (const Fault& one : faults) {
        faults_text += "\n" + one.text();
    }
    if (!faults_text.empty() || book.cases.empty()) {
        throw InputError{
            fmt::format("the cases in {} cannot be used:{}", folder,
                        faults_text.empty() ? " there is no case; write a .toml file with a [[case]]" : faults_text)};
    }
    return book;
}

ChosenDevice choose(const ConformCommandOptions& options) {
    ChosenDevice chosen = options.eds.empty() ? choose_device(options.device) : choose_eds(options.eds);
    if (options.node) {
        set_node(chosen, *options.node);
    }
    return chosen;
}

/// Parses a node-ID, 1 to 127. Throws InputError.
std::uint8_t node_of(const std::string& text) {
    const bool number = !text.empty() && text.size() <= 3 && text.find_first_not_of("0123456789") == std::string::npos;
    const int node = number ? std::stoi(text) : 0;
    if (node < 1 || node > 127) {
        throw InputError{fmt::format("`{}` is no node-ID; write --node 5 (1 to 127)", text)};
    }
    return static_cast<std::uint8_t>(node);
}

/// Returns the data sheet in the file `options.eds`. If no file is given, returns that of `device`, a name in the
/// catalogue.
conform::ConformSheet sheet_for(const ConformCommandOptions& options, const std::string& device) {
    if (!options.eds.empty()) {
        conform::ConformSheet sheet = conform::read_sheet(read_file(options.eds, longest_eds_file), options.eds, 1);
        sheet.node_id = options.node ? node_of(*options.node) : static_cast<std::uint8_t>(sheet.part.info.node_id);
        return sheet;
    }
    const Part& part = device_named(device);
    conform::ConformSheet sheet = conform::sheet_of(built_in_register(), part);
    sheet.node_id = options.node ? node_of(*options.node) : sheet.node_id;
    return sheet;
}

std::unique_ptr<conform::Target> virtual_target(ChosenDevice chosen, const ConformCommandOptions& options,
                                                const conform::ConformSheet& sheet) {
    const std::uint32_t rate = chosen.bit_rate == 0 ? conform::VirtualTarget::usual_bit_rate : chosen.bit_rate;
    const std::string name = options.arm.empty() ? "virtual time"
                                                 : fmt::format("virtual time, {} in QEMU",
                                                               std::filesystem::path{options.arm}.filename().string());
    return std::make_unique<conform::VirtualTarget>(std::move(chosen.device), sheet.node_id, rate, name);
}

std::unique_ptr<conform::Target> bus_target(const ConformCommandOptions& options, const conform::ConformSheet& sheet) {
    const bool socketcan = options.bus.rfind("socketcan:", 0) == 0;
    if (!socketcan && options.bus.rfind("socketcand-client:", 0) != 0) {
        throw InputError{fmt::format(
            "`{}` is no bus to test on; write --bus socketcan:can0 or --bus socketcand-client:127.0.0.1:29536",
            options.bus)};
    }
    RunOptions running;
    running.bus = options.bus;
    std::unique_ptr<Bus> bus = make_bus(running, static_cast<std::uint32_t>(sheet.part.info.bit_rate));
    bus->on_notice(tell);
    auto target = std::make_unique<conform::BusTarget>(std::move(bus), options.bus);
    if (!socketcan) {
        target->leave_out_remote_frames();
    }
    if (options.by_hand) {
        target->switch_by_hand(STDIN_FILENO, tell);
    }
    return target;
}

/// Checks that the options name a slave either by its name in the catalogue or by a file. Checks that they do not name
/// both an image (the program of an emulated slave) and a bus. Throws InputError.
void check_slave(const ConformCommandOptions& options) {
    const bool has_file = !options.eds.empty() || !options.arm.empty();
    if (options.device.empty() == !has_file) {
        throw InputError{
            fmt::format("{}: `canproof conform ax188001`, or `canproof conform --eds box.eds --node 5 --bus …`",
                        has_file ? "name the slave either by a device or by files, not by both"
                                 : "name the slave to test, by a device or by a file")};
    }
    if (!options.arm.empty() && !options.bus.empty()) {
        throw InputError{
            "--arm runs the slave in virtual time and cannot use --bus; leave out one of them, or put the image on a "
            "bus with `canproof run --arm`"};
    }
}

conform::ConformOptions run_options(const ConformCommandOptions& options) {
    const bool everything = options.bus.empty();
    conform::ConformOptions running;
    running.only = options.only;
    running.skip = options.skip;
    running.cases = options.cases;
    running.allow_outputs = everything || options.allow_outputs;
    running.allow_store = everything || options.allow_store;
    running.allow_lss = everything || options.allow_lss;
    running.traffic = options.traffic;
    if (!options.json) {
        running.progress = [](const CaseResult& one) {
            fmt::print("{}\n", conform::result_line(one));
            std::fflush(stdout);
        };
    }
    return running;
}

bool is_of_a_report(const std::filesystem::directory_entry& entry) {
    static const std::set<std::string> records{"junit.xml", "report.json", "report.txt"};
    const std::filesystem::path name = entry.path().filename();
    return entry.is_regular_file() && (name.extension() == ".html" || records.count(name.string()) != 0);
}

/// Checks that the report may replace this folder: it is absent or empty, or it contains only an earlier report. Throws
/// InputError for any other folder.
void check_report_folder(const std::filesystem::path& folder) {
    check_replaceable(folder);
    if (!std::filesystem::exists(folder) || std::filesystem::is_empty(folder)) {
        return;
    }
    const std::filesystem::directory_iterator entries = open_folder(folder);
    if (!std::filesystem::exists(folder / "report.json") ||
        !std::all_of(begin(entries), end(entries), is_of_a_report)) {
        throw InputError{fmt::format(
            "{} contains files that belong to no report; name an empty folder or one that does not exist yet",
            folder.string())};
    }
}

}  // namespace

int run_conform(const ConformCommandOptions& options) {
    const conform::CaseBook book = read_cases(options.folder);
    if (options.list) {
        return list_cases(book, options.json);
    }
    check_slave(options);
    std::optional<ChosenDevice> image;
    if (!options.arm.empty()) {
        image = choose_image(options.arm);
    }
    if (options.by_hand && options.bus.empty()) {
        throw InputError{
            "--by-hand needs --bus, because in virtual time the program itself switches the slave off and on; add "
            "--bus, or remove --by-hand"};
    }
    if (!options.report.empty()) {
        check_report_folder(options.report);
    }
    const conform::ConformSheet sheet = sheet_for(options, image ? image->part->name : options.device);
    const std::unique_ptr<conform::Target> target =
        options.bus.empty() ? virtual_target(image ? std::move(*image) : choose(options), options, sheet)
                            : bus_target(options, sheet);
    if (options.no_remote_frames) {
        target->leave_out_remote_frames();
    }
    conform::ConformReport report = conform::run_cases(book, sheet, *target, run_options(options));
    report.program = fmt::format("canproof {}", generated::canproof_version);
    if (options.json) {
        fmt::print("{}", conform::write_json(report));
    } else {
        fmt::print("{}", conform::summary_lines(report));
    }
    if (!options.report.empty()) {
        replace_folder(options.report, conform::report_files(report));
    }
    return report.exit_status();
}

}  // namespace canproof::host
