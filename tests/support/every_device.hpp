// The devices of the catalogue, for what must hold of each: a new device is tried without another word.
#pragma once

#include <string>
#include <vector>

#include "devices/catalogue.hpp"

namespace canproof::test {

/// Their names (`cbx-ao412`), in alphabetical order.
inline std::vector<std::string> every_device() {
    std::vector<std::string> names;
    for (const host::CatalogueEntry& entry : host::catalogue()) {
        names.push_back(entry.name);
    }
    return names;
}

}  // namespace canproof::test
