// SPDX-License-Identifier: Apache-2.0
// Describes the node-IDs of the devices on one bus.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "host/sim/run/device_node.hpp"

namespace canproof::host {

/// Returns one line for each device: `ax188001@5: node-ID 5`.
std::vector<std::string> node_id_lines(const std::vector<std::unique_ptr<DeviceNode>>& nodes);

/// Detects devices that have the same node-ID, at power-on or later through LSS.
class NodeIdClashes {
  public:
    /// Returns a warning for each node-ID that more than one device has now. Leaves out the clashes
    /// that already existed at the last call.
    std::vector<std::string> found(const std::vector<std::unique_ptr<DeviceNode>>& nodes);

  private:
    std::set<std::string> known_;
};

}  // namespace canproof::host
