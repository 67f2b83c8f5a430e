// SPDX-License-Identifier: Apache-2.0
// The stimuli of one device from a file for a run of several devices, whose lines may name a device: DEVICE.signal or
// DEVICE@NODE.signal.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/selection/chosen_devices.hpp"
#include "host/sim/replay/stimulus.hpp"

namespace canproof::host {

struct OwnStimuli {
    std::vector<Stimulus> stimuli;    ///< of the chosen device and of no device by name, without the device's name
    std::vector<std::string> others;  ///< each name of another device of the catalogue, once
};

/// Divides the stimuli by the device that they name. `node` is the node-ID of the chosen device; without a value, it
/// is the one in `chosen.name` or, failing that, the one as shipped. Checks all stimuli. Throws InputError with the
/// line for a device that is neither the chosen one nor in the catalogue, and for an unknown signal or a wrong value.
OwnStimuli own_stimuli(const std::vector<Stimulus>& all, const ChosenDevice& chosen,
                       const std::optional<std::string>& node);

}  // namespace canproof::host
