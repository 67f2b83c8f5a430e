#include "host/cli/chosen_devices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

#include "host/bus/candump.hpp"
#include "host/cli/built_in.hpp"
#include "host/cli/eds_device.hpp"
#include "host/devices/generic_simulation.hpp"

namespace canproof::host {

namespace {

constexpr int highest_node_id = 127;

/// The number behind @; 255 stands for a device whose switches or LSS give it none.
int node_of(const std::string& text, const std::string& whole) {
    const bool number = !text.empty() && text.size() <= 3 && text.find_first_not_of("0123456789") == std::string::npos;
    if (!number || std::stoi(text) > 255) {
        throw InputError{fmt::format("`{}` in {} is no node-ID; write NAME@1 … NAME@127", text, whole)};
    }
    return std::stoi(text);
}

ChosenDevice from_catalogue(const Part& part) {
    ChosenDevice chosen;
    chosen.name = part.name;
    chosen.device = make_device(part.name);
    chosen.part = &part;
    chosen.bit_rate = static_cast<std::uint32_t>(part.info.bit_rate);
    return chosen;
}

}  // namespace

ChosenDevice choose_device(const std::string& text) {
    const auto at = text.find('@');
    ChosenDevice chosen = from_catalogue(device_named(text.substr(0, at)));
    if (chosen.device == nullptr) {
        throw InputError{fmt::format("{} cannot be run; `canproof devices` says which can", text.substr(0, at))};
    }
    chosen.name = text;
    if (at != std::string::npos) {
        chosen.device->set_node_id(node_of(text.substr(at + 1), text));
    }
    return chosen;
}

ChosenDevice choose_eds(const std::string& text) {
    const auto at = text.rfind('@');
    const std::string path = text.substr(0, at);
    auto device = read_eds_device(path);
    ChosenDevice chosen;
    chosen.name = std::filesystem::path{path}.stem().string();
    if (at != std::string::npos) {
        device->set_node_id(node_of(text.substr(at + 1), text));
        chosen.name += text.substr(at);
    }
    chosen.part = &device->part();
    chosen.bit_rate = static_cast<std::uint32_t>(chosen.part->info.bit_rate);
    chosen.device = std::move(device);
    return chosen;
}

std::vector<ChosenDevice> choose_catalogue() {
    std::vector<ChosenDevice> all;
    std::set<int> taken;
    for (const Part& part : built_in_register().parts) {
        ChosenDevice one = part.is_device() ? from_catalogue(part) : ChosenDevice{};
        if (one.device == nullptr) {
            continue;
        }
        int node = part.info.node_id;
        for (int free = 1; taken.count(node) != 0 && free <= highest_node_id; ++free) {
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
