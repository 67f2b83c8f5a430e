// SPDX-License-Identifier: Apache-2.0
// The description of a device in the catalogue; src/devices/NAME/simulation/model.cpp defines it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/report/line_plot.hpp"
#include "host/sim/devices/factory_key.hpp"
#include "host/sim/devices/simulated_device.hpp"

namespace canproof::host {

/// One request of `canproof demo`.
struct DemoRequest {
    const char* section;  ///< section of the manual
    const char* what;
    const char* frame;  ///< `603#4000100000000000`
};

/// The requests that `canproof demo` sends to the device after power-on.
struct DemoScene {
    const char* title;
    const char* boot_section;  ///< section of the manual
    std::vector<DemoRequest> requests;
    std::vector<std::string> outputs;  ///< names of the outputs whose voltages the demo prints at the end
};

struct DeviceModel {
    std::vector<std::string> other_names;  ///< further part numbers with the same simulation
    std::unique_ptr<SimulatedDevice> (*make)(const FactoryValues& factory);
    /// Makes the plots of the device's behaviour, by file name. Each file name begins with the name of the device.
    std::map<std::string, LinePlot> (*figures)();
    DemoScene demo;
    /// Returns the keys of factory data that no object contains, for a part number (the device's own name when none is
    /// given). The pointer is nullptr if the device has no such keys.
    std::vector<FactoryKey> (*further_factory_keys)(const std::string& part_number);
};

}  // namespace canproof::host
