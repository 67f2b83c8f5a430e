// SPDX-License-Identifier: Apache-2.0
#include "host/selection/chosen_devices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

#include "devices/catalogue.hpp"
#include "host/base/input_error.hpp"
#include "host/selection/built_in.hpp"
#include "host/selection/eds_device.hpp"
#include "host/sim/devices/generic_simulation.hpp"
#include "host/sim/image/image_device.hpp"
#include "host/sim/image/start_image.hpp"

namespace canproof::host {

namespace {

constexpr int most_switches = 255;

/// Returns the value of a decimal number of at most three digits; -1 for any other text.
int number_of(const std::string& text) {
    const bool number = !text.empty() && text.size() <= 3 && text.find_first_not_of("0123456789") == std::string::npos;
    return number ? std::stoi(text) : -1;
}

/// Returns where `@NODE` begins in FILE@NODE; npos without a node. An `@` in the name of a folder begins no node.
std::size_t place_of_node(const std::string& text) {
    const auto at = text.rfind('@');
    return at != std::string::npos && text.find('/', at) == std::string::npos ? at : std::string::npos;
}

ChosenDevice from_catalogue(const Part& part, const std::string& name, FactoryOptions& factory) {
    ChosenDevice chosen;
    chosen.name = name;
    chosen.device = make_device(part.name, factory.for_device(name, part));
    chosen.part = &part;
    chosen.bit_rate = static_cast<std::uint32_t>(part.info.bit_rate);
    return chosen;
}

}  // namespace

std::string file_of(const std::string& text) {
    return text.substr(0, place_of_node(text));
}

void set_node(ChosenDevice& chosen, const std::string& node) {
    const int number = number_of(node);
    const bool fits_switches = number >= 0 && number <= most_switches;
    chosen.notice.clear();
    if (fits_switches && chosen.device->set_coding_switches(static_cast<std::uint8_t>(number))) {
        if (number < NodeId::lowest || number > NodeId::highest) {
            chosen.notice = fmt::format(
                "{}: the coding switches are at {:02X}h, which is no node-ID; the application does not run, and the "
                "LEDs show this",
                chosen.name, number);
        }
    } else if (NodeId::is_one(number)) {
        chosen.device->set_node_id(number);
    } else {
        const bool has_switches = chosen.device->set_coding_switches(0);
        throw InputError{fmt::format("{}: `{}` is no node-ID; write {}", chosen.name, node,
                                     has_switches ? "0 to 255, the position of the coding switches" : node_id_words())};
    }
}

ChosenDevice choose_device(const std::string& text) {
    FactoryOptions none;
    return choose_device(text, none);
}

ChosenDevice choose_device(const std::string& text, FactoryOptions& factory) {
    const auto at = text.find('@');
    ChosenDevice chosen = from_catalogue(device_named(text.substr(0, at)), text, factory);
    if (chosen.device == nullptr) {
        throw InputError{
            fmt::format("{} cannot be run; `canproof devices` lists the devices that can be run", text.substr(0, at))};
    }
    if (at != std::string::npos) {
        set_node(chosen, text.substr(at + 1));
    }
    return chosen;
}

ChosenDevice choose_eds(const std::string& text) {
    const auto at = place_of_node(text);
    const std::string path = file_of(text);
    auto device = read_eds_device(path);
    ChosenDevice chosen;
    chosen.name = std::filesystem::path{path}.stem().string();
    chosen.part = &device->part();
    chosen.bit_rate = static_cast<std::uint32_t>(chosen.part->info.bit_rate);
    chosen.device = std::move(device);
    if (at != std::string::npos) {
        chosen.name += text.substr(at);
        set_node(chosen, text.substr(at + 1));
    }
    return chosen;
}

ChosenDevice choose_image(const std::string& text) {
    const auto at = place_of_node(text);
    const std::string node = at == std::string::npos ? "" : text.substr(at + 1);
    auto link = start_image(file_of(text));
    const ImageGreeting greeting = link->greeting();
    FactoryOptions none;
    ChosenDevice chosen =
        from_catalogue(device_named(greeting.device), greeting.device + (node.empty() ? "" : "@" + node), none);
    chosen.device = std::make_unique<ImageDevice>(std::move(link), greeting, std::move(chosen.device));
    if (at != std::string::npos) {
        set_node(chosen, node);
    }
    return chosen;
}

std::vector<ChosenDevice> choose_catalogue() {
    FactoryOptions none;
    return choose_catalogue(none);
}

std::vector<ChosenDevice> choose_catalogue(FactoryOptions& factory) {
    std::vector<ChosenDevice> all;
    std::set<int> taken;
    for (const Part& part : built_in_register().parts) {
        ChosenDevice one = part.is_device() ? from_catalogue(part, part.name, factory) : ChosenDevice{};
        if (one.device == nullptr) {
            continue;
        }
        int node = part.info.node_id;
        for (int free = 1; taken.count(node) != 0 && free <= NodeId::highest; ++free) {
            node = free;
        }
        taken.insert(node);
        if (node != part.info.node_id) {
            one.device->set_node_id(node);
        }
        all.push_back(std::move(one));
    }
    return all;
}

}  // namespace canproof::host
