// SPDX-License-Identifier: Apache-2.0
// Gateways of the in-process bus: how long a gateway counts as sending, and when a full gateway accepts a frame.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/sim/bus/arbitrated_bus.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"

namespace canproof::host::test {

namespace {

using testing::SizeIs;

}  // namespace

TEST(Gateway, GatewayIsSendingUntilAllRepetitionsOfItsFrameAreSent) {
    std::size_t repeated = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        BusFaultRates faults;
        faults.corrupted = 0.5;
        faults.seed = seed;
        ArbitratedBus bus{"inproc", 125000, faults};
        PlainNode node{"node"};
        bus.attach(node);
        Gateway gateway{"gateway", 4, {}};
        bus.attach_gateway(gateway);
        EXPECT_FALSE(bus.is_sending(gateway));
        ASSERT_TRUE(gateway.put(parse_frame("123#", "test")));
        bus.advance(Instant{0});
        while (node.heard.empty()) {
            EXPECT_TRUE(bus.is_sending(gateway)) << bus.next_deadline().us;
            bus.advance(bus.next_deadline());
        }
        EXPECT_FALSE(bus.is_sending(gateway));
        repeated += bus.report(Instant{100000}).errors;
    }
    EXPECT_GT(repeated, 0U);
}

TEST(Gateway, FullGatewayAcceptsAFrameWhenTheBusStartsToSendOne) {
    ArbitratedBus bus{"inproc", 125000, BusFaultRates{}};
    PlainNode node{"node"};
    bus.attach(node);
    Gateway gateway{"gateway", 2, {}};
    bus.attach_gateway(gateway);
    EXPECT_TRUE(gateway.put(parse_frame("123#", "test")));
    EXPECT_TRUE(gateway.put(parse_frame("124#", "test")));
    EXPECT_FALSE(gateway.put(parse_frame("125#", "test")));
    bus.advance(Instant{0});
    EXPECT_TRUE(gateway.put(parse_frame("125#", "test")));
    run_until(bus, Instant{0}, Instant{10000});
    EXPECT_THAT(node.heard, SizeIs(3));
}

}  // namespace canproof::host::test
