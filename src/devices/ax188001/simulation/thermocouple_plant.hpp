// SPDX-License-Identifier: Apache-2.0
// The plant (simulated surroundings) of the AX188001: two thermocouples, each from its hot junction to the module's
// terminals.
#pragma once

#include <array>
#include <string>

#include "devices/ax188001/firmware/ax188001_scanner.hpp"

namespace canproof::ax188001 {

class ThermocouplePlant {
  public:
    /// Notes that a stimulus was set. The terminals of channel N follow the stimulus that was set last: tcN_celsius or
    /// tcN_wire (a temperature), or tcN_microvolts.
    void stimulus(const std::string& name);
    /// Writes the voltage of each channel that follows a temperature to `inputs`. `configured` is the type that 6110h
    /// (sensor type) sets for each channel; the wire has that type where tcN_wire is 0. Returns true when a voltage
    /// changed.
    bool drive(Inputs& inputs, const std::array<SensorType, channel_count>& configured) const;

  private:
    std::array<bool, channel_count> by_temperature_{true, true};
};

}  // namespace canproof::ax188001
