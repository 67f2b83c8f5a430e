// SPDX-License-Identifier: Apache-2.0
#include "devices/catalogue.hpp"

#include <algorithm>

namespace canproof::host {

const DeviceModel* find_model(const std::string& name) {
    for (const CatalogueEntry& entry : catalogue()) {
        const std::vector<std::string>& others = entry.model->other_names;
        if (entry.name == name || std::find(others.begin(), others.end(), name) != others.end()) {
            return entry.model;
        }
    }
    return nullptr;
}

std::unique_ptr<SimulatedDevice> make_device(const std::string& name, const FactoryValues& factory) {
    const DeviceModel* const model = find_model(name);
    return model == nullptr ? nullptr : model->make(factory);
}

std::map<std::string, LinePlot> all_figures() {
    std::map<std::string, LinePlot> all;
    for (const CatalogueEntry& entry : catalogue()) {
        all.merge(entry.model->figures());
    }
    return all;
}

}  // namespace canproof::host
