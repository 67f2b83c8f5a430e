// SPDX-License-Identifier: Apache-2.0
// Attribution of an echoed frame to its sender by identifier, format, request, length and bytes; the oldest entry
// first.
#include "host/sim/bus/echo_matcher.hpp"

#include <gtest/gtest.h>

#include "host/sim/bus/candump.hpp"

namespace canproof::host::test {

namespace {

Frame frame(const char* text) {
    return parse_frame(text, "test");
}

}  // namespace

TEST(EchoMatcher, EqualFramesAreMatchedToTheirSendersInSendingOrder) {
    EchoMatcher<int> echoes;
    echoes.sent(frame("703#05"), 1);
    echoes.sent(frame("703#05"), 2);
    echoes.sent(frame("703#05"), 1);
    EXPECT_EQ(echoes.match(frame("703#05"), 0), 1);
    EXPECT_EQ(echoes.match(frame("703#05"), 0), 2);
    EXPECT_EQ(echoes.match(frame("703#05"), 0), 1);
    EXPECT_EQ(echoes.match(frame("703#05"), 0), 0);
}

TEST(EchoMatcher, FramesOfOneIdentifierMayArriveInAnotherOrder) {
    EchoMatcher<int> echoes;
    echoes.sent(frame("583#01"), 1);
    echoes.sent(frame("583#02"), 2);
    EXPECT_EQ(echoes.match(frame("583#02"), 0), 2);
    EXPECT_EQ(echoes.match(frame("583#03"), 0), 0);
    EXPECT_EQ(echoes.match(frame("583#01"), 0), 1);
}

TEST(EchoMatcher, EachFieldOfAFrameIsCompared) {
    for (const char* sent : {"703#7F00", "00000703#7F00", "703#R2", "00000703#R2"}) {
        EchoMatcher<int> echoes;
        echoes.sent(frame(sent), 1);
        for (const char* other : {"703#7F00", "00000703#7F00", "703#R2", "00000703#R2", "704#7F00", "703#7F",
                                  "703#7F0000", "703#7E00", "703#7F01", "703#R1", "00000703#R1"}) {
            if (std::string{other} != sent) {
                EXPECT_EQ(echoes.match(frame(other), 0), 0) << sent << " and " << other;
            }
        }
        EXPECT_EQ(echoes.match(frame(sent), 0), 1) << sent;
    }
}

TEST(EchoMatcher, BytesOfARemoteFrameAreNotCompared) {
    EchoMatcher<int> echoes;
    Frame request = frame("703#R2");
    request.data[0] = 0xAA;
    echoes.sent(request, 1);
    EXPECT_EQ(echoes.match(frame("703#R2"), 0), 1);
}

TEST(EchoMatcher, MatcherKeepsTheLast131072FramesOfAnIdentifier) {
    EchoMatcher<int> echoes;
    for (int i = 0; i <= 131072; ++i) {
        echoes.sent(frame("703#05"), i);
    }
    EXPECT_EQ(echoes.match(frame("703#05"), -1), 1);  // the oldest entry, 0, was removed
}

}  // namespace canproof::host::test
