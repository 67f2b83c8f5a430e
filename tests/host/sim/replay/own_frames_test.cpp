// SPDX-License-Identifier: Apache-2.0
// Recognition of the frames of a log that the device has sent itself.
#include "host/sim/replay/own_frames.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host {

namespace {

Frame frame(const char* text) {
    return parse_frame(text, "test");
}

}  // namespace

TEST(OwnFrames, EachOwnFrameIsRecognisedOnce) {
    OwnFrames own;
    own.sent(frame("703#7F"), Instant{1000});
    own.sent(frame("703#7F"), Instant{2000});
    EXPECT_TRUE(own.match(frame("703#7F"), Instant{2500}));
    EXPECT_TRUE(own.match(frame("703#7F"), Instant{2500}));
    EXPECT_FALSE(own.match(frame("703#7F"), Instant{2500}));
}

TEST(OwnFrames, EachFieldOfAFrameIsCompared) {
    OwnFrames own;
    own.sent(frame("703#7F00"), Instant{});
    for (const char* other : {"704#7F00", "703#7F", "703#7F0000", "703#7E00", "703#R2", "00000703#7F00"}) {
        EXPECT_FALSE(own.match(frame(other), Instant{})) << other;
    }
    EXPECT_TRUE(own.match(frame("703#7F00"), Instant{}));
}

TEST(OwnFrames, FramesWithTheSameBytesAtOtherPositionsDoNotMatch) {
    for (const auto& [sent, other] : {std::pair{"123#8000", "123#0001"},
                                      {"123#0000000000000002", "123#0000000000000000"},
                                      {"123#100000", "123#000001"},
                                      {"123#0102", "123#0201"},
                                      {"123#0001", "123#0100"},
                                      {"123#FF01", "123#FF02"}}) {
        OwnFrames own;
        own.sent(frame(sent), Instant{});
        EXPECT_FALSE(own.match(frame(other), Instant{})) << sent;
        EXPECT_TRUE(own.match(frame(sent), Instant{})) << sent;
    }
}

TEST(OwnFrames, BytesOfARemoteFrameAreNotCompared) {
    OwnFrames own;
    Frame request = frame("123#R2");
    request.data[0] = 0xAA;
    own.sent(request, Instant{});
    EXPECT_TRUE(own.match(frame("123#R2"), Instant{}));
}

TEST(OwnFrames, ManyFramesThatDifferInOneFieldAreDistinguished) {
    std::vector<Frame> frames;
    for (std::uint32_t number = 0; number < 500; ++number) {
        Frame one = frame("100#0000000000000000");
        one.id = number;
        frames.push_back(one);
        one = frame("7FF#0000000000000000");
        one.data[number % 8U] = static_cast<std::uint8_t>(1U + number / 8U);
        frames.push_back(one);
    }
    OwnFrames own;
    for (std::size_t i = 0; i < frames.size(); i += 2U) {
        own.sent(frames[i], Instant{});
    }
    EXPECT_EQ(own.kept(), frames.size() / 2U);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(own.match(frames[i], Instant{}), i % 2U == 0U) << i;
    }
}

TEST(OwnFrames, OnlyFramesOfTheLastMinuteAreKept) {
    OwnFrames own;
    own.sent(frame("703#7F"), Instant{0});
    own.sent(frame("703#7F"), Instant{1000000});
    own.sent(frame("703#05"), Instant{2000000});
    EXPECT_TRUE(own.match(frame("703#05"), Instant{2000000}));
    EXPECT_EQ(own.kept(), 2U);
    own.sent(frame("080#"), Instant{61000000});  // 703#7F, sent at 1 s, is one minute old
    EXPECT_EQ(own.kept(), 3U);
    own.sent(frame("080#"), Instant{61000001});  // more than one minute; 703#05 is kept although it has been seen
    EXPECT_EQ(own.kept(), 2U);
    EXPECT_FALSE(own.match(frame("703#05"), Instant{62000001}));
    EXPECT_EQ(own.kept(), 1U);
    EXPECT_FALSE(own.match(frame("703#05"), Instant{121000002}));
    EXPECT_EQ(own.kept(), 0U);
}

TEST(OwnFrames, MatchRemovesOneFrameOfSeveralEqualOnes) {
    OwnFrames own;
    own.sent(frame("703#7F"), Instant{0});
    own.sent(frame("703#7F"), Instant{1000000});
    EXPECT_TRUE(own.match(frame("703#7F"), Instant{2000000}));
    EXPECT_TRUE(own.match(frame("703#7F"), Instant{2000000}));
    EXPECT_FALSE(own.match(frame("703#7F"), Instant{60000001}));  // the first frame is older than a minute
    own.sent(frame("703#7F"), Instant{60500000});
    EXPECT_TRUE(
        own.match(frame("703#7F"), Instant{61000001}));  // the second frame is too old as well, the third matches
    EXPECT_FALSE(own.match(frame("703#7F"), Instant{61000001}));
    own.sent(frame("703#7F"), Instant{130000000});
    EXPECT_TRUE(own.match(frame("703#7F"), Instant{130000000}));
}

TEST(OwnFrames, UnmatchedFramesAreRemovedAfterAMinute) {
    OwnFrames own;
    own.sent(frame("703#7F"), Instant{0});
    own.sent(frame("703#7F"), Instant{1000000});
    own.sent(frame("703#05"), Instant{1000000});
    // matches the first frame, which is almost one minute old
    EXPECT_TRUE(own.match(frame("703#7F"), Instant{60000000}));
    // matches the second frame, because the first has matched already
    EXPECT_TRUE(own.match(frame("703#7F"), Instant{60000001}));
    EXPECT_FALSE(own.match(frame("703#05"), Instant{61000001}));  // the frame is 60.000001 s old, more than one minute
}

}  // namespace canproof::host
