// SPDX-License-Identifier: Apache-2.0
// The work of the in-process bus, as the number of inspected ports. A bus with nodes that report their changes also has
// the port of put(), which it inspects in every step.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "host/sim/bus/arbitrated_bus.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"

namespace canproof::host::test {

namespace {

/// The bus inspects the sender and the port of put() when the frame starts, the port of put() at its end, and then both
/// again.
constexpr std::uint64_t work_of_a_frame = 2 + 1 + 2;

class BusWork : public testing::Test {
  protected:
    void attach(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            nodes.push_back(std::make_unique<TellingNode>());
            bus.attach(*nodes.back());
        }
        bus.advance(now);
    }
    /// Lets some time pass and the bus advance. Returns the number of ports that it inspects.
    std::uint64_t work() {
        const std::uint64_t before = bus.inspections();
        now = now + milliseconds(10);  // longer than a frame, an error frame and an intermission
        bus.advance(now);
        return bus.inspections() - before;
    }
    /// Sends a frame. Returns the number of ports that the bus inspects from its start to its end.
    std::uint64_t work_to_send() {
        const std::uint64_t start = work();
        const std::uint64_t before = bus.inspections();
        now = bus.next_deadline();
        bus.advance(now);
        return start + bus.inspections() - before;
    }
    std::uint64_t work_to_send(TellingNode& sender) {
        sender.send_and_tell("123#");
        return work_to_send();
    }
    /// Detaches a gateway during its frame, so that each node counts a receive error.
    void break_a_frame() {
        Gateway gateway{"gateway", 1, {}};
        bus.attach_gateway(gateway);
        ASSERT_TRUE(gateway.put(parse_frame("123#", "test")));
        work();
        bus.detach_gateway(gateway);
    }

    ArbitratedBus bus{"inproc", 125000, {}};
    std::vector<std::unique_ptr<TellingNode>> nodes;
    Instant now{};
};

}  // namespace

TEST_F(BusWork, WorkForAFrameDoesNotDependOnTheNumberOfNodes) {
    attach(3);
    EXPECT_EQ(bus.inspections(), 4U);
    EXPECT_EQ(work_to_send(*nodes[1]), work_of_a_frame);
    attach(97);
    EXPECT_EQ(work_to_send(*nodes[99]), work_of_a_frame);
    EXPECT_EQ(nodes[0]->heard.size(), 2U);
    EXPECT_EQ(work(), 1U);
}

TEST_F(BusWork, NodeThatReportsSeveralChangesIsInspectedOnce) {
    attach(3);
    nodes[0]->accept({});
    nodes[0]->accept({{0x123, 0x7FF, false}});
    nodes[0]->send_and_tell("123#");
    EXPECT_EQ(work_to_send(), work_of_a_frame);
}

TEST_F(BusWork, NodesVoteOnTheBitRateOnceForEachChange) {
    attach(3);
    for (const auto& node : nodes) {
        node->use(250000);
    }
    EXPECT_EQ(work(), 4U + 4U);  // inspects all four ports, then lets all vote
    EXPECT_EQ(work(), 1U);
    EXPECT_EQ(bus.report(now).bit_rate, 250000U);
    nodes[0]->use(500000);
    EXPECT_EQ(work(), 2U + 4U);
    EXPECT_EQ(work(), 1U);
    EXPECT_EQ(work_to_send(*nodes[1]), work_of_a_frame);
}

TEST_F(BusWork, CorrectFramesAreCountedUntilNoNodeHasReceiveErrors) {
    attach(3);
    break_a_frame();
    EXPECT_EQ(work_to_send(*nodes[0]), work_of_a_frame + 4U);  // the sender does not count its own frame
    EXPECT_EQ(work_to_send(*nodes[1]), work_of_a_frame + 4U);
    EXPECT_EQ(work_to_send(*nodes[2]), work_of_a_frame);
}

TEST_F(BusWork, GatewaysCountNoReceiveErrors) {
    attach(3);
    break_a_frame();
    for (const std::uint64_t counted : {4U, 0U}) {
        ASSERT_TRUE(bus.put(parse_frame("123#", "test"), now));
        // one port less than in work_of_a_frame, because the port of put() is itself the sender
        EXPECT_EQ(work_to_send(), 1U + 1U + counted + 2U);
    }
}

}  // namespace canproof::host::test
