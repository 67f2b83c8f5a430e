// SPDX-License-Identifier: Apache-2.0
// Marks (length and hash) of passages of a manual: the same words have the same mark, whatever their layout; an invalid
// mark is refused.
#include "host/register/mark.hpp"

#include <gtest/gtest.h>

namespace canproof::host::test {

// SHA-256 of "abc" as FIPS 180-4 prints it begins with ba7816bf 8f01.
TEST(PassageMark, MarkOfAPassageIsItsLengthAndTheFirstDigitsOfItsHash) {
    EXPECT_EQ(mark_of("abc").text(), "3:ba7816bf8f01");
}

TEST(PassageMark, MarkOfAPassageIgnoresCaseLayoutAndPunctuation) {
    EXPECT_EQ(mark_of("A-b,\n  **C**.").text(), "3:ba7816bf8f01");
    EXPECT_EQ(mark_of("a\xC2\xB5"
                      "bc")
                  .text(),
              "3:ba7816bf8f01")
        << "the micro sign is no ASCII letter";
    EXPECT_EQ(reduced("Object 1000_h: Device Type"), "object1000hdevicetype");
}

TEST(PassageMark, MarkOfAPassageIsReadAsWritten) {
    const auto mark = read_mark("132:3f9a0c1b2d4e");
    ASSERT_TRUE(mark.has_value());
    EXPECT_EQ(mark->length, 132U);
    EXPECT_EQ(mark->hash, "3f9a0c1b2d4e");
    EXPECT_EQ(mark->text(), "132:3f9a0c1b2d4e");
}

TEST(PassageMark, MalformedMarkOfAPassageIsRefused) {
    for (const char* text : {"", ":", "132", "132:", ":3f9a0c1b2d4e", "132:3f9a0c1b2d4", "132:3f9a0c1b2d4e5",
                             "132:3F9A0C1B2D4E", "132:3f9a0c1b2d4g", "0:3f9a0c1b2d4e", "013:3f9a0c1b2d4e",
                             "-1:3f9a0c1b2d4e", "100000:3f9a0c1b2d4e", "1 :3f9a0c1b2d4e", "132:3f9a0c1b2d4e "}) {
        EXPECT_FALSE(read_mark(text).has_value()) << text;
    }
}

}  // namespace canproof::host::test
