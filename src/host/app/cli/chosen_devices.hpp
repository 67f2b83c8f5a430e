// SPDX-License-Identifier: Apache-2.0
// The devices that a command line names: of the catalogue, from an EDS, or from an image.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/app/cli/factory_options.hpp"
#include "host/register/register.hpp"
#include "host/sim/devices/simulated_device.hpp"

namespace canproof::host {

/// A device to run, and the description of its signals.
struct ChosenDevice {
    std::string name;  ///< as the user wrote it: NAME or NAME@NODE
    std::unique_ptr<SimulatedDevice> device;
    const Part* part{nullptr};  ///< nullptr for a device from an EDS, which has no part
    std::uint32_t bit_rate{0};  ///< bit/s as shipped
    std::string notice;         ///< message for the user before the run; empty: no message
};

/// Sets the NODE of NAME@NODE or of `--node`. NODE is a node-ID; on a device with coding switches it is any value of
/// the switches, and `chosen.notice` says so when the value is not a node-ID. Throws InputError.
void set_node(ChosenDevice& chosen, const std::string& node);
/// Returns the device for NAME or NAME@NODE. Throws InputError.
ChosenDevice choose_device(const std::string& text);
ChosenDevice choose_device(const std::string& text, FactoryOptions& factory);
/// Returns the device for FILE or FILE@NODE, where FILE is an EDS, DCF or XDD. The device has the name of the file
/// without folder and extension. Throws InputError with every fault of the file.
ChosenDevice choose_eds(const std::string& text);
/// FILE or FILE@NODE: a device of the catalogue whose image runs on the emulated microcontroller; its name is the
/// device's, with @NODE. Throws InputError and ImageFailed.
ChosenDevice choose_image(const std::string& text);
/// Every device of the catalogue that runs; one whose node-ID as shipped is taken gets the lowest that is free.
std::vector<ChosenDevice> choose_catalogue();
std::vector<ChosenDevice> choose_catalogue(FactoryOptions& factory);

}  // namespace canproof::host
