// SPDX-License-Identifier: Apache-2.0
// Tests how files are read line by line. A read error must not be taken as the end of the file.
#include "host/base/reading.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "host/base/input_error.hpp"

namespace canproof::host {

TEST(Lines, LinesAreReadWithoutLineEndsAndByteOrderMark) {
    std::istringstream in{"\xEF\xBB\xBFone\r\n\ntwo"};
    LineReader lines{in, "file"};
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), "one");
    EXPECT_EQ(lines.where(), "file:1");
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), "");
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), "two");
    EXPECT_EQ(lines.where(), "file:3");
    EXPECT_FALSE(lines.next());
    EXPECT_FALSE(lines.next());
}

TEST(Lines, LongestLineIsReadAndALongerLineIsRefused) {
    const std::string longest(LineReader::longest_line, 'x');
    for (const char* end : {"", "\n"}) {
        std::istringstream in{longest + end};
        LineReader lines{in, "file"};
        ASSERT_TRUE(lines.next());
        EXPECT_EQ(lines.line(), longest);
        EXPECT_FALSE(lines.next());
    }
    std::istringstream in{longest + "x\n"};
    LineReader lines{in, "file"};
    EXPECT_THROW(lines.next(), InputError);
}

TEST(Lines, ReadErrorIsNotTreatedAsTheEndOfTheFile) {
    std::ifstream folder{"/", std::ios::binary};
    LineReader lines{folder, "/"};
    EXPECT_THROW(lines.next(), InputError);
}

}  // namespace canproof::host
