// SPDX-License-Identifier: Apache-2.0
// Limits on the commands of one socketcand client, and the text functions that server and client share.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/sim/bus/candump.hpp"
#include "host/sim/bus/socketcand_client.hpp"
#include "host/sim/bus/socketcand_session.hpp"
#include "host/sim/bus/socketcand_text.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SocketcandLimits : public testing::Test {
  protected:
    std::string say(const std::string& text, Instant now = Instant{}) {
        session.receive(text, now);
        return heard();
    }
    std::string heard() {
        std::string text = session.output();
        session.sent(text.size());
        return text;
    }
    void arrives(const std::string& frame) { session.gateway().receive(parse_frame(frame, "test"), Instant{}); }

    SocketcandSession session{"client", 0};
};

constexpr const char* refused_subscription =
    "< error subscribe takes seconds, microseconds and an identifier, for up to 256 identifiers; unsubscribe takes an "
    "identifier >";

}  // namespace

TEST(SocketcandText, NumbersHaveOneToEightHexadecimalDigits) {
    EXPECT_EQ(hex_number("0", 0), 0U);
    EXPECT_EQ(hex_number("ffffffff", 0xFFFFFFFFU), 0xFFFFFFFFU);
    EXPECT_EQ(hex_number("7FF", 0x7FF), 0x7FFU);
    EXPECT_EQ(hex_number("800", 0x7FF), std::nullopt);
    for (const char* wrong : {"", "000000001", "g", "-1", "0x1", " 1"}) {
        EXPECT_EQ(hex_number(wrong, 0xFFFFFFFFU), std::nullopt) << wrong;
    }
}

TEST(SocketcandText, IdentifierOfEightDigitsHas29Bits) {
    Frame frame{};
    EXPECT_TRUE(read_identifier("7FF", frame));
    EXPECT_FALSE(frame.extended);
    EXPECT_EQ(frame.id, 0x7FFU);
    EXPECT_TRUE(read_identifier("1FFFFFFF", frame));
    EXPECT_TRUE(frame.extended);
    EXPECT_EQ(frame.id, 0x1FFFFFFFU);
    EXPECT_TRUE(read_identifier("0", frame));
    EXPECT_FALSE(frame.extended);
    for (const char* wrong : {"800", "20000000", "0000800", "xyz", ""}) {
        EXPECT_FALSE(read_identifier(wrong, frame)) << wrong;
    }
    frame.id = 0x12;
    frame.extended = false;
    EXPECT_EQ(format_identifier(frame), "012");
    frame.extended = true;
    EXPECT_EQ(format_identifier(frame), "00000012");
}

TEST(SocketcandText, UpToEightBytesOfTwoDigitsEachAreRead) {
    Frame frame{};
    EXPECT_TRUE(read_bytes("0102a5ff0506b7c8", frame));
    EXPECT_EQ(frame.length, 8U);
    EXPECT_EQ(frame.data, (std::array<std::uint8_t, 8>{0x01, 0x02, 0xA5, 0xFF, 0x05, 0x06, 0xB7, 0xC8}));
    EXPECT_TRUE(read_bytes("", frame));
    EXPECT_EQ(frame.length, 0U);
    for (const char* wrong : {"0", "012", "010203040506070809", "0g"}) {
        EXPECT_FALSE(read_bytes(wrong, frame)) << wrong;
    }
}

TEST(SocketcandText, CommandIsReadBetweenItsBrackets) {
    bool too_long = false;
    std::string input = "x< a ><b><";
    EXPECT_EQ(take_command(input, 10, too_long), " a ");
    EXPECT_EQ(input, "<b><");
    EXPECT_EQ(take_command(input, 10, too_long), "b");
    EXPECT_EQ(take_command(input, 10, too_long), std::nullopt);
    EXPECT_FALSE(too_long);
    EXPECT_EQ(input, "<");
    input = "nothing";
    EXPECT_EQ(take_command(input, 10, too_long), std::nullopt);
    EXPECT_EQ(input, "");
}

TEST(SocketcandText, CommandUpToTheLimitIsRead_AndALongerCommandIsSkipped) {
    bool too_long = false;
    std::string input = "<" + std::string(9, 'a') + ">";  // ten characters, the limit, and ">", which does not count
    EXPECT_EQ(take_command(input, 10, too_long), std::string(9, 'a'));
    EXPECT_FALSE(too_long);
    input = "<" + std::string(10, 'a') + ">< b >";
    EXPECT_EQ(take_command(input, 10, too_long), std::nullopt);
    EXPECT_TRUE(too_long);
    EXPECT_EQ(take_command(input, 10, too_long), " b ");  // the next command is read
    EXPECT_FALSE(too_long);
    input = "<" + std::string(9, 'a');  // a text of the largest length, without a closing bracket
    EXPECT_EQ(take_command(input, 10, too_long), std::nullopt);
    EXPECT_FALSE(too_long);
    input += "a";
    EXPECT_EQ(take_command(input, 10, too_long), std::nullopt);
    EXPECT_TRUE(too_long);
    EXPECT_EQ(input, "a");
}

TEST_F(SocketcandLimits, TooLongCommandIsReportedAndTheNextIsExecuted) {
    say("");
    EXPECT_EQ(say("<" + std::string(256, 'x') + ">< echo >"), "< error command too long >< echo >");
    EXPECT_EQ(say("<" + std::string(255, 'x') + ">"), "< error no bus is open >");
}

TEST_F(SocketcandLimits, OpenWithoutABusIsRefused_AndTheBusStaysOpen) {
    EXPECT_EQ(say(""), "< hi >");
    EXPECT_EQ(say("< open vcan7 >"), "< ok >");
    EXPECT_EQ(say("< open >"), "< error could not open bus >");
    EXPECT_TRUE(session.has_joined());
    EXPECT_EQ(say("< rawmode >"), "< ok >");
    EXPECT_EQ(say("< open >"), "< error could not open bus >");
    arrives("123#");
    EXPECT_EQ(heard(), "< frame 123 0.000000  >");  // the client is still in raw mode
}

TEST_F(SocketcandLimits, SubscriptionsApplyInBcmModeOnlyAndToTheirFrameFormat) {
    say("< open can0 >< subscribe 0 0 123 >< subscribe 1 5 00000456 >");
    arrives("00000123#");
    arrives("456#");
    EXPECT_EQ(heard(), "");
    arrives("00000456#05");
    EXPECT_EQ(heard(), "< frame 00000456 0.000000 05 >");
    say("< bcmmode >");  // entering the mode again clears the subscriptions
    arrives("123#");
    EXPECT_EQ(heard(), "");
    EXPECT_EQ(say("< rawmode >< unsubscribe 123 >"), "< ok >< error unknown command >");
    arrives("123#");
    EXPECT_EQ(heard(), "< frame 123 0.000000  >");
    say("< controlmode >");
    arrives("123#");
    EXPECT_EQ(heard(), "");
}

TEST_F(SocketcandLimits, SubscribeNeedsThreeArgumentsAndUnsubscribeOne) {
    say("< open can0 >");
    for (const char* wrong : {"< subscribe 123 >", "< subscribe 0 0 0 123 >", "< subscribe 0 0 800 >", "< subscribe >",
                              "< unsubscribe >", "< unsubscribe 0 0 123 >", "< unsubscribe 800 >"}) {
        EXPECT_EQ(say(wrong), refused_subscription) << wrong;
    }
}

TEST_F(SocketcandLimits, UpTo256SubscriptionsAreKept_AndUnsubscribeAllowsANewOne) {
    say("< open can0 >");
    for (unsigned id = 0; id < 256; ++id) {
        EXPECT_EQ(say(fmt::format("< subscribe 0 0 {:03X} >", id)), "") << id;
    }
    EXPECT_EQ(say("< subscribe 0 0 700 >"), refused_subscription);
    EXPECT_EQ(say("< unsubscribe 701 >"), "");  // an identifier without a subscription
    EXPECT_EQ(say("< subscribe 0 0 700 >"), refused_subscription);
    EXPECT_EQ(say("< unsubscribe 0FF >< subscribe 0 0 700 >"), "");
    arrives("0FF#");
    EXPECT_EQ(heard(), "");
    arrives("700#");
    EXPECT_EQ(heard(), "< frame 700 0.000000  >");
}

TEST_F(SocketcandLimits, StatisticsPeriodIsUpToAnHour) {
    say("< open can0 >");
    EXPECT_EQ(say("< statistics 3600000 >"), "");
    EXPECT_EQ(session.next_deadline(), Instant{3600000000U});
    EXPECT_EQ(say("< statistics 00000500 >"), "");
    EXPECT_EQ(session.next_deadline(), Instant{500000});
    EXPECT_EQ(say("< statistics 1 >"), "");
    EXPECT_EQ(session.next_deadline(), Instant{1000});
    for (const char* wrong : {"< statistics 3600001 >", "< statistics >", "< statistics 1 2 >", "< statistics -1 >",
                              "< statistics 100000000 >", "< statistics 000000001 >"}) {
        EXPECT_EQ(say(wrong), "< error statistics takes a period in milliseconds, 0 for none >") << wrong;
    }
    EXPECT_EQ(session.next_deadline(), Instant{1000});
}

TEST_F(SocketcandLimits, ClientIsDroppedWhenItsOutputWouldExceedTheLimit) {
    say("< open can0 >< rawmode >");
    // `< frame 123 0.000000  >` has 23 characters: 262144 = 11397 x 23 + 13
    for (int i = 0; i < 11397; ++i) {
        arrives("123#");
    }
    EXPECT_EQ(session.output().size(), 262131U);
    EXPECT_FALSE(session.is_dropped());
    session.receive("< error", Instant{});
    session.receive(" >", Instant{});  // `< error unknown command >` has 25 characters
    EXPECT_TRUE(session.is_dropped());
    EXPECT_EQ(session.output().size(), 262131U);
    EXPECT_FALSE(session.wants_input());
    session.receive("< send 123 0 >", Instant{});
    EXPECT_EQ(session.gateway().next_frame(), nullptr);
    session.sent(100000);
    arrives("123#");
    EXPECT_EQ(session.output().size(), 162131U);  // the client receives nothing more
}

TEST_F(SocketcandLimits, UnsentTextForAClientMayFillTheLimitToItsLastCharacter) {
    say("< open can0 >< rawmode >");
    for (int i = 0; i < 11396; ++i) {
        arrives("123#");  // 23 characters each
    }
    arrives("00000123#01020304");  // 36 characters: five more for the identifier, eight for the bytes
    EXPECT_EQ(session.output().size(), 262144U);
    EXPECT_FALSE(session.is_dropped());
    session.sent(22);
    arrives("123#");
    EXPECT_TRUE(session.is_dropped());
    EXPECT_EQ(session.output().size(), 262122U);
}

TEST_F(SocketcandLimits, UnprocessedTextOfAClientIsKeptUpToALimit) {
    say("< open can0 >");
    std::string flood;
    for (int i = 0; i < 32; ++i) {
        flood += "< send 123 0 >";  // as many frames as the gateway holds
    }
    session.receive(flood, Instant{});
    EXPECT_TRUE(session.gateway().is_full());
    session.receive(std::string(4095, ' '), Instant{});
    EXPECT_TRUE(session.wants_input());
    session.receive(" ", Instant{});
    EXPECT_FALSE(session.wants_input());
    session.send_away("too many");
    EXPECT_TRUE(session.wants_input());  // the session reads further text and ignores it
}

TEST_F(SocketcandLimits, SendAcceptsBytesWithOrWithoutBlanks) {
    say("< open can0 >");
    const auto frame_of = [this](const std::string& words) {
        const std::string said = say("< send " + words + " >");
        if (session.gateway().next_frame() == nullptr) {
            return said;
        }
        const std::string text = format_frame(*session.gateway().next_frame());
        session.gateway().take_frame();
        return text;
    };
    EXPECT_EQ(frame_of("123 2 01 02"), "123#0102");
    EXPECT_EQ(frame_of("123 2 1 2"), "123#0102");
    EXPECT_EQ(frame_of("123 2 0102"), "123#0102");
    EXPECT_EQ(frame_of("123 1 5"), "123#05");
    EXPECT_EQ(frame_of("123 0"), "123#");
    EXPECT_EQ(frame_of("00000123 1 5"), "00000123#05");
    for (const char* wrong : {"123 2 01", "123 2 010", "123 2 010203", "123 1 0102", "123 3 0102 03", "123 2 01 02 03",
                              "123 2 001 02", "123 3 001 002", "123 0 1", "123 9", "123 x 01"}) {
        EXPECT_THAT(frame_of(wrong), HasSubstr("< error send takes")) << wrong;
    }
}

TEST(SocketcandClientLimits, ClientWaitsWhileItsUnsentTextIsAtTheLimit) {
    SocketcandClient client{"can0", [](const Frame&) {}};
    client.take("< hi >< ok >< ok >");
    client.sent(client.output().size());
    // `< send 080 0 >` has 14 characters, `< send 080 1 05 >` has 17: 1163 × 14 + 6 × 17 = 16384
    for (int i = 0; i < 1163; ++i) {
        client.send(parse_frame("080#", "test"));
    }
    for (int i = 0; i < 6; ++i) {
        EXPECT_TRUE(client.may_send());
        client.send(parse_frame("080#05", "test"));
    }
    EXPECT_EQ(client.output().size(), SocketcandClient::output_limit);
    EXPECT_FALSE(client.may_send());
    client.sent(1);
    EXPECT_TRUE(client.may_send());
    EXPECT_EQ(client.output().front(), ' ');  // the first character was removed
}

TEST(SocketcandClientLimits, LatestServerErrorIsKept_AndCountsAsARefusalOnlyBeforeJoining) {
    SocketcandClient client{"can0", [](const Frame&) {}};
    EXPECT_FALSE(client.is_refused());
    client.take("< hi >< error >");
    EXPECT_EQ(client.complaint(), "error");
    EXPECT_TRUE(client.is_refused());
    client.take("< error   two  words   >");
    EXPECT_EQ(client.complaint(), "two  words");
    client.take("< ok >< ok >");
    EXPECT_TRUE(client.has_joined());
    EXPECT_FALSE(client.is_refused());
}

TEST(SocketcandClientLimits, ServerMaySendARefusalInsteadOfAGreeting) {
    SocketcandClient client{"can0", [](const Frame&) {}};
    client.take("< error no room >");
    EXPECT_TRUE(client.is_refused());
    EXPECT_EQ(client.complaint(), "no room");
}

TEST(SocketcandClientLimits, ServerAnswersOutOfOrderAreIgnored) {
    SocketcandClient client{"can0", [](const Frame&) {}};
    client.take("< ok >< ok >");
    EXPECT_EQ(client.output(), "");
    client.take("< hi >");
    client.take("< hi >");
    EXPECT_EQ(client.output(), "< open can0 >");
    client.take("< ok >< ok >< ok >");
    EXPECT_EQ(client.output(), "< open can0 >< rawmode >");
    EXPECT_TRUE(client.has_joined());
}

}  // namespace canproof::host::test
