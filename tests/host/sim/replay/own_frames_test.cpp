// SPDX-License-Identifier: Apache-2.0
// Recognition of the frames of a log that the device has sent itself.
#include "host/sim/replay/own_frames.hpp"

#include <gtest/gtest.h>

#include <utility>

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

TEST(OwnFrames, FrameBytesAreComparedAtTheirPosition) {
    for (const auto& [sent, other] : {std::pair{"123#8000", "123#0001"},
                                      {"123#0000000000000002", "123#0000000000000000"},
                                      {"123#100000", "123#000001"},
                                      {"123#0102", "123#0201"}}) {
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

TEST(OwnFrames, DifferentFramesWithTheSameHashAreDistinguished) {
    // The hash is (data × S) xor (head × S / 2), where head = identifier × 2^32 + length and S is odd. Two frames with
    // different identifiers have the same hash if their (data × S) differ as their heads do. So data = difference / S
    // modulo 2^64.
    constexpr std::uint64_t spread = 0x9E3779B97F4A7C15U;
    std::uint64_t inverse = spread;
    for (int i = 0; i < 6; ++i) {
        inverse *= 2U - spread * inverse;  // each step doubles the number of correct bits
    }
    const auto head = [](std::uint64_t id) { return ((id << 32U) | 8U) * spread >> 1U; };
    std::uint64_t data = (head(0x100) ^ head(0x101)) * inverse;
    Frame other = frame("101#0000000000000000");
    for (std::uint8_t& byte : other.data) {
        byte = static_cast<std::uint8_t>(data & 0xFFU);
        data >>= 8U;
    }
    OwnFrames own;
    own.sent(frame("100#0000000000000000"), Instant{});
    EXPECT_FALSE(own.match(other, Instant{}));
    EXPECT_TRUE(own.match(frame("100#0000000000000000"), Instant{}));
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
