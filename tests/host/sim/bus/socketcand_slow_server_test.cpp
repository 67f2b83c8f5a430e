// SPDX-License-Identifier: Apache-2.0
// Devices on the bus of a server that reads late, and frames that this program takes late.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include "tests/host/sim/bus/scripted_bus.hpp"
#include "tests/support/fake_kernel.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SlowServer : public ScriptedBus {
  protected:
    /// Lets the server read until it has `size` characters. Returns what it has.
    std::string read_all(std::size_t size) {
        for (int i = 0; i < 500 && server.heard().size() < size; ++i) {
            pollfd waiting{bus->watches().at(0).descriptor, POLLOUT, 0};
            EXPECT_GE(::poll(&waiting, 1, longest_wait_ms), 0);
            bus->poll(now);
        }
        return server.heard();
    }
    /// Sends a frame of node a that contains its number. Returns whether the bus has taken it.
    bool send_numbered(std::size_t number) {
        a.send(fmt::format("583#{:016X}", number));
        now = now + milliseconds(2);  // the longest frame takes about 1 ms
        bus->advance(now);
        return a.waiting.empty();
    }
    /// Sends frames to the server, which does not read, until the send buffer is full and the bus keeps unsent text.
    /// Returns the number of frames.
    std::size_t fill_output() {
        server.keep_little();
        const int room = 4096;
        EXPECT_EQ(setsockopt(bus->watches().at(0).descriptor, SOL_SOCKET, SO_SNDBUF, &room, sizeof room), 0);
        std::size_t frames = 0;
        for (; frames < 20000 && !bus->watches().at(0).writable; ++frames) {
            a.send("583#4300100091010800");
            bus->advance(now);
            now = now + milliseconds(2);  // the longest frame takes about 1 ms
        }
        EXPECT_TRUE(bus->watches().at(0).writable);
        return frames;
    }
};

}  // namespace

TEST_F(SlowServer, ServerThatReadsLateGetsAllFrames) {
    join();
    const std::size_t frames = fill_output();
    bus->poll(now);
    // `< open vcan0 >< rawmode >` has 25 characters, `< send 583 8 43 00 10 00 91 01 08 00 >` has 38
    const std::size_t all = 25 + 38 * frames;
    for (int i = 0; i < 500 && server.heard().size() < all; ++i) {
        pollfd waiting{bus->watches().at(0).descriptor, POLLOUT, 0};
        ASSERT_GE(::poll(&waiting, 1, longest_wait_ms), 0);
        bus->poll(now);
    }
    EXPECT_EQ(server.heard().size(), all);
    EXPECT_FALSE(bus->watches().at(0).writable);
}

TEST_F(SlowServer, FrameBeforeAResetArrives_EvenWhileTextWaitsForTheServer) {
    join();
    fill_output();
    server.say("< frame 080 9.5 >");
    server.reset_connection();
    bus->poll(now);
    bus->advance(now);
    EXPECT_THAT(log.back(), HasSubstr(" - 080#"));
    EXPECT_FALSE(bus->has_joined());
}

TEST_F(SlowServer, EachOfManyFramesThatWaitedForTheServerArrivesOnce) {
    join();
    const int room = 4096;  // a small buffer of the kernel is soon full
    EXPECT_EQ(setsockopt(bus->watches().at(0).descriptor, SOL_SOCKET, SO_SNDBUF, &room, sizeof room), 0);
    std::string expected = "< open vcan0 >< rawmode >";
    std::size_t sent = 0;
    while (sent < 20000 && send_numbered(sent)) {
        expected += "< send 583 8";
        for (unsigned byte = 0; byte < 8; ++byte) {
            expected += fmt::format(" {:02X}", (std::uint64_t{sent} >> (56U - 8U * byte)) & 0xFFU);
        }
        expected += " >";
        ++sent;
    }
    // the text that waits is at its limit, so the last frame stays with its node and nothing is due
    ASSERT_EQ(a.waiting.size(), 1U);
    EXPECT_EQ(bus->next_deadline(), never);
    EXPECT_EQ(read_all(expected.size()), expected);
    bus->advance(now);
    EXPECT_TRUE(a.waiting.empty());
    EXPECT_EQ(log.size(), sent + 1U);
}

TEST_F(ScriptedBus, ShortWritesAndReadsLoseNothing) {
    canproof::test::FakeKernel kernel;
    join();
    canproof::test::FakeKernel::present() = &kernel;
    kernel.most_at_once = 7;
    for (int i = 0; i < 3; ++i) {
        a.send(fmt::format("123#0{}", i));
        run_until(*bus, now, now + milliseconds(1));
        now = now + milliseconds(1);
    }
    for (int i = 0; i < 20; ++i) {
        bus->poll(now);
    }
    EXPECT_EQ(server.heard(), "< open vcan0 >< rawmode >< send 123 1 00 >< send 123 1 01 >< send 123 1 02 >");
    kernel.most_at_once = 0;
    server.say("< frame 080 1.0 >< frame 081 1.0 05 >");
    kernel.most_at_once = 7;
    hear();
    bus->advance(now);
    EXPECT_THAT(std::vector<std::string>(b.heard.end() - 2, b.heard.end()),
                ElementsAre(fmt::format("{} 080#", now.us), fmt::format("{} 081#05", now.us)));
    canproof::test::FakeKernel::present() = nullptr;
}

TEST_F(ScriptedBus, FrameThatIsProcessedLateKeepsItsTimeOfArrival) {
    join();
    say("< frame 080 9.5 >");
    const Instant arrived = now;
    now = now + milliseconds(20);
    bus->advance(now);
    EXPECT_THAT(log, ElementsAre(fmt::format("{} - 080#", arrived.us)));
    EXPECT_THAT(a.heard, ElementsAre(fmt::format("{} 080#", arrived.us)));
}

}  // namespace canproof::host::test
