// SPDX-License-Identifier: Apache-2.0
// The catalogue: all devices that canproof_add_device() added.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "devices/device_model.hpp"

namespace canproof::host {

struct CatalogueEntry {
    std::string name;  ///< for example cbx-ao412
    const DeviceModel* model;
};

/// Returns all devices in alphabetical order.
const std::vector<CatalogueEntry>& catalogue();
/// Returns the model of the device that has this name or this further part number; nullptr when there is none.
const DeviceModel* find_model(const std::string& name);
/// Makes the device with this name (`cbx-ao412`) or further part number, with the factory data `factory`. Returns
/// nullptr when there is no such device.
std::unique_ptr<SimulatedDevice> make_device(const std::string& name, const FactoryValues& factory = {});
/// Returns the plots of all devices, by file name.
std::map<std::string, LinePlot> all_figures();

}  // namespace canproof::host
