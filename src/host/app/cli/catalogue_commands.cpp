// SPDX-License-Identifier: Apache-2.0
// The commands `devices`, `signals` and `eds`, which print data of the requirements register.
#include "host/app/cli/catalogue_commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>

#include "devices/catalogue.hpp"
#include "host/base/input_error.hpp"
#include "host/datasheet/eds_values.hpp"
#include "host/datasheet/write_dbc.hpp"
#include "host/datasheet/write_dictionary.hpp"
#include "host/datasheet/write_eds.hpp"
#include "host/datasheet/write_xdd.hpp"
#include "host/selection/built_in.hpp"
#include "host/selection/eds_device.hpp"
#include "host/selection/factory_options.hpp"
#include "host/sim/devices/simulated_device.hpp"

namespace canproof::host {

namespace {

const Part& described_device(const std::string& name) {
    const Part& part = device_named(name);
    if (part.objects.empty()) {
        throw InputError{fmt::format(
            "{} cannot be used yet: the register contains the manual of the device, but not its objects; choose a "
            "device that `canproof devices` lists with `yes`",
            name)};
    }
    return part;
}

}  // namespace

int list_devices() {
    fmt::print("{:<12}{:<42}{:<12}{:<14}{}\n", "device", "part numbers", "node-ID", "bit rate", "runs");
    for (const auto& part : built_in_register().parts) {
        if (part.is_device()) {
            fmt::print("{:<12}{:<42}{:<12}{:<14}{}\n", part.name,
                       fmt::format("{}", fmt::join(part.info.part_numbers, ", ")), part.info.node_id,
                       fmt::format("{} bit/s", part.info.bit_rate),
                       make_device(part.name) == nullptr ? "not yet" : "yes");
            for (const std::string& variant : part.info.variants) {
                fmt::print("{:<12}{}\n", "", variant);
            }
        }
    }
    return 0;
}

namespace {

void list_factory_data(const Part& part, const std::string& part_number) {
    const auto keys = factory_keys(part, part_number);
    if (!keys.empty()) {
        fmt::print("\n{:<31}{:<16}{:<6}{:<26}{}\n", "factory data, --factory", "type", "unit", "range", "meaning");
    }
    for (const FactoryKey& key : keys) {
        fmt::print("{:<31}{:<16}{:<6}{:<26}{}\n", key.name, key.words.empty() ? key.type : "choice",
                   key.unit.size() < 6 ? key.unit : "", key.range(),
                   key.unit.size() < 6 ? key.text : fmt::format("{}, in {}", key.text, key.unit));
    }
}

}  // namespace

int list_signals(const std::string& device) {
    const Part& part = described_device(device);
    fmt::print("{:<23}{:<8}{:<11}{:<6}{:<18}{}\n", "signal", "", "type", "unit", "range", "meaning");
    for (const auto& signal : part.signals) {
        const std::string range =
            signal.minimum && signal.maximum ? fmt::format("{} … {}", *signal.minimum, *signal.maximum) : "";
        for (const auto& name : signal.names()) {
            fmt::print("{:<23}{:<8}{:<11}{:<6}{:<18}{}\n", name, signal.input ? "input" : "output", signal.type,
                       signal.unit, range, signal.text);
        }
    }
    list_factory_data(part, part_number_of(device, part));
    return 0;
}

namespace {

/// Returns whether the word is the path of a file and not a device name. A part number may contain a dot too.
bool names_file(const std::string& word) {
    return word.find_first_of("./") != std::string::npos && !is_device_name(word);
}

int print_dbc(const Part& part, int node) {
    const int shipped = part.info.node_id >= 1 && part.info.node_id <= 127 ? part.info.node_id : 1;
    std::cout << write_dbc(part, static_cast<unsigned>(node == 0 ? shipped : node));
    return 0;
}

}  // namespace

int print_eds(const EdsOptions& options) {
    if (options.format == "dbc") {
        return names_file(options.device) ? print_dbc(read_eds_part(options.device), options.node)
                                          : print_dbc(described_device(options.device), options.node);
    }
    if (options.node != 0) {
        throw InputError{
            "--node applies only to --format dbc, because a data sheet is the same for every node-ID; remove --node, "
            "or add --format dbc"};
    }
    const Part& part = described_device(options.device);
    const std::string& format = options.format;
    std::cout << (format == "json"       ? write_object_json(part)
                  : format == "md"       ? write_object_markdown(part)
                  : format == "xdd"      ? write_xdd(built_in_register(), part)
                  : format == "eds-lely" ? write_eds(built_in_register(), part, Reals::bits)
                                         : write_eds(built_in_register(), part));
    return 0;
}

}  // namespace canproof::host
