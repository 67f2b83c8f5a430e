// A device from an EDS, DCF or XDD file.
#pragma once

#include <memory>
#include <string>

#include "host/sim/devices/generic_simulation.hpp"

namespace canproof::host {

/// Notes go to stderr. Throws InputError with every fault of the file.
Part read_eds_part(const std::string& path);
/// The same; besides, throws InputError for a PDO that a node does not serve (check_served_pdos()).
std::unique_ptr<GenericSimulation> read_eds_device(const std::string& path);

}  // namespace canproof::host
