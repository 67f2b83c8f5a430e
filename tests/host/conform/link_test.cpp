// SPDX-License-Identifier: Apache-2.0
// Tests the background traffic that the tester sends on the bus.
#include "host/conform/link/link.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/host/conform/conform_bench.hpp"

namespace canproof::host::conform::test {

namespace {

/// Returns the identifiers of one second of background traffic that leaves out the identifiers in `reserved`.
std::set<std::uint32_t> traffic_beside(const std::set<std::uint32_t>& reserved) {
    VirtualTarget target{sound_slave(), 5};
    Link link{target};
    link.reserve(reserved);
    link.set_traffic(50.0, false);
    link.wait(milliseconds(1000));
    std::set<std::uint32_t> sent;
    for (const FrameRecord& one : link.log()) {
        if (one.own) {
            sent.insert(one.frame.id);
        }
    }
    return sent;
}

// Background traffic of low priority uses the 32 identifiers from 6E0h to 6FFh.
TEST(ConformLink, BackgroundTrafficLeavesOutReservedIdentifiers) {
    const auto all = traffic_beside({});
    EXPECT_EQ(all.size(), 32U);
    EXPECT_EQ(*all.begin(), 0x6E0U);
    const auto first = traffic_beside({0x6E0});
    EXPECT_EQ(first.size(), 31U);
    EXPECT_EQ(first.count(0x6E0), 0U);
    EXPECT_EQ(traffic_beside({0x6E0, 0x6E1, 0x6FF}).size(), 29U);
    std::set<std::uint32_t> each;
    for (std::uint32_t id = 0x6E0; id <= 0x6FF; ++id) {
        each.insert(id);
    }
    EXPECT_TRUE(traffic_beside(each).empty());
}

}  // namespace

}  // namespace canproof::host::conform::test
