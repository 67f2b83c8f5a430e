// SPDX-License-Identifier: Apache-2.0
// Advances a device. Detects a device whose deadline does not advance, because a session would otherwise call the
// device without end.
#pragma once

#include <stdexcept>
#include <string>

#include "host/sim/devices/simulated_device.hpp"

namespace canproof::host {

/// Reports a device whose deadline is not in the future after advance().
class StuckDevice : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Advances `device` to `now`. Throws StuckDevice, whose message contains `name`, when the next deadline of the device
/// is then not later than `now`.
void advance_device(SimulatedDevice& device, const std::string& name, Instant now);

}  // namespace canproof::host
