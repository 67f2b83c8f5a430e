// Lets a device do what is due, and refuses one that does not: a session would ask it for ever.
#pragma once

#include <stdexcept>
#include <string>

#include "host/sim/devices/simulated_device.hpp"

namespace canproof::host {

/// A device with something due that stays due however often it is told the time.
class StuckDevice : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Advances `device` to `now`. Throws StuckDevice, which names the device by `name`, when its next deadline is not
/// later than `now` afterwards.
void advance_device(SimulatedDevice& device, const std::string& name, Instant now);

}  // namespace canproof::host
