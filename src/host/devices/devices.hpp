// The devices of the catalogue, each made by its own file.
#pragma once

#include <memory>

#include "host/devices/simulated_device.hpp"

namespace canproof::host {

std::unique_ptr<SimulatedDevice> make_ax060805(const FactoryValues& factory = {});
std::unique_ptr<SimulatedDevice> make_ax130751(const FactoryValues& factory = {});
std::unique_ptr<SimulatedDevice> make_ax188001(const FactoryValues& factory = {});
std::unique_ptr<SimulatedDevice> make_cbx_ao412(const FactoryValues& factory = {});

}  // namespace canproof::host
