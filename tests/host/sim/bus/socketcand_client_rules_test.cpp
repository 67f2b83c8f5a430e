// SPDX-License-Identifier: Apache-2.0
// Devices on the bus of a scripted server: joining, server errors, times, load and frames that wait.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <memory>

#include "host/base/input_error.hpp"
#include "host/sim/bus/can_bits.hpp"
#include "host/sim/bus/socketcand_client_bus.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"
#include "tests/host/sim/bus/scripted_server.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int longest_wait_ms = 5000;  // reached only in a broken test

class ScriptedBus : public testing::Test {
  protected:
    void connect(std::uint32_t bit_rate = 125000) {
        bus =
            std::make_unique<SocketcandClientBus>(SocketcandPlace{"127.0.0.1", server.port(), "vcan0"}, bit_rate, now);
        bus->listen([this](const BusFrame& frame) {
            log.push_back(fmt::format("{} {} {}", frame.time.us, frame.sender == nullptr ? "-" : frame.sender->name(),
                                      format_frame(frame.frame)));
        });
        bus->on_notice([this](const std::string& text) { notices.push_back(text); });
        bus->attach(a);
        bus->attach(b);
        server.accept_one();
    }
    /// Waits until text of the server has arrived and reads it.
    void hear() {
        const std::vector<Watch> watches = bus->watches();
        ASSERT_THAT(watches, SizeIs(1));
        pollfd waiting{watches[0].descriptor, static_cast<short>(watches[0].readable ? POLLIN : POLLOUT), 0};
        ASSERT_GT(::poll(&waiting, 1, longest_wait_ms), 0);
        bus->poll(now);
    }
    void say(const std::string& text) {
        server.say(text);
        hear();
    }
    void join(std::uint32_t bit_rate = 125000) {
        connect(bit_rate);
        hear();  // the connection is established
        say("< hi >");
        say("< ok >");
        say("< ok >");
        ASSERT_TRUE(bus->has_joined());
        bus->advance(now);
    }

    ScriptedServer server;
    Instant now{1000000};
    PlainNode a{"a"};
    PlainNode b{"b"};
    std::unique_ptr<SocketcandClientBus> bus;
    std::vector<std::string> log;
    std::vector<std::string> notices;
};

std::uint64_t bits_of(const std::string& frame) {
    return frame_bits(parse_frame(frame, "test")) + 3U;
}

}  // namespace

TEST_F(ScriptedBus, ClientJoinsStepByStep) {
    connect();
    EXPECT_EQ(bus->next_deadline(), now + SocketcandClientBus::join_limit);
    EXPECT_TRUE(bus->watches().at(0).writable);
    EXPECT_FALSE(bus->watches().at(0).readable);
    hear();
    EXPECT_FALSE(bus->watches().at(0).writable);
    EXPECT_TRUE(bus->watches().at(0).readable);
    say("< hi >");
    EXPECT_EQ(server.heard(), "< open vcan0 >");
    say("< ok >");
    EXPECT_EQ(server.heard(), "< open vcan0 >< rawmode >");
    EXPECT_FALSE(bus->has_joined());
    say("< ok >");
    EXPECT_TRUE(bus->has_joined());
    EXPECT_EQ(bus->next_deadline(), never);
    EXPECT_THAT(notices, IsEmpty());
    EXPECT_THAT(a.states, IsEmpty());
    EXPECT_EQ(bus->interface(), "vcan0");
}

TEST_F(ScriptedBus, RepeatedServerErrorIsReportedOnce_AndADifferentErrorIsReported) {
    join();
    say("< error no such thing >");
    say("< error no such thing >");
    say("< error another >");
    const std::string name = fmt::format("127.0.0.1:{}/vcan0", server.port());
    EXPECT_THAT(notices, ElementsAre(name + " reports: no such thing", name + " reports: another"));
}

TEST_F(ScriptedBus, FramesOfTheServerArriveInTheirOrder) {
    join();
    now = now + microseconds(500);
    say("< frame 080 9.5 >< frame 703 1.0 05 >");
    EXPECT_EQ(bus->next_deadline(), now);
    EXPECT_THAT(log, IsEmpty());
    bus->advance(Instant{now.us - 1});
    EXPECT_THAT(log, IsEmpty());
    bus->advance(now);
    EXPECT_THAT(log, ElementsAre("1000500 - 080#", "1000500 - 703#05"));
    EXPECT_THAT(a.heard, ElementsAre("1000500 080#", "1000500 703#05"));
    EXPECT_THAT(b.heard, SizeIs(2));
    EXPECT_EQ(bus->next_deadline(), never);
}

TEST_F(ScriptedBus, NodeAndUserFramesAreSentInTheOrderOfArbitration) {
    join();
    a.send("183#");
    b.send("181#");
    bus->put(parse_frame("182#", "test"), now);
    for (int i = 0; i < 3; ++i) {
        bus->advance(now);
        now = bus->next_deadline() == never ? now : bus->next_deadline();
    }
    bus->advance(now);
    EXPECT_EQ(server.heard(), "< open vcan0 >< rawmode >< send 181 0 >< send 182 0 >< send 183 0 >");
    EXPECT_THAT(a.heard, SizeIs(2));
    EXPECT_THAT(b.heard, SizeIs(2));
    EXPECT_EQ(log.size(), 3U);
    EXPECT_THAT(log[1], HasSubstr(" - 182#"));
    EXPECT_THAT(log[2], HasSubstr(" a 183#"));
}

TEST_F(ScriptedBus, NodeFramePrecedesTheUserFrameOfTheSameIdentifier) {
    join();
    bus->put(parse_frame("181#02", "test"), now);
    a.send("181#01");
    bus->advance(now);
    EXPECT_THAT(log, ElementsAre("1000000 a 181#01"));
}

TEST_F(ScriptedBus, NextFrameFollowsAfterTheBitTimesOfThePreviousFrameRoundedUp) {
    join(300000);
    a.send("703#05");
    a.send("704#05");
    bus->advance(now);
    const std::uint64_t us = (bits_of("703#05") * 10U + 2U) / 3U;  // one bit lasts 3.33 us
    EXPECT_EQ(bus->next_deadline(), now + Duration{us});
    bus->advance(Instant{now.us + us - 1});
    EXPECT_THAT(log, SizeIs(1));
    bus->advance(Instant{now.us + us});
    EXPECT_THAT(log, SizeIs(2));
    EXPECT_EQ(bus->report(now).bit_rate, 300000U);
}

TEST_F(ScriptedBus, LoadCoversReceivedAndSentFramesOfTheLastSecond) {
    join();
    EXPECT_DOUBLE_EQ(bus->report(now).load, 0.0);
    a.send("703#05");
    bus->advance(now);
    const double one = static_cast<double>(bits_of("703#05") * 8U) / 1.0e6;
    EXPECT_NEAR(bus->report(now).load, one, 1.0e-9);
    now = now + milliseconds(500);
    say("< frame 703 1.0 05 >");
    bus->advance(now);
    EXPECT_NEAR(bus->report(now).load, 2.0 * one, 1.0e-9);
    const Instant end_of_first{1000000U + bits_of("703#05") * 8U};
    EXPECT_NEAR(bus->report(end_of_first + milliseconds(1000)).load, 2.0 * one, 1.0e-9);
    EXPECT_NEAR(bus->report(end_of_first + milliseconds(1000) + microseconds(1)).load, one, 1.0e-9);
    now = now + milliseconds(2000);
    bus->advance(now);
    EXPECT_DOUBLE_EQ(bus->report(now).load, 0.0);
    EXPECT_EQ(bus->report(now).frames, 2U);
}

TEST_F(ScriptedBus, BitRateIs125000WhenNoneIsGiven) {
    connect(0);
    EXPECT_EQ(bus->report(now).bit_rate, 125000U);
}

TEST_F(ScriptedBus, ServerThatClosesBeforeJoiningIsAnError) {
    connect();
    hear();
    server.hang_up();
    try {
        hear();
        FAIL() << "joined";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(fmt::format("cannot join 127.0.0.1:{}/vcan0", server.port())));
        EXPECT_THAT(error.what(), HasSubstr("the server has closed the connection"));
    }
}

TEST_F(ScriptedBus, LastErrorOfAClosingServerIsQuotedAsTheReason) {
    join();
    say("< error goodbye >");
    server.hang_up();
    hear();
    EXPECT_THAT(notices, ElementsAre(HasSubstr("reports: goodbye"), HasSubstr("is gone (goodbye); looking for it")));
    EXPECT_THAT(a.states, ElementsAre("1000000 3"));
    EXPECT_THAT(b.states, ElementsAre("1000000 3"));
    EXPECT_THAT(bus->watches(), IsEmpty());
    EXPECT_EQ(bus->next_deadline(), now + SocketcandClientBus::search_period);
}

TEST_F(ScriptedBus, LostServerIsContactedAgainAfterASecond_AndMustAnswerInTime) {
    join();
    server.hang_up();
    hear();
    a.send("703#05");
    now = now + Duration{SocketcandClientBus::search_period.us - 1};
    bus->poll(now);
    bus->advance(now);
    EXPECT_THAT(bus->watches(), IsEmpty());
    now = now + microseconds(1);
    bus->poll(now);
    EXPECT_THAT(bus->watches(), SizeIs(1));
    server.accept_one();
    EXPECT_EQ(bus->next_deadline(), now + SocketcandClientBus::join_limit);
    now = now + SocketcandClientBus::join_limit;
    bus->poll(now);  // the server has sent nothing
    EXPECT_THAT(bus->watches(), IsEmpty());
    EXPECT_EQ(bus->next_deadline(), now + SocketcandClientBus::search_period);
    EXPECT_THAT(notices, SizeIs(1));
    EXPECT_THAT(a.states, SizeIs(1));
    EXPECT_THAT(log, IsEmpty());
}

TEST_F(ScriptedBus, ReturnedServerGetsTheWaitingFrames) {
    join();
    server.hang_up();
    hear();
    now = now + SocketcandClientBus::search_period;
    bus->poll(now);
    server.accept_one();
    b.send("703#05");
    server.say("< hi >< ok >< ok >");
    hear();
    EXPECT_TRUE(bus->has_joined());
    EXPECT_THAT(notices,
                ElementsAre(HasSubstr("is gone (the server has closed the connection)"), HasSubstr("is joined again")));
    EXPECT_THAT(a.states, ElementsAre("1000000 3", "2000000 0"));
    bus->advance(now);
    EXPECT_THAT(server.heard(), HasSubstr("< send 703 1 05 >"));
    EXPECT_EQ(bus->next_deadline(), never);
}

TEST_F(ScriptedBus, ServerThatRefusesARejoinIsContactedAgainLater) {
    join();
    server.hang_up();
    hear();
    now = now + SocketcandClientBus::search_period;
    bus->poll(now);
    server.accept_one();
    say("< hi >< error full >");
    EXPECT_FALSE(bus->has_joined());
    EXPECT_THAT(bus->watches(), IsEmpty());
    EXPECT_EQ(bus->next_deadline(), now + SocketcandClientBus::search_period);
    EXPECT_THAT(notices, SizeIs(1));
}

TEST_F(ScriptedBus, ServerThatResetsTheConnectionIsLost) {
    join();
    server.reset_connection();
    hear();
    EXPECT_THAT(notices, ElementsAre(HasSubstr("is gone (Connection reset by peer)")));
    EXPECT_THAT(a.states, ElementsAre("1000000 3"));
}

TEST_F(ScriptedBus, FailedSendDetectsThatTheServerIsLost) {
    join();
    server.reset_connection();
    a.send("703#05");
    bus->advance(now);
    EXPECT_THAT(notices, ElementsAre(HasSubstr("is gone (")));
    EXPECT_FALSE(bus->has_joined());
    EXPECT_THAT(b.states, ElementsAre("1000000 3"));
}

TEST_F(ScriptedBus, BroadcastAddressOfAServerIsRefusedAtOnce) {
    // A connection to the broadcast address fails at once.
    EXPECT_THROW((SocketcandClientBus{{"255.255.255.255", 29536, "can0"}, 125000, now}), InputError);
}

TEST_F(ScriptedBus, UserRemoteFrameIsReportedAndNotSent) {
    join();
    bus->put(parse_frame("703#R", "test"), now);
    bus->advance(now);
    EXPECT_THAT(notices, SizeIs(1));
    EXPECT_EQ(server.heard(), "< open vcan0 >< rawmode >");
    EXPECT_THAT(a.heard, ElementsAre("1000000 703#R"));
}

TEST_F(ScriptedBus, BitRateThatLssSetsIsReportedOnce) {
    a.rate = 125000;
    join();
    a.rate = 0;
    bus->advance(now);
    EXPECT_THAT(notices, IsEmpty());
    a.rate = 250000;
    bus->advance(now);
    bus->advance(now);
    EXPECT_THAT(notices, ElementsAre(HasSubstr("a: LSS sets 250000 bit/s")));
}

}  // namespace canproof::host::test
