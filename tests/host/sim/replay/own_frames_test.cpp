// Which frames of a log a device has sent itself.
#include "host/sim/replay/own_frames.hpp"

#include <gtest/gtest.h>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host {

namespace {

Frame frame(const char* text) {
    return parse_frame(text, "test");
}

}  // namespace

TEST(OwnFrames, EachIsRecognisedOnce) {
    OwnFrames own;
    own.sent(frame("703#7F"), Instant{1000});
    own.sent(frame("703#7F"), Instant{2000});
    EXPECT_TRUE(own.match(frame("703#7F"), Instant{2500}));
    EXPECT_TRUE(own.match(frame("703#7F"), Instant{2500}));
    EXPECT_FALSE(own.match(frame("703#7F"), Instant{2500}));
}

TEST(OwnFrames, EveryPartOfAFrameCounts) {
    OwnFrames own;
    own.sent(frame("703#7F00"), Instant{});
    for (const char* other : {"704#7F00", "703#7F", "703#7F0000", "703#7E00", "703#R2", "00000703#7F00"}) {
        EXPECT_FALSE(own.match(frame(other), Instant{})) << other;
    }
    EXPECT_TRUE(own.match(frame("703#7F00"), Instant{}));
}

TEST(OwnFrames, WhatDoesNotComeWithinAMinuteIsForgotten) {
    OwnFrames own;
    own.sent(frame("703#7F"), Instant{0});
    own.sent(frame("703#7F"), Instant{1000000});
    own.sent(frame("703#05"), Instant{1000000});
    EXPECT_TRUE(own.match(frame("703#7F"), Instant{60000000}));   // the first, one minute old
    EXPECT_TRUE(own.match(frame("703#7F"), Instant{60000001}));   // the second: the first was seen
    EXPECT_FALSE(own.match(frame("703#05"), Instant{61000001}));  // a minute and one microsecond old
}

}  // namespace canproof::host
