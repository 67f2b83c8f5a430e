// SPDX-License-Identifier: Apache-2.0
// The socketcand server over real TCP on the loopback: clients join, send and receive, are refused, dropped or closed.
#include "host/sim/bus/socketcand_bus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <memory>

#include "host/base/input_error.hpp"
#include "tests/host/sim/bus/socketcand_server.hpp"

namespace canproof::host::test {

namespace {

using canproof::test::TcpClient;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

}  // namespace

TEST_F(SocketcandServer, ClientJoinsSendsAndReceives) {
    TcpClient client{bus.port()};
    client.say(join + "< send 603 8 40 0 10 0 0 0 0 0 >");
    ASSERT_TRUE(until([&] { return log.size() == 1; }));
    EXPECT_THAT(log, ElementsAre("603#4000100000000000"));
    EXPECT_THAT(node.heard, SizeIs(1));
    node.send("583#4300100091010800");
    bus.advance(now);
    ASSERT_TRUE(until([&] { return client.heard().find("frame") != std::string::npos; }));
    EXPECT_THAT(client.heard(), HasSubstr("< frame 583 "));
    EXPECT_THAT(client.heard(), HasSubstr(" 4300100091010800 >"));
    EXPECT_THAT(client.heard(), testing::StartsWith(joined));
    EXPECT_THAT(client.heard(), testing::Not(HasSubstr("< frame 603 ")));  // a client does not receive its own frame
    EXPECT_THAT(notices, SizeIs(0));
}

TEST_F(SocketcandServer, ClientsReceiveFramesOfEachOther) {
    TcpClient one{bus.port()};
    TcpClient two{bus.port()};
    one.say(join);
    two.say(join);
    ASSERT_TRUE(until([&] { return one.heard() == joined && two.heard() == joined; }));
    one.say("< send 123 1 AA >");
    ASSERT_TRUE(until([&] { return two.heard().find("< frame 123 ") != std::string::npos; }));
    EXPECT_EQ(one.heard(), joined);
}

TEST_F(SocketcandServer, FramesSentBeforeAClientClosesAreTransmitted) {
    {
        TcpClient client{bus.port()};
        client.say("< open can0 >< send 123 0 >< send 124 0 >");
        ASSERT_TRUE(until([&] { return bus.clients() == 1; }));
    }
    ASSERT_TRUE(until([&] { return bus.clients() == 0; }));
    EXPECT_THAT(log, ElementsAre("123#", "124#"));
}

TEST_F(SocketcandServer, FloodingClientDelaysOthersByAtMostTwoFrames) {
    TcpClient flood{bus.port()};
    TcpClient calm{bus.port()};
    flood.say(join);
    calm.say(join);
    ASSERT_TRUE(until([&] { return calm.heard() == joined; }));
    std::string much;
    for (int i = 0; i < 200; ++i) {
        much += "< send 0 0 >";  // the identifier with the highest priority
    }
    while (flood.push(much)) {
    }
    ASSERT_TRUE(until([&] { return log.size() > 100; }));
    const std::size_t before = log.size();
    node.send("77F#05");
    ASSERT_TRUE(until([&] { return std::find(log.begin(), log.end(), "77F#05") != log.end(); }));
    const auto at = static_cast<std::size_t>(std::find(log.begin(), log.end(), "77F#05") - log.begin());
    EXPECT_LE(at, before + 2);
    ASSERT_TRUE(until([&] { return calm.heard().find("< frame 77F ") != std::string::npos; }));
}

TEST_F(SocketcandServer, ClientThatNeverReadsIsDroppedAndOthersLoseNothing) {
    TcpClient slow{bus.port()};
    TcpClient calm{bus.port()};
    slow.say(join);
    calm.say(join);
    ASSERT_TRUE(until([&] { return calm.heard() == joined && bus.watches().size() == 3; }));
    const int descriptor_of_slow = bus.watches()[1].descriptor;
    std::size_t sent = 0;
    ASSERT_TRUE(until([&] {
        for (int i = 0; i < 200 && node.waiting.size() < 200; ++i, ++sent) {
            node.send("583#4300100091010800");
        }
        calm.heard();
        return bus.clients() == 1;
    }));
    ASSERT_THAT(notices, SizeIs(1));
    EXPECT_EQ(notices[0], fmt::format("client {} was dropped: the client did not read the text that was sent to it",
                                      descriptor_of_slow));
    ASSERT_TRUE(until([&] { return node.waiting.empty() && log.size() == sent; }));
    std::size_t frames = 0;
    ASSERT_TRUE(until([&] {
        const std::string text = calm.heard();
        frames = 0;
        for (auto found = text.find("< frame "); found != std::string::npos; found = text.find("< frame ", found + 1)) {
            ++frames;
        }
        return frames == sent;
    }));
    EXPECT_EQ(frames, sent);
}

TEST_F(SocketcandServer, ClientBeyondTheLimitIsRefusedWithTheReason) {
    auto clients = clients_that(join, SocketcandBus::most_clients);
    TcpClient late{bus.port()};
    ASSERT_TRUE(until([&] { return late.ended(); }));
    EXPECT_EQ(late.heard(), "< hi >< error 32 clients have joined, which is the most; try again when one has left >");
    EXPECT_EQ(bus.clients(), SocketcandBus::most_clients);
    EXPECT_THAT(notices, ElementsAre(HasSubstr("refused")));
    clients.pop_back();
    ASSERT_TRUE(until([&] { return bus.clients() < SocketcandBus::most_clients; }));
    TcpClient next{bus.port()};
    next.say(join);
    EXPECT_TRUE(until([&] { return next.heard() == joined; }));
    TcpClient too_late{bus.port()};
    ASSERT_TRUE(until([&] { return too_late.ended(); }));
    EXPECT_THAT(notices, SizeIs(2));  // a second notice, because a client had left in between
}

TEST_F(SocketcandServer, NewClientReplacesNoIdleClientWithinASecond) {
    const auto idle = clients_that("", SocketcandBus::most_clients);
    pass(Duration{SocketcandBus::patience.us - 1});
    TcpClient late{bus.port()};
    ASSERT_TRUE(until([&] { return late.ended(); }));
    EXPECT_THAT(late.heard(), HasSubstr("32 clients have joined"));
    EXPECT_FALSE(idle.front()->ended());
}

TEST_F(SocketcandServer, StatisticsAreSentAtTheEndOfTheirPeriod) {
    TcpClient client{bus.port()};
    client.say(join + "< send 123 2 01 02 >< statistics 700 >");
    ASSERT_TRUE(until([&] { return log.size() == 1 && bus.next_deadline() != never; }));
    EXPECT_LE(bus.next_deadline(), now + milliseconds(700));
    pass(Duration{elapsed(now, bus.next_deadline()).us - 1});
    client.say("< echo >");
    ASSERT_TRUE(until([&] { return client.heard() == joined + "< echo >"; }));
    pass(microseconds(1));
    ASSERT_TRUE(until([&] { return client.heard() == joined + "< echo >< stat 0 0 2 1 >"; }));
    EXPECT_EQ(bus.next_deadline(), now + milliseconds(700));
}

TEST_F(SocketcandServer, SocketOfABlockedClientIsNotWatchedForReading) {
    TcpClient flood{bus.port()};
    flood.say(join);
    ASSERT_TRUE(until([&] { return flood.heard() == joined; }));
    EXPECT_THAT(bus.watches(), SizeIs(2));
    std::string much;
    for (int i = 0; i < 1000; ++i) {
        much += "< send 123 0 >";
    }
    flood.say(much);
    for (int turn = 0; turn < 4; ++turn) {
        pass(Duration{});  // no time passes, so the gateway and the text buffer of the client fill up
    }
    EXPECT_THAT(bus.watches(), SizeIs(1));
    run_until(bus, now,
              now + milliseconds(500));  // the buffered frames are sent as the bus takes them, without further reading
    now = now + milliseconds(500);
    EXPECT_GT(log.size(), 300U);  // 4096 characters contain 292 commands, and the gateway holds 32 more
    flood.hang_up();
    ASSERT_TRUE(until([&] { return bus.clients() == 0; }));
    EXPECT_THAT(log, SizeIs(1000));
}

TEST_F(SocketcandServer, SocketOfAClientThatDoesNotReadIsWatchedForWriting) {
    TcpClient slow{bus.port()};
    slow.say(join);
    ASSERT_TRUE(until([&] { return slow.heard() == joined; }));
    const auto waits = [&] { return bus.watches().back().writable; };
    for (int i = 0; i < 200000 && !waits(); ++i) {
        node.send("583#4300100091010800");
        bus.advance(now);
        now = bus.next_deadline();
        bus.advance(now);
    }
    EXPECT_TRUE(waits());
    EXPECT_EQ(bus.clients(), 1U);
}

TEST_F(SocketcandServer, ClientWithAResetConnectionIsRemoved) {
    TcpClient client{bus.port()};
    client.say(join);
    ASSERT_TRUE(until([&] { return client.heard() == joined; }));
    client.reset();
    for (int i = 0; i < 3; ++i) {  // sending detects the reset before anything is read
        node.send("703#05");
        bus.advance(now);
        now = bus.next_deadline();
        bus.advance(now);
    }
    EXPECT_EQ(bus.clients(), 1U);
    EXPECT_TRUE(until([&] { return bus.clients() == 0 && log.size() == 3; }));
}

TEST_F(SocketcandServer, ServerForwardsTheNoticesOfTheBus) {
    node.rate = 1000000;
    bus.advance(now);
    node.rate = 500000;
    bus.advance(now);
    EXPECT_THAT(notices, ElementsAre(HasSubstr("node: LSS sets 500000 bit/s")));
}

TEST_F(SocketcandServer, ClosedClientLeavesNoDeadline) {
    {
        TcpClient client{bus.port()};
        client.say(join + "< statistics 700 >");
        ASSERT_TRUE(until([&] { return client.heard() == joined && bus.next_deadline() != never; }));
    }
    ASSERT_TRUE(until([&] { return bus.clients() == 0; }));
    EXPECT_EQ(bus.next_deadline(), never);
    EXPECT_THAT(bus.watches(), SizeIs(1));
    EXPECT_THAT(notices, SizeIs(0));
}

TEST_F(SocketcandServer, NewClientReplacesTheOldestClientThatHasNotOpenedTheBus) {
    const auto idle = clients_that("", SocketcandBus::most_clients);
    pass(SocketcandBus::patience);
    TcpClient late{bus.port()};
    late.say(join);
    EXPECT_TRUE(until([&] { return late.heard() == joined; }));
    ASSERT_TRUE(until([&] { return idle.front()->ended(); }));
    EXPECT_EQ(idle.front()->heard(),
              "< hi >< error another client needs the place, and this one has not opened the bus >");
    EXPECT_FALSE(idle.back()->ended());
}

TEST_F(SocketcandServer, RefusedClientsUseABoundedNumberOfConnections) {
    const auto clients = clients_that(join, SocketcandBus::most_clients);
    std::vector<std::unique_ptr<TcpClient>> late;
    for (std::size_t i = 0; i < 2 * SocketcandBus::most_clients; ++i) {
        late.push_back(std::make_unique<TcpClient>(bus.port()));
        ASSERT_TRUE(until([&] { return late.back()->ended(); }));
    }
    // the listener, the clients that have joined, and as many that are refused and can still read the reason
    EXPECT_EQ(bus.watches().size(), 1 + 2 * SocketcandBus::most_clients);
    EXPECT_THAT(notices, SizeIs(1));
}

TEST_F(SocketcandServer, ClientThatNeverOpensTheBusIsDropped_AndASilentJoinedClientStays) {
    pass(milliseconds(20000));
    TcpClient silent{bus.port()};
    silent.say(join);
    ASSERT_TRUE(until([&] { return silent.heard() == joined; }));
    TcpClient idle{bus.port()};
    ASSERT_TRUE(until([&] { return bus.clients() == 2; }));
    EXPECT_EQ(bus.next_deadline(), now + SocketcandBus::open_limit);
    pass(Duration{SocketcandBus::open_limit.us - 1});
    EXPECT_EQ(bus.clients(), 2U);
    pass(microseconds(1));
    EXPECT_EQ(bus.clients(), 1U);
    EXPECT_EQ(bus.next_deadline(), now + SocketcandBus::leave_limit);
    ASSERT_TRUE(until([&] { return idle.ended(); }));
    EXPECT_EQ(idle.heard(), "< hi >< error the bus was not opened within 10 s >");
    idle.say(join);  // too late: the client receives the reason and nothing else
    pass(SocketcandBus::leave_limit);
    EXPECT_EQ(bus.watches().size(), 2U);  // the listener and the remaining client
    pass(milliseconds(3600000));
    EXPECT_EQ(bus.clients(), 1U);
    node.send("703#05");
    EXPECT_TRUE(until([&] { return silent.heard().find("< frame 703 ") != std::string::npos; }));
}

TEST_F(SocketcandServer, ConnectionHasTheKeepaliveOptions) {
    TcpClient client{bus.port()};
    client.say(join);
    ASSERT_TRUE(until([&] { return client.heard() == joined; }));
    const int descriptor = bus.watches().back().descriptor;
    const auto option = [&](int level, int name) {
        int value = 0;
        socklen_t size = sizeof value;
        EXPECT_EQ(getsockopt(descriptor, level, name, &value, &size), 0);
        return value;
    };
    EXPECT_EQ(option(SOL_SOCKET, SO_KEEPALIVE), 1);
    EXPECT_NE(option(IPPROTO_TCP, TCP_NODELAY), 0);
    // After 30 s of silence the kernel sends three probes 10 s apart. The place of the client is free after one minute.
    EXPECT_EQ(option(IPPROTO_TCP, TCP_KEEPIDLE), 30);
    EXPECT_EQ(option(IPPROTO_TCP, TCP_KEEPINTVL), 10);
    EXPECT_EQ(option(IPPROTO_TCP, TCP_KEEPCNT), 3);
}

TEST_F(SocketcandServer, RemoteFrameThatClientsCannotReceiveIsReportedOnce) {
    node.send("703#R");
    ASSERT_TRUE(until([&] { return log.size() == 1; }));
    EXPECT_THAT(notices, SizeIs(0));  // no client is connected that would miss the frame
    TcpClient client{bus.port()};
    client.say(join);
    ASSERT_TRUE(until([&] { return client.heard() == joined; }));
    node.send("703#R");
    node.send("704#R");
    ASSERT_TRUE(until([&] { return log.size() == 3; }));
    EXPECT_THAT(notices, ElementsAre(HasSubstr("703#R is a remote frame")));
    EXPECT_THAT(notices[0], HasSubstr("--bus socketcan"));
    EXPECT_EQ(client.heard(), joined);
}

TEST_F(SocketcandServer, LastFrameOfAClosingClientIsComplete) {
    {
        TcpClient client{bus.port()};
        client.say(join + "< send 123 1 AA >");
        ASSERT_TRUE(until([&] { return client.heard() == joined; }));
        bus.poll(now);
        bus.advance(now);  // the frame is on the bus and not complete yet
    }
    bus.poll(now);
    EXPECT_THAT(bus.watches(), SizeIs(1));  // the client sends no more, and no output waits for it
    EXPECT_GT(bus.next_deadline(), now);    // the next event is the end of the frame
    EXPECT_TRUE(until([&] { return bus.clients() == 0; }));
    EXPECT_THAT(log, ElementsAre("123#AA"));
}

TEST_F(SocketcandServer, ListenAddressIsReadAndIsTheLoopbackByDefault) {
    EXPECT_EQ(parse_listen_address("").host, "127.0.0.1");
    EXPECT_EQ(parse_listen_address("").port, 29536);
    EXPECT_EQ(parse_listen_address(":0").host, "127.0.0.1");
    EXPECT_EQ(parse_listen_address(":0").port, 0);
    EXPECT_EQ(parse_listen_address("0.0.0.0:1234").host, "0.0.0.0");
    EXPECT_EQ(parse_listen_address("0.0.0.0:1234").port, 1234);
    EXPECT_EQ(parse_listen_address("[::1]:1234").host, "::1");
    EXPECT_EQ(parse_listen_address("[::1]").host, "::1");
    EXPECT_EQ(parse_listen_address("[::1").host, "[:");    // the closing bracket is missing
    EXPECT_EQ(parse_listen_address("::1]").host, "::1]");  // the opening bracket is missing
    EXPECT_EQ(parse_listen_address("[]:1234").host, "127.0.0.1");
    EXPECT_EQ(parse_listen_address(":65535").port, 65535);
    for (const char* wrong : {"127.0.0.1:x", "127.0.0.1:65536", "127.0.0.1:100000", "127.0.0.1:-1", "127.0.0.1:029536",
                              "127.0.0.1:99999999999999999999"}) {
        EXPECT_THROW(parse_listen_address(wrong), InputError) << wrong;
    }
    EXPECT_THROW((SocketcandBus{{"127.0.0.1", bus.port()}, 125000, {}, 0}), InputError);  // the port is in use
    EXPECT_THROW((SocketcandBus{{"nowhere", 0}, 125000, {}, 0}), InputError);
    EXPECT_THROW((SocketcandBus{{"localhost", 0}, 125000, {}, 0}), InputError);  // a name, not an address
}

TEST_F(SocketcandServer, CommandThatWaitedForTheBusFollowsTheStatisticsAndIsAnsweredAtOnce) {
    TcpClient client{bus.port()};
    client.say(join);
    ASSERT_TRUE(until([&] { return client.heard() == joined; }));
    // The bus sends one frame, and the gateway keeps 32. The last command waits until there is room.
    std::string text = "< statistics 1 >< echo >";
    for (int i = 0; i < 33; ++i) {
        text += "< send 123 0 >";
    }
    client.say(text + "< echo >");
    const std::string before = joined + "< echo >";
    ASSERT_TRUE(until([&] { return client.heard() == before; }));
    now = now + milliseconds(1);  // now the statistics are due, and there is room in the gateway
    bus.advance(now);
    client.wait(1000);
    EXPECT_EQ(client.heard(), before + "< stat 0 0 0 33 >< echo >");
}

}  // namespace canproof::host::test
