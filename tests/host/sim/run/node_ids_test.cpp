// SPDX-License-Identifier: Apache-2.0
// Tests the text about the node-IDs of a run, and the report of devices that share a node-ID.
#include "host/sim/run/node_ids.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware/base/time.hpp"
#include "host/selection/chosen_devices.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Nodes {
    explicit Nodes(const std::vector<std::string>& names) {
        for (const auto& name : names) {
            all.push_back(std::make_unique<DeviceNode>(name, choose_device(name).device));
            all.back()->power_on(Instant{});
        }
    }
    std::vector<std::unique_ptr<DeviceNode>> all;
};

}  // namespace

TEST(NodeIds, EachDeviceIsListedWithItsNodeId) {
    const Nodes nodes{{"cbx-ao412", "ax188001@5", "ax060805@255", "cbx-ao412@200"}};
    EXPECT_THAT(node_id_lines(nodes.all), ElementsAre("cbx-ao412: node-ID 3", "ax188001@5: node-ID 5",
                                                      "ax060805@255: no node-ID", "cbx-ao412@200: no node-ID"));
}

TEST(NodeIds, DevicesThatShareANodeIdAreReportedOnce) {
    const Nodes nodes{{"cbx-ao412@5", "ax188001@5", "ax060805@6"}};
    NodeIdClashes clashes;
    EXPECT_THAT(clashes.found(nodes.all),
                ElementsAre("warning: node-ID 5 is used by 2 devices: cbx-ao412@5, ax188001@5"));
    EXPECT_THAT(clashes.found(nodes.all), IsEmpty());
}

TEST(NodeIds, DevicesWithoutANodeIdAreNotReportedAsSharingOne) {
    const Nodes nodes{{"ax060805@255", "ax188001@255", "cbx-ao412@0", "cbx-ao412@200"}};
    NodeIdClashes clashes;
    EXPECT_THAT(clashes.found(nodes.all), IsEmpty());
}

/// LSS (CiA 305, 6.4): only the device without a node-ID is in configuration mode. It gets node-ID 5, which the other
/// has.
TEST(NodeIds, NodeIdThatLssGivesToASecondDeviceIsReported) {
    const Nodes nodes{{"ax060805@5", "ax188001@255"}};
    NodeIdClashes clashes;
    EXPECT_THAT(clashes.found(nodes.all), IsEmpty());
    for (const char* frame : {"7E5#0401000000000000", "7E5#1105000000000000", "7E5#0400000000000000"}) {
        nodes.all[1]->receive(parse_frame(frame, "test"), Instant{1000});
    }
    EXPECT_THAT(clashes.found(nodes.all),
                ElementsAre("warning: node-ID 5 is used by 2 devices: ax060805@5, ax188001@255"));
}

}  // namespace canproof::host::test
