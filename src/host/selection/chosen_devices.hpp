// SPDX-License-Identifier: Apache-2.0
// The devices that a command line names: of the catalogue, from an EDS, or from a firmware image.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/register/register.hpp"
#include "host/selection/factory_options.hpp"
#include "host/sim/devices/simulated_device.hpp"

namespace canproof::host {

/// A device to run, and the description of its signals.
struct ChosenDevice {
    std::string name;  ///< name of the device as the user wrote it: NAME or NAME@NODE
    std::unique_ptr<SimulatedDevice> device;
    /// description of the device in the requirements register or the EDS; valid as long as `device`
    const Part* part{nullptr};
    std::uint32_t bit_rate{0};  ///< bit rate with which the device is shipped, in bit/s
    std::string notice;         ///< message for the user before the run; empty: no message
};

/// Returns the file of FILE or FILE@NODE.
std::string file_of(const std::string& text);
/// Sets the NODE of NAME@NODE or of `--node`. NODE is a node-ID. On a device with coding switches, NODE is any value of
/// the switches, and `chosen.notice` gets a message when the value is no node-ID. Throws InputError for any other NODE.
void set_node(ChosenDevice& chosen, const std::string& node);
/// Returns the device for NAME or NAME@NODE. Throws InputError when NAME or NODE is not valid.
ChosenDevice choose_device(const std::string& text);
ChosenDevice choose_device(const std::string& text, FactoryOptions& factory);
/// Returns the device for FILE or FILE@NODE, where FILE is an EDS, DCF or XDD. The device has the name of the file
/// without folder and extension, with @NODE if NODE is given. Throws InputError with every fault of the file.
ChosenDevice choose_eds(const std::string& text);
/// Returns the device for FILE or FILE@NODE, where FILE is the firmware image of a device of the catalogue for the
/// emulated microcontroller. Its name is that of the device, with @NODE if NODE is given. Throws InputError and
/// ImageFailed.
ChosenDevice choose_image(const std::string& text);
/// Returns every device of the catalogue for a run. If the node-ID with which a device is shipped is already
/// used, this device gets the lowest free node-ID.
std::vector<ChosenDevice> choose_catalogue();
std::vector<ChosenDevice> choose_catalogue(FactoryOptions& factory);

}  // namespace canproof::host
