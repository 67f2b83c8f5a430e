// SPDX-License-Identifier: Apache-2.0
// Text that a client sends to a socketcand server, and its reaction to the answers.
#include "host/sim/bus/socketcand_client.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware/canopen/frame.hpp"
#include "host/base/input_error.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/bus/socketcand_client_bus.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class SocketcandClientText : public testing::Test {
  protected:
    /// Passes this text of the server to the client and returns the answer of the client.
    std::string hear(const std::string& text) {
        client.take(text);
        std::string said = client.output();
        client.sent(said.size());
        return said;
    }
    void join() { hear("< hi >< ok >< ok >"); }

    std::vector<std::string> frames;
    SocketcandClient client{"vcan0", [this](const Frame& frame) { frames.push_back(format_frame(frame)); }};
};

}  // namespace

TEST_F(SocketcandClientText, ClientOpensTheBusAndEntersRawMode) {
    EXPECT_EQ(client.output(), "");
    EXPECT_EQ(hear("< hi >"), "< open vcan0 >");
    EXPECT_EQ(hear("< ok >"), "< rawmode >");
    EXPECT_FALSE(client.has_joined());
    EXPECT_EQ(hear("< ok >"), "");
    EXPECT_TRUE(client.has_joined());
    EXPECT_EQ(hear("< hi >< ok >"), "");
}

TEST_F(SocketcandClientText, FramesAreReadAsServersWriteThem) {
    join();
    hear("< frame 703 1700000001.234567 05 >< frame 583 0.0 4300100091010800 >");
    // the blanks are those of socketcand's manual
    hear("< frame 00000123 1.0 01 >< frame 080 1.000000  >< frame 123 23.424242 11 22 33 44 >");
    EXPECT_THAT(frames, ElementsAre("703#05", "583#4300100091010800", "00000123#01", "080#", "123#11223344"));
}

TEST_F(SocketcandClientText, FrameMayArriveInPieces) {
    join();
    for (const char* piece : {"<", " fra", "me 70", "3 1.0 0", "5", " ", ">"}) {
        hear(piece);
    }
    EXPECT_THAT(frames, ElementsAre("703#05"));
}

TEST_F(SocketcandClientText, UnknownAndMalformedMessagesAreSkipped) {
    hear("< frame 703 1.0 05 >");  // a frame before the client has joined
    join();
    for (const char* odd : {"< frame >", "< frame 703 >", "< frame 800 1.0 05 >", "< frame 703 1.0 0 >",
                            "< frame 703 1.0 xy >", "< frame 703 1.0 010203040506070809 >", "< stat 1 2 3 4 >", "<>",
                            "garbage", "< echo >", "< frame -1 1.0 05 >"}) {
        EXPECT_EQ(hear(odd), "") << odd;
    }
    EXPECT_THAT(frames, IsEmpty());
    hear("<" + std::string(1000000, 'x'));
    EXPECT_LE(client.held(), SocketcandClient::longest_command);
    hear("< frame 703 1.0 05 >");
    hear("< frame 703 1.0 05 >");
    EXPECT_EQ(frames.back(), "703#05");
}

TEST_F(SocketcandClientText, FramesAreWrittenAsServersReadThem) {
    EXPECT_FALSE(client.may_send());
    join();
    ASSERT_TRUE(client.may_send());
    client.send(parse_frame("603#4000100000000000", "test"));
    client.send(parse_frame("080#", "test"));
    client.send(parse_frame("1FFFFFFF#A5", "test"));
    EXPECT_EQ(client.output(), "< send 603 8 40 00 10 00 00 00 00 00 >< send 080 0 >< send 1FFFFFFF 1 A5 >");
    while (client.may_send()) {
        client.send(parse_frame("080#", "test"));
    }
    EXPECT_LT(client.output().size(), SocketcandClient::output_limit + 100);
}

TEST_F(SocketcandClientText, RefusalTextOfTheServerIsKept) {
    EXPECT_EQ(hear("< hi >< error 32 clients have joined, which is the most >"), "< open vcan0 >");
    EXPECT_TRUE(client.is_refused());
    EXPECT_EQ(client.complaint(), "32 clients have joined, which is the most");
}

TEST(SocketcandPlace, MissingHostPortOrBusOfAnAddressGetsItsDefault) {
    const SocketcandPlace usual = parse_socketcand_place("");
    EXPECT_EQ(usual.host, "127.0.0.1");
    EXPECT_EQ(usual.port, 29536);
    EXPECT_EQ(usual.bus, "can0");
    const SocketcandPlace whole = parse_socketcand_place("gateway:1234/vcan1");
    EXPECT_EQ(whole.host, "gateway");
    EXPECT_EQ(whole.port, 1234);
    EXPECT_EQ(whole.bus, "vcan1");
    EXPECT_EQ(parse_socketcand_place("[::1]/can1").host, "::1");
    EXPECT_EQ(parse_socketcand_place("/can1").bus, "can1");
}

TEST(SocketcandPlace, InvalidServerAddressIsRefused) {
    for (const char* wrong :
         {"127.0.0.1:x", "127.0.0.1:0", "127.0.0.1:65536", "127.0.0.1:1234/", "a:1/b c", "a:1/b >", "a:1/b/c"}) {
        EXPECT_THROW(parse_socketcand_place(wrong), InputError) << wrong;
    }
}

}  // namespace canproof::host::test
