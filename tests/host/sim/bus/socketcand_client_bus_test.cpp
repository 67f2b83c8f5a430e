// SPDX-License-Identifier: Apache-2.0
// Devices of this program join the bus of a server over real TCP on the loopback. The server is that of canproof and
// runs in virtual time.
#include "host/sim/bus/socketcand_client_bus.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <memory>

#include "host/base/input_error.hpp"
#include "host/sim/bus/socketcand_bus.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"
#include "tests/host/sim/bus/scripted_bus.hpp"
#include "tests/support/descriptor_limit.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int look_again_ms = 10;
constexpr int most_looks = 500;  // reached only in a broken test
// Virtual time goes on to a deadline that is at most this far away: those of a bus are, those of joining and searching
// are not.
constexpr Duration soon = milliseconds(500);

class SocketcandServerElsewhere : public testing::Test {
  protected:
    SocketcandServerElsewhere() { start_server(0); }
    void start_server(std::uint16_t port) {
        server = std::make_unique<SocketcandBus>(ListenAddress{"127.0.0.1", port}, 125000, BusFaultRates{}, 0);
        server->attach(far);
    }
    std::unique_ptr<SocketcandClientBus> client_of(std::uint16_t port) {
        return std::make_unique<SocketcandClientBus>(SocketcandPlace{"127.0.0.1", port, "can0"}, 125000, now);
    }
    void start() {
        bus = client_of(server->port());
        bus->listen([this](const BusFrame& frame) {
            log.push_back(
                fmt::format("{} {}", frame.sender == nullptr ? "-" : frame.sender->name(), format_frame(frame.frame)));
        });
        bus->on_notice([this](const std::string& text) { notices.push_back(text); });
        bus->attach(a);
        bus->attach(b);
    }
    /// Runs server and client until `done`. Virtual time passes only while a bus has work.
    template <typename Condition>
    bool until(const Condition& done) {
        for (int looks = 0; looks < most_looks;) {
            turn();
            if (done()) {
                return true;
            }
            Instant due = bus ? bus->next_deadline() : never;
            due = server ? earliest(due, server->next_deadline()) : due;
            if (due <= now + soon) {
                now = now < due ? due : now;
            } else {
                looks += wait_for_the_kernel() ? 0 : 1;
            }
        }
        return false;
    }
    bool wait_for_the_kernel() const {
        std::vector<pollfd> waiting;
        for (const Bus* one : {static_cast<const Bus*>(server.get()), static_cast<const Bus*>(bus.get())}) {
            for (const Watch& watch : one == nullptr ? std::vector<Watch>{} : one->watches()) {
                const int events = (watch.readable ? POLLIN : 0) | (watch.writable ? POLLOUT : 0);
                waiting.push_back({watch.descriptor, static_cast<short>(events), 0});
            }
        }
        return ::poll(waiting.data(), waiting.size(), look_again_ms) > 0;
    }
    void turn() {
        for (Bus* one : {static_cast<Bus*>(server.get()), static_cast<Bus*>(bus.get())}) {
            if (one != nullptr) {
                one->poll(now);
                one->advance(now);
            }
        }
    }
    void join() {
        start();
        ASSERT_TRUE(until([&] { return bus->has_joined(); }));
    }
    static std::vector<std::string> without_times(std::vector<std::string> heard) {
        for (std::string& one : heard) {
            one.erase(0, one.find(' ') + 1);
        }
        return heard;
    }
    /// Returns the message with which the bus gives up joining.
    std::string refusal() {
        try {
            until([] { return false; });
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    Instant now{1000000};
    PlainNode far{"far"};
    PlainNode a{"a"};
    PlainNode b{"b"};
    std::unique_ptr<SocketcandBus> server;
    std::unique_ptr<SocketcandClientBus> bus;
    std::vector<std::string> log;
    std::vector<std::string> notices;
};

}  // namespace

TEST_F(SocketcandServerElsewhere, LocalDevicesExchangeFramesWithDevicesBehindTheServer) {
    join();
    a.send("703#05");
    ASSERT_TRUE(until([&] { return far.heard.size() == 1; }));
    far.send("583#4300100091010800");
    ASSERT_TRUE(until([&] { return b.heard.size() == 2; }));
    EXPECT_THAT(without_times(far.heard), ElementsAre("703#05"));
    EXPECT_THAT(without_times(a.heard), ElementsAre("583#4300100091010800"));
    EXPECT_THAT(without_times(b.heard), ElementsAre("703#05", "583#4300100091010800"));
    EXPECT_THAT(log, ElementsAre("a 703#05", "- 583#4300100091010800"));
    EXPECT_EQ(bus->report(now).frames, 2U);
}

TEST_F(SocketcandServerElsewhere, FramesWaitUntilTheServerAcceptsTheClient) {
    start();
    a.send("703#00");
    EXPECT_TRUE(bus->put(parse_frame("000#0100", "test"), now));
    bus->advance(now);
    EXPECT_THAT(log, IsEmpty());
    EXPECT_THAT(a.states, IsEmpty());
    ASSERT_TRUE(until([&] { return far.heard.size() == 2; }));
    EXPECT_THAT(without_times(far.heard), ElementsAre("000#0100", "703#00"));  // in the order of arbitration
    EXPECT_THAT(log, ElementsAre("- 000#0100", "a 703#00"));
}

TEST_F(SocketcandServerElsewhere, FramesAreSpacedByTheBitRate) {
    join();
    // 44 bits, at least one stuff bit after the seven zeros from RTR to the length, and 3 bits between frames: 48 bits
    // of 8 µs.
    a.send("555#");
    b.send("555#");
    bus->advance(now);
    EXPECT_THAT(log, SizeIs(1));
    bus->advance(now + microseconds(383));
    EXPECT_THAT(log, SizeIs(1));
    const Instant next = bus->next_deadline();
    EXPECT_LE(next, now + microseconds(480));  // 60 bits at 125 kbit/s
    bus->advance(next);
    EXPECT_THAT(log, ElementsAre("a 555#", "b 555#"));
}

TEST_F(SocketcandServerElsewhere, MissingServerIsAnError) {
    const std::uint16_t port = server->port();
    server.reset();
    std::string why;
    try {
        bus = client_of(port);
        why = refusal();
    } catch (const InputError& error) {
        why = error.what();
    }
    EXPECT_THAT(why, HasSubstr("Connection refused"));
    EXPECT_THAT(why, HasSubstr("--bus socketcand-client:"));
    EXPECT_THROW((SocketcandClientBus{{"256.0.0.1", 1, "can0"}, 125000, now}), InputError);
}

TEST_F(SocketcandServerElsewhere, RefusalOfTheServerIsQuoted) {
    std::vector<std::unique_ptr<SocketcandClientBus>> others;
    for (std::size_t i = 0; i < SocketcandBus::most_clients; ++i) {
        others.push_back(client_of(server->port()));
        ASSERT_TRUE(until([&] {
            others.back()->poll(now);
            return others.back()->has_joined();
        }));
    }
    start();
    EXPECT_THAT(refusal(), HasSubstr("32 clients have joined"));
}

TEST_F(SocketcandServerElsewhere, ClientGivesUpASilentServerAfter5s) {
    const int silent = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ASSERT_EQ(bind(silent, reinterpret_cast<const sockaddr*>(&address), size), 0);
    ASSERT_EQ(listen(silent, 1), 0);
    getsockname(silent, reinterpret_cast<sockaddr*>(&address), &size);
    bus = client_of(ntohs(address.sin_port));
    now = now + Duration{SocketcandClientBus::join_limit.us - 1};
    turn();
    now = now + microseconds(1);
    try {
        turn();
        ADD_FAILURE() << "it waits for ever";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("within 5 s"));
    }
    close(silent);
}

TEST_F(SocketcandServerElsewhere, LossOfTheServerIsBusOff_AndTheServerIsJoinedAgain) {
    join();
    const std::uint16_t port = server->port();
    server.reset();
    ASSERT_TRUE(until([&] { return !a.states.empty(); }));
    EXPECT_THAT(without_times(a.states), ElementsAre(std::to_string(static_cast<int>(CanState::bus_off))));
    EXPECT_THAT(notices, ElementsAre(HasSubstr("is gone")));
    for (int i = 0; i < 3; ++i) {  // the bus searches repeatedly and reports nothing new
        now = now + SocketcandClientBus::search_period;
        ASSERT_TRUE(until([&] { return bus->next_deadline() > now && bus->watches().empty(); }));
    }
    EXPECT_THAT(notices, SizeIs(1));
    start_server(port);
    now = now + SocketcandClientBus::search_period;
    ASSERT_TRUE(until([&] { return bus->has_joined(); }));
    EXPECT_EQ(without_times(b.states).back(), std::to_string(static_cast<int>(CanState::error_active)));
    EXPECT_THAT(notices, ElementsAre(HasSubstr("is gone"), HasSubstr("joined again")));
    a.send("703#05");
    EXPECT_TRUE(until([&] { return far.heard.size() == 1; }));
}

TEST_F(SocketcandServerElsewhere, RemoteFrameIsReportedOnceAndNotSent) {
    join();
    a.send("704#R");
    a.send("704#R");
    a.send("703#05");
    ASSERT_TRUE(until([&] { return far.heard.size() == 1; }));
    EXPECT_THAT(without_times(far.heard), ElementsAre("703#05"));
    EXPECT_THAT(without_times(b.heard), ElementsAre("704#R", "704#R", "703#05"));
    EXPECT_THAT(notices, ElementsAre(HasSubstr("704#R is a remote frame")));
}

TEST_F(SocketcandServerElsewhere, BitRateThatLssSelectsIsReportedOnce) {
    a.rate = 125000;
    join();
    a.rate = 250000;
    bus->advance(now);
    bus->advance(now);
    EXPECT_THAT(notices, ElementsAre(HasSubstr("a: LSS sets 250000 bit/s")));
}

TEST_F(SocketcandServerElsewhere, UpTo256FramesFromTheUserWaitUntilTheServerAcceptsTheClient) {
    start();
    int taken = 0;
    while (taken < 1000 && bus->put(parse_frame("123#", "test"), now)) {
        ++taken;
    }
    EXPECT_EQ(taken, 256);
    ASSERT_TRUE(until([&] { return far.heard.size() == 256; }));
    EXPECT_TRUE(bus->put(parse_frame("123#", "test"), now));
}

TEST_F(ScriptedBus, PendingConnectionIsWatchedUntilItIsEstablished) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(server.port());
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    std::vector<int> others;
    bool full = false;
    while (!full && others.size() < 64) {  // the server accepts none of them
        others.push_back(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
        const int started = ::connect(others.back(), reinterpret_cast<const sockaddr*>(&address), sizeof address);
        ASSERT_TRUE(started == 0 || errno == EINPROGRESS);
        sockaddr_in peer{};
        socklen_t size = sizeof peer;
        full = getpeername(others.back(), reinterpret_cast<sockaddr*>(&peer), &size) != 0;
    }
    ASSERT_TRUE(full);
    SocketcandClientBus pending{{"127.0.0.1", server.port(), "can0"}, 125000, now};
    pending.poll(now);
    ASSERT_THAT(pending.watches(), SizeIs(1));
    EXPECT_TRUE(pending.watches()[0].writable);
    EXPECT_FALSE(pending.watches()[0].readable);
    for (const int one : others) {
        close(one);
    }
}

TEST_F(ScriptedBus, ConnectionIsOpenedWithTcpNoDelay) {
    join();
    int value = 0;
    socklen_t size = sizeof value;
    EXPECT_EQ(getsockopt(bus->watches().at(0).descriptor, IPPROTO_TCP, TCP_NODELAY, &value, &size), 0);
    EXPECT_NE(value, 0);
}

TEST_F(ScriptedBus, ClosedBusClosesItsConnection) {
    join();
    bus.reset();
    EXPECT_TRUE(server.ended());
}

TEST_F(ScriptedBus, LackOfFileDescriptorsIsReportedAsTheReason) {
    join();
    const int descriptor = dup(bus->watches().at(0).descriptor);
    close(descriptor);
    const DescriptorLimit limit{descriptor};
    try {
        const SocketcandClientBus second{{"127.0.0.1", server.port(), "can0"}, 125000, now};
        FAIL() << "connects";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("(Too many open files)"));
    }
}

}  // namespace canproof::host::test
