// The devices of the catalogue: all that canproof_add_device() names.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "devices/device_model.hpp"

namespace canproof::host {

struct CatalogueEntry {
    std::string name;  ///< cbx-ao412
    const DeviceModel* model;
};

/// All devices, in alphabetical order.
const std::vector<CatalogueEntry>& catalogue();
/// The model of that name; nullptr when there is none.
const DeviceModel* find_model(const std::string& name);
/// The device of that name (`cbx-ao412`) with its factory data; nullptr when it cannot be run.
std::unique_ptr<SimulatedDevice> make_device(const std::string& name, const FactoryValues& factory = {});
/// The figures of all devices, by file name.
std::map<std::string, LinePlot> all_figures();

}  // namespace canproof::host
