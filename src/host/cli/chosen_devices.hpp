// The devices that a command line names: of the catalogue, or from an EDS.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/devices/simulated_device.hpp"
#include "host/speccompiler/register.hpp"

namespace canproof::host {

/// A device to run, and what describes its signals.
struct ChosenDevice {
    std::string name;  ///< as written: NAME or NAME@NODE
    std::unique_ptr<SimulatedDevice> device;
    const Part* part{nullptr};  ///< nullptr for a device from an EDS, which has none
    std::uint32_t bit_rate{0};  ///< bit/s as shipped
};

/// NAME or NAME@NODE. Throws InputError.
ChosenDevice choose_device(const std::string& text);
/// FILE or FILE@NODE: a device from an EDS, DCF or XDD; its name is the file's without folder and extension. Throws
/// InputError, with every fault of the file.
ChosenDevice choose_eds(const std::string& text);
/// Every device of the catalogue that runs; one whose node-ID as shipped is taken gets the lowest that is free.
std::vector<ChosenDevice> choose_catalogue();

}  // namespace canproof::host
