// SPDX-License-Identifier: Apache-2.0
#include "host/sim/run/node_ids.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "host/sim/devices/node_id.hpp"

namespace canproof::host {

std::vector<std::string> node_id_lines(const std::vector<std::unique_ptr<DeviceNode>>& nodes) {
    std::vector<std::string> lines;
    for (const auto& node : nodes) {
        const int id = node->device().node_id();
        lines.push_back(id == NodeId::none ? fmt::format("{}: no node-ID", node->name())
                                           : fmt::format("{}: node-ID {}", node->name(), id));
    }
    return lines;
}

std::vector<std::string> NodeIdClashes::found(const std::vector<std::unique_ptr<DeviceNode>>& nodes) {
    std::map<int, std::vector<std::string>> names;
    for (const auto& node : nodes) {
        const int id = node->device().node_id();
        if (id >= NodeId::lowest && id <= NodeId::highest) {
            names[id].push_back(node->name());
        }
    }
    std::set<std::string> now;
    std::vector<std::string> fresh;
    for (const auto& [id, those] : names) {
        if (those.size() > 1) {
            const std::string text =
                fmt::format("warning: node-ID {} is used by {} devices: {}", id, those.size(), fmt::join(those, ", "));
            if (known_.count(text) == 0) {
                fresh.push_back(text);
            }
            now.insert(text);
        }
    }
    known_ = std::move(now);
    return fresh;
}

}  // namespace canproof::host
