// SPDX-License-Identifier: Apache-2.0
// Rules of the socketcand server that need a certain order of arrivals, full buffers or lost connections.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "host/base/input_error.hpp"
#include "tests/host/sim/bus/socketcand_server.hpp"
#include "tests/support/descriptor_limit.hpp"
#include "tests/support/fake_kernel.hpp"

namespace canproof::host::test {

namespace {

using canproof::test::TcpClient;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class SocketcandServerRules : public SocketcandServer {
  protected:
    /// Sends frames to a client that does not read, until text waits for it. Returns the number of frames.
    std::size_t fill_output() {
        std::size_t frames = 0;
        while (frames < 200000 && !bus.watches().back().writable) {
            send_one();
            ++frames;
        }
        EXPECT_TRUE(bus.watches().back().writable);
        return frames;
    }
    /// Returns whether text waits for the client, and the server reads nothing from it. The kernel may take some of the
    /// text later: then more frames are sent.
    bool block() {
        for (int looks = 0; looks < most_looks; ++looks) {
            fill_output();
            for (int turn = 0; turn < 4; ++turn) {
                pass(Duration{});  // no time passes, so the gateway and the text buffer of the client fill up
            }
            const Watch last = bus.watches().back();
            if (bus.watches().size() == 2 && last.writable && !last.readable) {
                return true;
            }
        }
        return false;
    }
    void send_one() {
        node.send("583#4300100091010800");
        bus.advance(now);
        now = bus.next_deadline();
        bus.advance(now);
    }
    /// Waits until the kernel has text that the server has not read.
    static bool has_text(int descriptor) {
        pollfd waiting{descriptor, POLLIN, 0};
        return ::poll(&waiting, 1, most_looks * 10) > 0;
    }
    /// Returns the number of characters that the kernel has received and the server has not read.
    static int unread(int descriptor) {
        int count = -1;
        EXPECT_EQ(ioctl(descriptor, FIONREAD, &count), 0);
        return count;
    }
    int lowest_free_descriptor() const {
        const int descriptor = dup(bus.watches().front().descriptor);
        close(descriptor);
        return descriptor;
    }
    /// Returns the number of open descriptors below 1024.
    static int open_descriptors() {
        int open = 0;
        for (int descriptor = 0; descriptor < 1024; ++descriptor) {
            open += fcntl(descriptor, F_GETFD) >= 0 ? 1 : 0;
        }
        return open;
    }
    /// Returns the message with which a server at this port fails.
    static std::string refusal(std::uint16_t port) {
        try {
            const SocketcandBus second{{"127.0.0.1", port}, 125000, {}, 0};
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
    static std::string many_commands() {
        std::string much;
        for (int i = 0; i < 1000; ++i) {
            much += "< send 123 0 >";
        }
        return much;
    }
};

}  // namespace

TEST_F(SocketcandServerRules, ServerThatCannotListenReportsTheReasonAndLeavesNoDescriptor) {
    const int before = open_descriptors();
    EXPECT_THAT(refusal(bus.port()), HasSubstr("(Address already in use)"));
    EXPECT_EQ(open_descriptors(), before);
}

TEST_F(SocketcandServerRules, LackOfFileDescriptorsIsReportedAsTheReason) {
    const DescriptorLimit limit{lowest_free_descriptor()};
    EXPECT_THAT(refusal(0), HasSubstr("(Too many open files)"));
}

TEST_F(SocketcandServerRules, ClosedClientLeavesNoOpenDescriptor) {
    const int before = open_descriptors();
    {
        TcpClient client{bus.port()};
        ASSERT_TRUE(until([&] { return bus.clients() == 1; }));
    }
    ASSERT_TRUE(until([&] { return bus.clients() == 0; }));
    EXPECT_EQ(open_descriptors(), before);
}

TEST_F(SocketcandServerRules, OnePollAcceptsEightClients) {
    std::vector<std::unique_ptr<TcpClient>> clients;
    for (int i = 0; i < 9; ++i) {
        clients.push_back(std::make_unique<TcpClient>(bus.port()));
    }
    ASSERT_TRUE(arrive());
    bus.poll(now);
    EXPECT_EQ(bus.clients(), 8U);
    EXPECT_TRUE(until([&] { return bus.clients() == 9; }));
}

TEST_F(SocketcandServerRules, PortCanBeUsedAgainAtOnceAfterTheServerHasEnded) {
    int value = 0;
    socklen_t size = sizeof value;
    EXPECT_EQ(getsockopt(bus.watches().front().descriptor, SOL_SOCKET, SO_REUSEADDR, &value, &size), 0);
    EXPECT_EQ(value, 1);
}

TEST_F(SocketcandServerRules, DismissedClientThatReadsOnlyLaterGetsAllItsText) {
    TcpClient client{bus.port()};
    ASSERT_TRUE(until([&] { return bus.clients() == 1; }));
    std::string echoes;
    for (int i = 0; i < 400; ++i) {
        echoes += "< echo >";
    }
    std::size_t all = std::string{"< hi >"}.size();
    for (int i = 0; i < 1000 && !bus.watches().back().writable; ++i) {
        client.say(echoes);
        all += echoes.size();
        ASSERT_TRUE(arrive());
        pass(Duration{});
    }
    ASSERT_TRUE(bus.watches().back().writable);
    pass(SocketcandBus::open_limit);
    all += std::string{"< error the bus was not opened within 10 s >"}.size();
    EXPECT_TRUE(until([&] { return client.ended(); }));
    EXPECT_EQ(client.heard().size(), all);
}

TEST_F(SocketcandServerRules, UpTo256FramesFromTheUserWaitForTheBus) {
    for (int i = 0; i < 256; ++i) {
        ASSERT_TRUE(bus.put(parse_frame("123#", "test"), now)) << i;
    }
    EXPECT_FALSE(bus.put(parse_frame("123#", "test"), now));
}

TEST_F(SocketcandServerRules, CommandMayArriveByteByByte) {
    TcpClient client{bus.port()};
    ASSERT_TRUE(until([&] { return bus.clients() == 1; }));
    for (const char byte : join) {
        client.say(std::string{byte});
        ASSERT_TRUE(arrive());
        pass(Duration{});
    }
    EXPECT_TRUE(until([&] { return client.heard() == joined; }));
}

TEST_F(SocketcandServerRules, TextIsNotReadWhileEarlierTextOfTheClientWaits) {
    TcpClient client{bus.port()};
    ASSERT_TRUE(until([&] { return bus.clients() == 1; }));
    const int descriptor = bus.watches().back().descriptor;
    client.say("< echo >");
    ASSERT_TRUE(arrive());
    bus.poll(now);
    EXPECT_EQ(unread(descriptor), 0);
    client.say("< echo >");
    ASSERT_TRUE(has_text(descriptor));
    bus.poll(now);
    EXPECT_EQ(unread(descriptor), 8);  // the eight characters of `< echo >`
    bus.advance(now);
    bus.poll(now);
    EXPECT_EQ(unread(descriptor), 0);
    EXPECT_TRUE(until([&] { return client.heard() == "< hi >< echo >< echo >"; }));
}

TEST_F(SocketcandServerRules, TextIsNotPassedOnBeforeItsTimeOfArrival) {
    TcpClient client{bus.port()};
    ASSERT_TRUE(until([&] { return bus.clients() == 1; }));
    client.say("< echo >");
    ASSERT_TRUE(arrive());
    now = now + microseconds(1000);
    bus.poll(now);
    bus.advance(Instant{now.us - 1});
    EXPECT_EQ(bus.next_deadline(), now);
    EXPECT_TRUE(until([&] { return client.heard() == "< hi >< echo >"; }));
}

TEST_F(SocketcandServerRules, TextWithAnArrivalTimeBeforeTheBusTimeIsDueAtOnce) {
    now = Instant{1000000};
    bus.use_clock([] { return Instant{1000000}; });
    TcpClient client{bus.port()};
    client.say(join);
    ASSERT_TRUE(until([&] { return client.heard() == joined; }));
    now = Instant{3600000000U};
    bus.advance(now);
    client.say("< echo >");
    ASSERT_TRUE(arrive());
    bus.poll(now);
    EXPECT_EQ(bus.next_deadline(), now);
}

TEST_F(SocketcandServerRules, SlowClientGetsAllItsText) {
    TcpClient client{bus.port()};
    client.say(join);
    ASSERT_TRUE(until([&] { return client.heard() == joined; }));
    std::size_t frames = fill_output();
    for (int i = 0; i < 10; ++i, ++frames) {
        send_one();  // the kernel takes nothing more
    }
    ASSERT_LT(now, Instant{10000000});
    // `< frame 583 0.000000 4300100091010800 >` has 39 characters
    const std::size_t all = joined.size() + 39 * frames;
    EXPECT_TRUE(until([&] { return client.heard().size() == all; })) << client.heard().size() << " of " << all;
    EXPECT_FALSE(bus.watches().back().writable);
}

TEST_F(SocketcandServerRules, SocketOfABlockedClientThatDoesNotReadIsWatchedForWritingOnly) {
    TcpClient client{bus.port()};
    client.say(join);
    ASSERT_TRUE(until([&] { return client.heard() == joined; }));
    client.say(many_commands());
    EXPECT_TRUE(block());
}

TEST_F(SocketcandServerRules, ClientWithAResetConnectionIsRemovedWhenTheResetIsRead) {
    TcpClient client{bus.port()};
    client.say(join);
    ASSERT_TRUE(until([&] { return client.heard() == joined; }));
    client.reset();
    ASSERT_TRUE(arrive());
    bus.poll(now);
    EXPECT_EQ(bus.clients(), 0U);
    EXPECT_THAT(bus.watches(), SizeIs(1));
}

TEST_F(SocketcandServerRules, ResetOfOneClientAffectsNoOther) {
    TcpClient first{bus.port()};
    first.say(join);
    ASSERT_TRUE(until([&] { return first.heard() == joined; }));
    TcpClient second{bus.port()};
    second.say(join);
    ASSERT_TRUE(until([&] { return second.heard() == joined; }));
    first.reset();
    second.say("< echo >");
    ASSERT_TRUE(arrive());
    pass(Duration{});  // one turn reads both
    ASSERT_TRUE(until([&] { return second.heard() == joined + "< echo >"; }));
    second.say("< echo >");
    EXPECT_TRUE(until([&] { return second.heard() == joined + "< echo >< echo >"; }));
    EXPECT_EQ(bus.clients(), 1U);
}

TEST_F(SocketcandServerRules, TextForAResetConnectionIsDiscarded) {
    TcpClient client{bus.port()};
    client.say(join);
    ASSERT_TRUE(until([&] { return client.heard() == joined; }));
    client.reset();
    // 7000 frames of 39 characters are more than the 262144 characters that may wait for a client
    while (log.size() < 7000) {
        send_one();
        ASSERT_FALSE(log.size() > 2 && bus.watches().back().writable) << log.size();
    }
    EXPECT_THAT(notices, IsEmpty());
    EXPECT_EQ(bus.clients(), 1U);
}

TEST_F(SocketcandServerRules, OnlyAClientThatHasNotOpenedTheBusIsClosedForANewClient) {
    const auto clients = clients_that(join, SocketcandBus::most_clients - 1);
    TcpClient idle{bus.port()};
    ASSERT_TRUE(until([&] { return bus.clients() == SocketcandBus::most_clients; }));
    pass(SocketcandBus::patience);
    TcpClient late{bus.port()};
    late.say(join);
    EXPECT_TRUE(until([&] { return late.heard() == joined && idle.ended(); }));
    EXPECT_FALSE(clients.front()->ended());
}

TEST_F(SocketcandServerRules, FirstDismissedClientIsClosedWhenTooManyDismissedClientsStay) {
    const auto idle = clients_that("", SocketcandBus::most_clients);
    pass(SocketcandBus::open_limit);
    EXPECT_EQ(bus.clients(), 0U);
    const auto clients = clients_that(join, SocketcandBus::most_clients);
    ASSERT_THAT(bus.watches(), SizeIs(1 + 2 * SocketcandBus::most_clients));
    const int second = bus.watches()[2].descriptor;
    TcpClient late{bus.port()};
    ASSERT_TRUE(until([&] { return late.ended(); }));
    EXPECT_THAT(bus.watches(), SizeIs(1 + 2 * SocketcandBus::most_clients));
    EXPECT_EQ(bus.watches()[1].descriptor, second);
}

TEST_F(SocketcandServerRules, RefusedClientIsReportedAlthoughAnIdleClientLeftEarlier) {
    {
        TcpClient idle{bus.port()};
        ASSERT_TRUE(until([&] { return bus.clients() == 1; }));
        pass(SocketcandBus::open_limit);
        pass(SocketcandBus::leave_limit);
        ASSERT_THAT(bus.watches(), SizeIs(1));
    }
    const auto clients = clients_that(join, SocketcandBus::most_clients);
    TcpClient late{bus.port()};
    ASSERT_TRUE(until([&] { return late.ended(); }));
    EXPECT_THAT(notices, SizeIs(1));
}

TEST_F(SocketcandServerRules, ClientThatOpensTheBusJustBeforeItsDeadlineStaysConnected) {
    TcpClient client{bus.port()};
    ASSERT_TRUE(until([&] { return bus.clients() == 1; }));
    const Instant limit = now + SocketcandBus::open_limit;
    now = Instant{limit.us - 1};
    client.say(join);
    ASSERT_TRUE(arrive());
    bus.poll(now);  // the text is read, and passed on when the run handles the moment of the limit
    bus.advance(limit);
    EXPECT_EQ(bus.clients(), 1U);
    now = limit;
    EXPECT_TRUE(until([&] { return client.heard() == joined; }));
}

TEST_F(SocketcandServerRules, TimesOfFramesCountFromTheRealTimeOfTheStart) {
    SocketcandBus later{{"127.0.0.1", 0}, 125000, {}, 1700000000000000};
    PlainNode sender{"sender"};
    later.attach(sender);
    TcpClient client{later.port()};
    client.say(join);
    for (int looks = 0; looks < most_looks && client.heard() != joined; ++looks) {
        later.poll(now);
        later.advance(now);
    }
    sender.send("555#AA");
    run_until(later, now, now + milliseconds(1));
    // 55 bits without stuff bits, at least one stuff bit after the seven zeros from RTR to the length: 56 bits of 8 us
    const std::string heard = client.heard();
    EXPECT_THAT(heard, HasSubstr("< frame 555 1700000000.0004"));
    EXPECT_EQ(later.report(now).bit_rate, 125000U);
}

TEST_F(SocketcandServerRules, BusOfTheServerHasFaultsWhenARateOfFaultsIsGiven) {
    SocketcandBus faulty{{"127.0.0.1", 0}, 1000000, BusFaultRates{0.5, 0.0, 0.0, 1}, 0};
    PlainNode sender{"sender"};
    faulty.attach(sender);
    for (int i = 0; i < 20; ++i) {
        sender.send("123#");
    }
    run_until(faulty, now, Instant{100000});
    EXPECT_EQ(faulty.report(Instant{100000}).frames, 20U);
    EXPECT_GT(faulty.report(Instant{100000}).errors, 0U);
}

TEST_F(SocketcandServerRules, ShortWritesAndReadsLoseNothing) {
    canproof::test::FakeKernel kernel;
    TcpClient client{bus.port()};
    client.say(join + "< send 123 1 AA >< send 124 1 BB >");
    canproof::test::FakeKernel::present() = &kernel;
    kernel.most_at_once = 7;
    EXPECT_TRUE(until([&] { return log.size() == 2; }));
    node.send("703#05");
    EXPECT_TRUE(until([&] { return client.heard().find("05 >") != std::string::npos; }));
    canproof::test::FakeKernel::present() = nullptr;
    EXPECT_THAT(log, testing::ElementsAre("123#AA", "124#BB", "703#05"));
    EXPECT_THAT(client.heard(), testing::MatchesRegex("< hi >< ok >< ok >< frame 703 [0-9.]+ 05 >"));
}

TEST_F(SocketcandServerRules, RemoteFrameIsNotReportedAsLostForADismissedClient) {
    TcpClient idle{bus.port()};
    ASSERT_TRUE(until([&] { return bus.clients() == 1; }));
    pass(SocketcandBus::open_limit);
    ASSERT_EQ(bus.clients(), 0U);
    ASSERT_EQ(bus.watches().size(), 2U);  // the client can still read the reason
    node.send("703#R");
    ASSERT_TRUE(until([&] { return log.size() == 1; }));
    EXPECT_THAT(notices, IsEmpty());
}

}  // namespace canproof::host::test
