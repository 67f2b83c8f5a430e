// SPDX-License-Identifier: Apache-2.0
// Writes the outputs of a device as `seconds,signal,value`: first all outputs, then each change.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "host/sim/devices/simulated_device.hpp"

namespace canproof::host {

constexpr const char* output_heading = "seconds,signal,value\n";

class OutputChanges {
  public:
    /// Makes a writer that puts `prefix` before each name, such as `ax188001@5.` when several devices write to one
    /// file.
    explicit OutputChanges(std::string prefix = "") : prefix_{std::move(prefix)} {}

    void write(std::ostream& out, Instant at, const SimulatedDevice& device);

  private:
    std::string prefix_;
    std::vector<double> last_;
};

}  // namespace canproof::host
