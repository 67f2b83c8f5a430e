// SPDX-License-Identifier: Apache-2.0
// One socketcand client as text: commands of python-can and other clients, and limits on broken, slow and flooding
// clients.
#include "host/sim/bus/socketcand_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware/base/time.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;

class SocketcandClient : public testing::Test {
  protected:
    /// Passes text of the client to the session and returns the answer of the session.
    std::string say(const std::string& text, Instant now = Instant{}) {
        session.receive(text, now);
        return heard();
    }
    std::string heard() {
        std::string text = session.output();
        session.sent(text.size());
        return text;
    }
    void join(const std::string& mode = "< rawmode >") { say("< open can0 >" + mode); }
    /// Returns the frames that the client has sent to the bus.
    std::vector<std::string> frames() {
        std::vector<std::string> all;
        while (session.gateway().next_frame() != nullptr) {
            all.push_back(format_frame(*session.gateway().next_frame()));
            session.gateway().take_frame();
        }
        return all;
    }
    void arrives(const std::string& frame, std::uint64_t us = 0) {
        session.gateway().receive(parse_frame(frame, "test"), Instant{us});
    }

    SocketcandSession session{"client", 1700000000000000};
};

using Frames = std::vector<std::string>;

}  // namespace

TEST_F(SocketcandClient, ServerGreetsTheClient_OpensTheBusAndEntersRawMode) {
    EXPECT_EQ(heard(), "< hi >");
    EXPECT_EQ(say("< open can0 >"), "< ok >");
    EXPECT_EQ(say("< rawmode >"), "< ok >");
    EXPECT_EQ(say("< echo >"), "< echo >");
}

TEST_F(SocketcandClient, FramesAreWrittenInTheFormatOfSocketcand) {
    join();
    arrives("703#05", 1234567);
    EXPECT_EQ(heard(), "< frame 703 1700000001.234567 05 >");
    arrives("583#4300100091010800", 0);
    EXPECT_EQ(heard(), "< frame 583 1700000000.000000 4300100091010800 >");
    arrives("00000123#01");
    EXPECT_EQ(heard(), "< frame 00000123 1700000000.000000 01 >");
    arrives("080#");
    EXPECT_EQ(heard(), "< frame 080 1700000000.000000  >");  // python-can requires both blanks
    arrives("703#R");                                        // the protocol has no remote frames
    EXPECT_EQ(heard(), "");
}

TEST_F(SocketcandClient, SendCommandOfPythonCanIsRead) {
    join();
    EXPECT_EQ(say("< send 603 8 40 0 10 0 0 0 0 0 >"), "");
    EXPECT_EQ(say("< send 0 2 1 0 >< send 80 0  >"), "");
    EXPECT_EQ(say("< send 1FFFFFFF 1 a5 >< send 00000123 2 0102 >"), "");
    EXPECT_EQ(frames(), (Frames{"603#4000100000000000", "000#0100", "080#", "1FFFFFFF#A5", "00000123#0102"}));
}

TEST_F(SocketcandClient, CommandMayArriveInPieces) {
    join();
    for (const char* piece : {"<", " sen", "d 70", "3 1 0", "5", " ", ">"}) {
        EXPECT_EQ(say(piece), "");
    }
    EXPECT_EQ(frames(), Frames{"703#05"});
}

TEST_F(SocketcandClient, SendAndRawmodeAreRefusedBeforeOpen) {
    heard();
    EXPECT_EQ(say("< send 703 1 05 >"), "< error no bus is open >");
    EXPECT_EQ(say("< rawmode >"), "< error no bus is open >");
    EXPECT_EQ(say("< open >"), "< error could not open bus >");
    arrives("703#05");
    EXPECT_EQ(heard(), "");
    EXPECT_EQ(frames(), Frames{});
}

TEST_F(SocketcandClient, MalformedCommandIsRefusedAndTheNextIsExecuted) {
    join();
    for (const char* wrong : {"< send >", "< send 703 >", "< send 800 0 >", "< send 703 9 1 2 3 4 5 6 7 8 9 >",
                              "< send 703 2 1 >", "< send 703 1 1 2 >", "< send 703 1 100 >", "< send 703 1 xy >",
                              "< send -1 0 >", "< send 20000000 0 >", "< send 703 1 1x >"}) {
        EXPECT_THAT(say(wrong), HasSubstr("< error send takes")) << wrong;
    }
    EXPECT_THAT(say("< send 703 R >"), HasSubstr("no remote frames"));
    for (const char* wrong : {"<>", "< >", "< isotpmode >", "< SEND 703 0 >", "< subscribe 0 0 703 >"}) {
        EXPECT_EQ(say(wrong), "< error unknown command >") << wrong;
    }
    EXPECT_EQ(say("garbage \x01\xff > < echo >"), "< echo >");
    EXPECT_EQ(frames(), Frames{});
    EXPECT_FALSE(session.is_dropped());
}

TEST_F(SocketcandClient, DroppedClientGetsTheReasonAndIsNotReadAgain) {
    EXPECT_FALSE(session.has_joined());
    heard();
    session.send_away("too late");
    EXPECT_EQ(heard(), "< error too late >");
    EXPECT_EQ(say("< open can0 >< rawmode >< send 703 0 >"), "");
    EXPECT_FALSE(session.has_joined());
    EXPECT_EQ(frames(), Frames{});
}

TEST_F(SocketcandClient, EndlessCommandsAreCutOff_AndTheNextIsExecuted) {
    join();
    for (int i = 0; i < 100; ++i) {
        say("<" + std::string(4000, 'x'));
    }
    EXPECT_TRUE(session.wants_input());
    EXPECT_THAT(say("< echo >"), HasSubstr("< echo >"));
}

TEST_F(SocketcandClient, FloodingClientWaitsUntilItsFramesHaveLeftTheGateway) {
    join();
    std::string flood;
    for (int i = 0; i < 500; ++i) {
        flood += "< send 703 1 05 >";
    }
    say(flood);
    EXPECT_FALSE(session.wants_input());  // the session reads no further text
    std::size_t taken = 0;
    while (session.gateway().next_frame() != nullptr) {
        taken += frames().size();
        session.receive({}, Instant{});
    }
    EXPECT_EQ(taken, 500U);  // no frame is lost
    EXPECT_TRUE(session.wants_input());
}

TEST_F(SocketcandClient, ClientThatDoesNotReadIsDroppedWithBoundedMemory) {
    join();
    for (int i = 0; i < 100000; ++i) {
        arrives("583#4300100091010800");
    }
    EXPECT_TRUE(session.is_dropped());
    EXPECT_LE(session.output().size(), SocketcandSession::output_limit);
    EXPECT_THAT(session.dropped_because(), HasSubstr("did not read"));
}

TEST_F(SocketcandClient, BcmModeSendsTheSubscribedFrames) {
    join("");
    arrives("703#05");
    EXPECT_EQ(heard(), "");
    EXPECT_EQ(say("< subscribe 0 0 703 >"), "");
    arrives("704#05");
    arrives("703#05");
    EXPECT_EQ(heard(), "< frame 703 1700000000.000000 05 >");
    say("< unsubscribe 703 >");
    arrives("703#05");
    EXPECT_EQ(heard(), "");
    say("< send 123 0 >");
    EXPECT_EQ(frames(), Frames{"123#"});
}

TEST_F(SocketcandClient, StatisticsAreSentAtTheirPeriod) {
    join();
    say("< send 703 1 05 >< send 703 2 05 06 >");
    arrives("583#0102030405060708");
    heard();
    say("< controlmode >< statistics 500 >", Instant{1000});
    heard();
    EXPECT_EQ(session.next_deadline().us, 501000U);
    session.advance(Instant{500999});
    EXPECT_EQ(heard(), "");
    session.advance(Instant{501000});
    EXPECT_EQ(heard(), "< stat 8 1 3 2 >");  // bytes and frames received, then transmitted
    EXPECT_EQ(session.next_deadline().us, 1001000U);
    say("< statistics 0 >");
    EXPECT_EQ(session.next_deadline(), never);
    EXPECT_THAT(say("< statistics x >"), HasSubstr("< error statistics"));
    EXPECT_EQ(say("< send 703 0 >"), "< error unknown command >");  // control mode sends no frames
}

/// Statistics are those of the bus. A client gets none of these frames: it has subscribed to another identifier, the
/// second frame is a remote frame, and in control mode it gets no frames.
TEST_F(SocketcandClient, StatisticsCountFramesThatTheClientDoesNotReceive) {
    join("< subscribe 0 0 123 >");
    heard();
    arrives("703#05");
    arrives("123#R");
    say("< controlmode >");
    arrives("123#0102");
    say("< statistics 500 >");
    heard();
    session.advance(Instant{500000});
    EXPECT_EQ(heard(), "< stat 3 3 0 0 >");  // 1 + 0 + 2 bytes
}

}  // namespace canproof::host::test
