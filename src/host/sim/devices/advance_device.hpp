// SPDX-License-Identifier: Apache-2.0
// Advances a device, and reports a device whose deadline does not move: a session would call it endlessly.
#pragma once

#include <stdexcept>
#include <string>

#include "host/sim/devices/simulated_device.hpp"

namespace canproof::host {

/// The error of a device whose deadline stays in the past after advance().
class StuckDevice : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Advances `device` to `now`. Throws StuckDevice with `name` when its next deadline is not later than `now`
/// afterwards.
void advance_device(SimulatedDevice& device, const std::string& name, Instant now);

}  // namespace canproof::host
