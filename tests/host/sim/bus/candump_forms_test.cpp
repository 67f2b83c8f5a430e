// SPDX-License-Identifier: Apache-2.0
// The text form of candump, part by part: accepted lines, refused lines, and the meaning of a line.
#include <gtest/gtest.h>

#include <sstream>

#include "host/base/input_error.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host::test {

namespace {

Frame frame(const std::string& text) {
    return parse_frame(text, "test");
}

LoggedFrame line(const std::string& text) {
    return parse_candump_line(text, "log:1");
}

std::string refusal(const std::string& text) {
    try {
        line(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "taken";
}

}  // namespace

TEST(CandumpFrame, IdentifierOfThreeDigitsHas11BitsAndOneOfEightHas29) {
    EXPECT_EQ(frame("7FF#").id, 0x7FFU);
    EXPECT_FALSE(frame("7FF#").extended);
    EXPECT_EQ(frame("000007FF#").id, 0x7FFU);
    EXPECT_TRUE(frame("000007FF#").extended);
    EXPECT_EQ(frame("1fffffff#").id, 0x1FFFFFFFU);
    for (const char* wrong :
         {"800#", "20000000#", "7F#", "07FF#", "7FFFFFF#", "000007FFF#", "#00", "7FF", "7G0#", "", "12345678"}) {
        EXPECT_THROW(frame(wrong), InputError) << wrong;
    }
}

TEST(CandumpFrame, BytesAreReadInTheirOrder) {
    const Frame eight = frame("123#01aBff0045670089");
    EXPECT_EQ(eight.length, 8U);
    const std::array<std::uint8_t, 8> bytes{0x01, 0xAB, 0xFF, 0x00, 0x45, 0x67, 0x00, 0x89};
    EXPECT_EQ(eight.data, bytes);
    EXPECT_FALSE(eight.remote);
    EXPECT_EQ(frame("123#").length, 0U);
    for (const char* wrong : {"123#1", "123#123", "123#0G", "123#010203040506070809", "123# 01", "123#-1"}) {
        EXPECT_THROW(frame(wrong), InputError) << wrong;
    }
}

TEST(CandumpFrame, RemoteFrameHasALengthAndNoBytes) {
    EXPECT_TRUE(frame("123#R").remote);
    EXPECT_EQ(frame("123#R").length, 0U);
    EXPECT_EQ(frame("123#r0").length, 0U);
    EXPECT_EQ(frame("123#R8").length, 8U);
    EXPECT_EQ(frame("123#R8").data, (std::array<std::uint8_t, 8>{}));
    for (const char* wrong : {"123#R9", "123#R/", "123#R:", "123#RR", "123#R12", "123#R01"}) {
        EXPECT_THROW(frame(wrong), InputError) << wrong;
    }
}

TEST(CandumpFrame, RawLengthCodeMayFollowOnlyEightBytes) {
    EXPECT_EQ(frame("123#0102030405060708_9").length, 8U);
    EXPECT_EQ(frame("123#0102030405060708_f").length, 8U);
    EXPECT_EQ(frame("123#r8_A").length, 8U);
    EXPECT_TRUE(frame("123#r8_A").remote);
    for (const char* wrong : {"123#01020304050607_9", "123#_9", "123#R7_9", "123#R_9", "123#0102030405060708_",
                              "123#0102030405060708_99", "123#0102030405060708_G", "123#0102030405060708_0"}) {
        EXPECT_THROW(frame(wrong), InputError) << wrong;
    }
}

TEST(CandumpFrame, FrameIsWrittenAsItIsRead) {
    for (const char* text :
         {"000#", "7FF#FF", "00000000#", "1FFFFFFF#R", "123#R1", "123#R8", "0000A5C3#0123456789ABCDEF"}) {
        EXPECT_EQ(format_frame(frame(text)), text);
    }
}

TEST(CandumpLine, LineConsistsOfTimeInterfaceFrameAndDirectionMark) {
    const LoggedFrame plain = line("(12.000345) vcan3 703#05");
    EXPECT_EQ(plain.time, Instant{12000345});
    EXPECT_EQ(plain.interface, "vcan3");
    EXPECT_EQ(plain.frame.id, 0x703U);
    EXPECT_EQ(plain.mark, LogMark::none);
    EXPECT_FALSE(plain.error);
    EXPECT_FALSE(plain.coded);
    EXPECT_EQ(line("(1.0) can0 703#05 T").mark, LogMark::transmitted);
    EXPECT_EQ(line("(1.0) can0 703#05 R").mark, LogMark::received);
    EXPECT_TRUE(line("(1.0) can0 703#0102030405060708_9").coded);
    EXPECT_EQ(line("  (1.0)\tcan0   703#05  ").frame.length, 1U);
}

TEST(CandumpLine, AsciiWhiteSpaceSeparatesWordsAndOtherControlCharactersDoNot) {
    for (const char blank : {' ', '\t', '\n', '\v', '\f', '\r'}) {
        EXPECT_EQ(line(std::string{"(1.0)"} + blank + "can0 703#05").interface, "can0") << static_cast<int>(blank);
    }
    for (const char other : {'\b', '\x0E', '\x1F'}) {
        EXPECT_NE(refusal(std::string{"(1.0) can0 703#05"} + other), "taken") << static_cast<int>(other);
    }
}

TEST(CandumpLine, RefusalStatesWhichFieldIsWrong) {
    EXPECT_NE(refusal("(1.0) can0").find("does not consist of a time, an interface and a frame"), std::string::npos);
    EXPECT_NE(refusal("(1.0) can0 703#05 X").find("does not consist of a time, an interface and a frame"),
              std::string::npos);
    for (const char* text : {"1.0) can0 703#05", "(1.0 can0 703#05", "() can0 703#05", "( can0 703#05"}) {
        EXPECT_NE(refusal(text).find("is not in round brackets"), std::string::npos) << text;
    }
    EXPECT_NE(refusal("(1,0) can0 703#05").find("`1,0` is no time"), std::string::npos);
    EXPECT_EQ(line("(1) can0 703#05").time, Instant{1000000});  // the shortest form of a time
    EXPECT_NE(refusal("(1.0) can0 703#GG").find("data `GG` is no sequence of zero to eight bytes"), std::string::npos);
    EXPECT_NE(refusal("(1.0) can0 900#").find("identifier 900 is too large"), std::string::npos);
    EXPECT_NE(refusal("(1.0) can0 703#R9").find("`9` is no length from 0 to 8 after R"), std::string::npos);
    EXPECT_NE(refusal("(1.0) can0 703#01_9").find("`_9` is no length code"), std::string::npos);
    EXPECT_NE(refusal("(1.0) can0 70#01").find("`70#01` has no identifier of three or eight"), std::string::npos);
}

TEST(CandumpLine, IdentifierOfAnErrorFrameHasBit29AndNoHigherBit) {
    const LoggedFrame error = line("(1.0) can0 20000044#0010000000000000");
    EXPECT_TRUE(error.error);
    EXPECT_EQ(error.frame.length, 8U);
    EXPECT_EQ(error.frame.data[1], 0x10);
    EXPECT_TRUE(line("(1.0) can0 3FFFFFFF#").error);
    EXPECT_FALSE(line("(1.0) can0 1FFFFFFF#").error);
    for (const char* wrong :
         {"(1.0) can0 60000004#", "(1.0) can0 0020000004#00", "(1.0) can0 GGGGGGGG#", "(1.0) can0 A0000004#",
          "(1.0) can0 20000004", "(1.0) can0 2000000G#", "(1.0) can0 20000004#0G", "(1.0) can0 E0000000#"}) {
        EXPECT_NE(refusal(wrong), "taken") << wrong;
    }
}

TEST(CandumpReader, EmptyLinesAndErrorFramesAreSkippedAndErrorFramesCounted) {
    std::istringstream in{"\n \t\n(1.0) can0 20000004#\n(1.0) can0 080#\n(1.0) can0 20000004#\n(1.0) can0 0102030#\n"};
    CandumpReader reader{in, "bus.log"};
    LoggedFrame one;
    ASSERT_TRUE(reader.next(one));
    EXPECT_EQ(one.frame.id, 0x80U);
    EXPECT_EQ(reader.counts().error_frames, 1U);
    EXPECT_EQ(reader.counts().coded_lengths, 0U);
    EXPECT_THROW(reader.next(one), InputError);
    EXPECT_EQ(reader.counts().error_frames, 2U);
}

TEST(CandumpReader, FrameWithATimeBeforeAnErrorFrameIsRefused) {
    std::istringstream in{"(2.0) can0 20000004#\n(1.0) can0 080#\n"};
    EXPECT_THROW(read_candump_log(in, "log"), InputError);
    std::istringstream equal{"(2.0) can0 080#\n(2.0) can0 081#\n"};
    EXPECT_EQ(read_candump_log(equal, "log").size(), 2U);
}

}  // namespace canproof::host::test
