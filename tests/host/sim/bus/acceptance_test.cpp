// SPDX-License-Identifier: Apache-2.0
// Filters of a node whose data sheet contains a 29-bit identifier. None of the four devices accepts such an identifier.
#include "host/sim/bus/acceptance.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "host/datasheet/read_eds.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/generic_simulation.hpp"
#include "tests/host/datasheet/box_eds.hpp"

namespace canproof::host::test {

TEST(Acceptance, FilterOfA29BitIdentifierComparesAllBits) {
    std::string text = box;
    const std::string as_shipped = "DefaultValue=$NODEID+0x200";
    text.replace(text.find(as_shipped), as_shipped.size(),
                 "DefaultValue=0x20010205");  // bit 29 selects a 29-bit identifier
    GenericSimulation device{read_eds(text, "box.eds").part};
    device.set_node_id(5);
    device.power_on(Instant{});
    const auto accepted = acceptance_filters(*device.objects(), 5);
    const auto hears = [&](const char* frame) {
        return std::any_of(accepted.begin(), accepted.end(),
                           [&](const AcceptanceFilter& one) { return one.accepts(parse_frame(frame, "test")); });
    };
    EXPECT_TRUE(hears("00010205#00"));
    for (const char* other : {"00000205#00", "00020205#00", "10010205#00", "205#00"}) {
        EXPECT_FALSE(hears(other)) << other;
    }
}

}  // namespace canproof::host::test
