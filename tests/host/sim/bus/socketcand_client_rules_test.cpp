// SPDX-License-Identifier: Apache-2.0
// Devices on the bus of a scripted server: joining, server errors, times, load and frames that wait.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include "host/base/input_error.hpp"
#include "host/sim/bus/can_bits.hpp"
#include "tests/host/sim/bus/scripted_bus.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::uint64_t bits_of(const std::string& frame) {
    return frame_bits(parse_frame(frame, "test")) + 3U;
}

}  // namespace

TEST_F(ScriptedBus, ClientJoinsTheServerStepByStep) {
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

TEST_F(ScriptedBus, NextFrameFollowsAfterThePreviousFramesDurationRoundedUpToMicroseconds) {
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

TEST_F(ScriptedBus, FrameTimeIsRoundedUpUnlessItIsAWholeNumberOfMicroseconds) {
    for (const auto& [bit_rate, us] : {std::pair{125000U, bits_of("703#05") * 8U},
                                       std::pair{999999U, bits_of("703#05") + 1U},  // a bit lasts 1.000001 us
                                       // 58 bits last 467.0000081 us: 58,000,000 = 467 × 124,197 + 1
                                       std::pair{124197U, std::uint64_t{468}}}) {
        join(bit_rate);
        a.send("703#05");
        a.send("703#05");
        bus->advance(now);
        EXPECT_EQ(bus->next_deadline(), now + Duration{us}) << bit_rate;
        a.waiting.clear();
    }
}

TEST_F(ScriptedBus, LoadCoversReceivedAndSentFramesOfTheLastSecond) {
    join();
    EXPECT_DOUBLE_EQ(bus->report(now).load, 0.0);
    a.send("703#05");
    bus->advance(now);
    const Duration length{bits_of("703#05") * 8U};
    const double one = static_cast<double>(length.us) / 1.0e6;
    EXPECT_DOUBLE_EQ(bus->report(now).load, 0.0);  // the frame begins now
    EXPECT_NEAR(bus->report(now + length).load, one, 1.0e-9);
    now = now + milliseconds(500);
    say("< frame 703 1.0 05 >");
    bus->advance(now);
    EXPECT_NEAR(bus->report(now + length).load, 2.0 * one, 1.0e-9);
    const Instant second_after_first{2000000U + length.us};
    EXPECT_NEAR(bus->report(Instant{second_after_first.us - 1U}).load, one + 1.0e-6, 1.0e-9);
    EXPECT_NEAR(bus->report(second_after_first).load, one, 1.0e-9);
    now = now + milliseconds(2000);
    bus->advance(now);
    EXPECT_DOUBLE_EQ(bus->report(now).load, 0.0);
    EXPECT_EQ(bus->report(now).frames, 2U);
}

TEST_F(ScriptedBus, LoadCountsEachFramesDurationRoundedDownToNanoseconds) {
    join(1000001);  // a bit lasts 999.999 ns
    const double one = static_cast<double>(bits_of("703#05") * 1000U - 1U) / 1.0e9;
    for (int frames = 1; frames <= 3; ++frames) {
        a.send("703#05");
        bus->advance(now);
        now = now + milliseconds(1);  // longer than the frame
        EXPECT_NEAR(bus->report(now).load, frames * one, 1.0e-10) << frames;
    }
}

TEST_F(ScriptedBus, FirstByteOfACommandMayArriveAlone) {
    join();
    say("<");
    say(" frame 080 9.5 >");
    bus->advance(now);
    EXPECT_THAT(log, ElementsAre("1000000 - 080#"));
}

TEST_F(ScriptedBus, BitRateIs125000ByDefault) {
    connect(0);
    EXPECT_EQ(bus->report(now).bit_rate, 125000U);
}

TEST_F(ScriptedBus, ServerThatClosesTheConnectionBeforeTheClientHasJoinedIsAnError) {
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
    EXPECT_TRUE(server.ended());
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

TEST_F(ScriptedBus, EachConnectionReportsOnlyItsOwnErrors) {
    join();
    say("< error no such thing >");
    server.hang_up();
    hear();
    now = now + SocketcandClientBus::search_period;
    bus->poll(now);
    server.accept_one();
    say("< hi >< ok >< ok >");
    ASSERT_TRUE(bus->has_joined());
    bus->poll(now);
    EXPECT_THAT(notices, ElementsAre(HasSubstr("reports: no such thing"), HasSubstr("is gone (no such thing)"),
                                     HasSubstr("is joined again")));
    say("< error no such thing >");
    EXPECT_THAT(notices, SizeIs(4));
    EXPECT_THAT(notices.back(), HasSubstr("reports: no such thing"));
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

TEST_F(ScriptedBus, LostServerIsNotDetectedWithoutReadingOrSending) {
    join();
    server.reset_connection();
    errno = 0;
    bus->advance(now);
    EXPECT_TRUE(bus->has_joined());
    EXPECT_THAT(notices, IsEmpty());
}

TEST_F(ScriptedBus, ServerGreetingThatHasArrivedIsAnsweredInTheNextPoll) {
    connect();
    server.say("< hi >");
    pollfd waiting{bus->watches().at(0).descriptor, POLLIN, 0};
    ASSERT_GT(::poll(&waiting, 1, longest_wait_ms), 0);
    bus->poll(now);
    EXPECT_EQ(server.heard(), "< open vcan0 >");
}

TEST_F(ScriptedBus, FrameWithAnArrivalTimeBeforeTheBusTimeIsDueAtOnce) {
    join();
    bus->use_clock([] { return Instant{1000000}; });
    now = Instant{3600000000U};
    bus->advance(now);
    say("< frame 080 9.5 >");
    EXPECT_EQ(bus->next_deadline(), now);
}

TEST_F(ScriptedBus, ServerIsNotReadWhile65536FramesWait) {
    join();
    std::string frames;
    for (int i = 0; i < 2048; ++i) {
        frames += "<frame 1 0>";
    }
    for (int i = 0; i < 32; ++i) {
        ASSERT_TRUE(bus->watches().at(0).readable) << i;
        say(frames);
    }
    EXPECT_FALSE(bus->watches().at(0).readable);
    server.say("< error one more >");
    bus->poll(now);
    EXPECT_THAT(notices, IsEmpty());
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
