// SPDX-License-Identifier: Apache-2.0
#include "host/selection/own_stimuli.hpp"

#include <fmt/format.h>

#include <map>

#include "host/base/input_error.hpp"
#include "host/selection/built_in.hpp"

namespace canproof::host {

namespace {

/// A device as a user writes it: NAME or NAME@NODE.
struct DeviceName {
    std::string name;
    std::string node;  ///< without leading zeros; empty: not given
};

std::string without_zeros(const std::string& node) {
    const auto first = node.find_first_not_of('0');
    return first == std::string::npos ? node.substr(0, 1) : node.substr(first);
}

DeviceName device_name(const std::string& text) {
    const auto at = text.rfind('@');
    return {text.substr(0, at), at == std::string::npos ? "" : without_zeros(text.substr(at + 1))};
}

/// Returns whether NAME is the chosen device's name, or another name of the same device of the catalogue.
bool names_same_device(const std::string& name, const ChosenDevice& chosen) {
    return is_device_name(name) && device_named(name).name == chosen.part->name;
}

bool is_own(const DeviceName& named, const DeviceName& own, const ChosenDevice& chosen) {
    if (named.node.empty()) {
        return named.name == own.name;
    }
    return named.node == own.node && (named.name == own.name || names_same_device(named.name, chosen));
}

/// Returns the catalogue's description of another device. Throws InputError when the catalogue does not have it.
const Part* other_part(const std::string& device, const std::string& where) {
    try {
        return choose_device(device).part;
    } catch (const InputError& error) {
        throw InputError{fmt::format("{}: {}", where, error.what())};
    }
}

}  // namespace

OwnStimuli own_stimuli(const std::vector<Stimulus>& all, const ChosenDevice& chosen,
                       const std::optional<std::string>& node) {
    DeviceName own = device_name(chosen.name);
    if (node) {
        own.node = without_zeros(*node);
    } else if (own.node.empty()) {
        own.node = std::to_string(chosen.part->info.node_id);
    }
    OwnStimuli result;
    std::map<std::string, const Part*> others;
    for (const Stimulus& one : all) {
        const auto point = one.signal.rfind('.');
        Stimulus plain = one;
        plain.signal = point == std::string::npos ? one.signal : one.signal.substr(point + 1);
        const std::string device = point == std::string::npos ? "" : one.signal.substr(0, point);
        if (point == std::string::npos || is_own(device_name(device), own, chosen)) {
            check_stimuli({plain}, {chosen.part});
            result.stimuli.push_back(plain);
            continue;
        }
        const auto [other, is_new] = others.try_emplace(device, nullptr);
        if (is_new) {
            other->second = other_part(device, one.where);
            result.others.push_back(device);
        }
        check_stimuli({plain}, {other->second});
    }
    return result;
}

}  // namespace canproof::host
