// SPDX-License-Identifier: Apache-2.0
// The devices of the catalogue, for tests that run with all devices. A new device in the catalogue is tested without a
// change here.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "devices/catalogue.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "host/sim/devices/simulated_device.hpp"

namespace canproof::test {

/// Returns the names of the devices (`cbx-ao412`) in alphabetical order.
inline std::vector<std::string> every_device() {
    std::vector<std::string> names;
    for (const host::CatalogueEntry& entry : host::catalogue()) {
        names.push_back(entry.name);
    }
    return names;
}

/// Returns the names of the devices that have the object `index`, in alphabetical order.
inline std::vector<std::string> every_device_with(std::uint16_t index) {
    std::vector<std::string> names = every_device();
    names.erase(std::remove_if(names.begin(), names.end(),
                               [index](const std::string& name) {
                                   return !host::make_device(name)->objects()->find(index, 0).ok();
                               }),
                names.end());
    return names;
}

}  // namespace canproof::test
