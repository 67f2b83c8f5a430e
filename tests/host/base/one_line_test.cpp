// SPDX-License-Identifier: Apache-2.0
#include "host/base/one_line.hpp"

#include <gtest/gtest.h>

namespace canproof::host::test {

TEST(OneLine, RunsOfBlanksBecomeOneSpace) {
    EXPECT_EQ(one_line(" a\n\t b \r\n"), "a b");
    EXPECT_EQ(one_line(" \n"), "");
}

TEST(Brief, TextOf90BytesIsUnchanged) {
    EXPECT_EQ(brief(std::string(90, 'a')), std::string(90, 'a'));
}

TEST(Brief, LongTextEndsAfterAWord) {
    EXPECT_EQ(brief(std::string(80, 'a') + " " + std::string(20, 'b')), std::string(80, 'a') + " …");
}

TEST(Brief, LongFirstWordIsCut) {
    EXPECT_EQ(brief(std::string(91, 'a')), std::string(90, 'a') + " …");
    // Ω has two bytes: the 90th byte is the first of one, so 89 bytes are whole characters.
    std::string ohms = "a";
    for (int i = 0; i < 50; ++i) {
        ohms += "Ω";
    }
    EXPECT_EQ(brief(ohms), ohms.substr(0, 89) + " …");
}

}  // namespace canproof::host::test
