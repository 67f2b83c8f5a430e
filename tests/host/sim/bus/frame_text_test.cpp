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
    for (const char* const same : {"123#1122", "00000123#1122", "123#R2"}) {
        EXPECT_TRUE(are_alike(frame_in(same), frame_in(same))) << same;
    }
    // fields of the frame: identifier, format, remote, length, data
    for (const char* const other : {"124#1122", "00000123#1122", "123#R2", "123#112200", "123#1123"}) {
        EXPECT_FALSE(are_alike(frame, frame_in(other))) << other;
    }
    EXPECT_FALSE(are_alike(frame_in("123#0000"), frame_in("123#R2"))) << "a remote frame has no data";
}

TEST(FrameText, CharactersNextToTheHexadecimalDigitsInAsciiAreRefused) {
    EXPECT_EQ(frame_in("0f9#aF").data[0], 0xAFU);
    for (const char beside : {'/', ':', '@', 'G', '`', 'g', 'h', '~'}) {
        FrameText read;
        EXPECT_NE(read_frame_text(std::string{"123#1"} + beside, read), std::nullopt) << beside;
        EXPECT_NE(read_frame_text(std::string{"12"} + beside + "#11", read), std::nullopt) << beside;
    }
}

TEST(FrameText, InvalidDataByteIsRefusedEvenWhenAValidByteFollows) {
    FrameText read;
    for (const char* const wrong : {"123#GG11", "123#0G11", "123#110G22"}) {
        EXPECT_NE(read_frame_text(wrong, read), std::nullopt) << wrong;
    }
}

TEST(FrameText, NewTextReplacesEveryFieldOfThePreviousText) {
    FrameText read;
    ASSERT_EQ(read_frame_text("00000123#R2", read), std::nullopt);
    ASSERT_EQ(read_frame_text("124#11", read), std::nullopt);
    EXPECT_TRUE(are_alike(read.frame, frame_in("124#11")));
    ASSERT_EQ(read_frame_text("124#R2", read), std::nullopt);
    ASSERT_EQ(read_logged_frame("20000004#00", read), std::nullopt);
    EXPECT_FALSE(read.frame.remote);
    ASSERT_TRUE(read.error);
    ASSERT_EQ(read_logged_frame("124#11", read), std::nullopt);
    EXPECT_FALSE(read.error);
}

}  // namespace canproof::host::test
