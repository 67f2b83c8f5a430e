// SPDX-License-Identifier: Apache-2.0
// The text of a frame: what distinguishes two frames, and which characters are hexadecimal digits.
#include "host/sim/bus/frame_text.hpp"

#include <gtest/gtest.h>

namespace canproof::host::test {

namespace {

Frame frame_in(const std::string& text) {
    FrameText read;
    EXPECT_EQ(read_frame_text(text, read), std::nullopt) << text;
    return read.frame;
}

}  // namespace

TEST(FrameText, FramesAreAlikeOnlyWhenEachFieldIsTheSame) {
    const Frame frame = frame_in("123#1122");
    EXPECT_TRUE(are_alike(frame, frame_in("123#1122")));
    // identifier, format, remote, length, data
    for (const char* const other : {"124#1122", "00000123#1122", "123#R2", "123#112200", "123#1123"}) {
        EXPECT_FALSE(are_alike(frame, frame_in(other))) << other;
    }
    EXPECT_FALSE(are_alike(frame_in("123#0000"), frame_in("123#R2"))) << "a remote frame has no data";
}

TEST(FrameText, CharactersNextToTheHexadecimalDigitsInAsciiAreRefused) {
    EXPECT_EQ(frame_in("0f9#aF").data[0], 0xAFU);
    for (const char beside : {'/', ':', '@', 'G', '`', 'g'}) {
        FrameText read;
        EXPECT_NE(read_frame_text(std::string{"123#1"} + beside, read), std::nullopt) << beside;
        EXPECT_NE(read_frame_text(std::string{"12"} + beside + "#11", read), std::nullopt) << beside;
    }
}

}  // namespace canproof::host::test
