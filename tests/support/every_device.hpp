// SPDX-License-Identifier: Apache-2.0
// The devices of the catalogue, for tests of all devices. A new device is tested without a change here.
#pragma once

#include <string>
#include <vector>

#include "devices/catalogue.hpp"

namespace canproof::test {

/// Returns the names of the devices (`cbx-ao412`) in alphabetical order.
inline std::vector<std::string> every_device() {
    std::vector<std::string> names;
    for (const host::CatalogueEntry& entry : host::catalogue()) {
        names.push_back(entry.name);
    }
    return names;
}

}  // namespace canproof::test
