// The node-IDs of the devices on one bus, in words.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "host/sim/run/device_node.hpp"

namespace canproof::host {

/// One line a device: `ax188001@5: node-ID 5`.
std::vector<std::string> node_id_lines(const std::vector<std::unique_ptr<DeviceNode>>& nodes);

/// Devices that have one node-ID, found as it happens: at power-on, or later by LSS.
class NodeIdClashes {
  public:
    /// A warning for each node-ID that more than one device has now, where the last call did not find it so.
    std::vector<std::string> found(const std::vector<std::unique_ptr<DeviceNode>>& nodes);

  private:
    std::set<std::string> known_;
};

}  // namespace canproof::host
