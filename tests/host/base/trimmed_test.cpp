// SPDX-License-Identifier: Apache-2.0
#include "host/base/trimmed.hpp"

#include <gtest/gtest.h>

namespace canproof::host::test {

TEST(Trimmed, TrimmedTextKeepsInnerBlanks) {
    EXPECT_EQ(trimmed(" \ta b\tc \t"), "a b\tc");
    EXPECT_EQ(trimmed("abc"), "abc");
}

TEST(Trimmed, TextOfBlanksOnlyIsTrimmedToNothing) {
    EXPECT_EQ(trimmed(""), "");
    EXPECT_EQ(trimmed("\t  \t"), "");
}

TEST(Trimmed, OnlyTheGivenCharactersAreTrimmed) {
    EXPECT_EQ(trimmed("\r\na\r\n", "\r"), "\na\r\n");
    EXPECT_EQ(trimmed("\v a \f", "\v\f"), " a ");
}

}  // namespace canproof::host::test
