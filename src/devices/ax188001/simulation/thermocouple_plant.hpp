// The physical world of the AX188001: two thermocouples, each between its hot junction and the module's terminals.
#pragma once

#include <array>
#include <string>

#include "devices/ax188001/firmware/ax188001_scanner.hpp"

namespace canproof::host {

class ThermocouplePlant {
  public:
    /// A stimulus was set: whichever of tcN_celsius and tcN_microvolts came last drives the terminals.
    void stimulus(const std::string& name);
    /// Puts the voltages that the driven thermocouples make into `inputs`. `configured` is what 6110h says of each
    /// channel, the wire's type where tcN_wire is 0. True when a voltage changed.
    bool drive(ax188001::Inputs& inputs,
               const std::array<ax188001::SensorType, ax188001::channel_count>& configured) const;

  private:
    std::array<bool, ax188001::channel_count> by_temperature_{true, true};
};

}  // namespace canproof::host
