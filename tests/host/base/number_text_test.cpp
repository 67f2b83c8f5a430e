// SPDX-License-Identifier: Apache-2.0
#include "host/base/number_text.hpp"

#include <gtest/gtest.h>

namespace canproof::host::test {

TEST(NumberText, DecimalNumbersHaveTheirValue) {
    EXPECT_EQ(decimal_number("0"), 0.0);
    EXPECT_EQ(decimal_number("-12"), -12.0);
    EXPECT_EQ(decimal_number("+0.5"), 0.5);
    EXPECT_EQ(decimal_number(".25"), 0.25);
    EXPECT_EQ(decimal_number("2.5E-1"), 0.25);
    EXPECT_EQ(decimal_number("1e3"), 1000.0);
}

TEST(NumberText, TextThatIsNoDecimalNumberIsRefused) {
    for (const char* text : {"", " 1", "1 ", "0x10", "0x1p-3", "inf", "-inf", "nan", "NaN", "1e999", "1,5", "1.5f", "-",
                             "e", "1-2", "1e", "--1"}) {
        EXPECT_FALSE(decimal_number(text).has_value()) << "`" << text << "`";
    }
}

TEST(NumberText, HexadecimalIntegersHaveTheirValue) {
    EXPECT_EQ(decimal_or_hexadecimal("0x10"), 16.0);
    EXPECT_EQ(decimal_or_hexadecimal("0XfF"), 255.0);
    EXPECT_EQ(decimal_or_hexadecimal("0xFFFFFFFF00000000"), 18446744069414584320.0);  // 2^64 - 2^32
    EXPECT_EQ(decimal_or_hexadecimal("-2.5"), -2.5);
}

TEST(NumberText, TextThatIsNeitherDecimalNorHexadecimalIsRefused) {
    for (const char* text : {"", "0x", "0x1p-3", "-0x1", "0xG", "0x10000000000000000", " 0x1", "inf"}) {
        EXPECT_FALSE(decimal_or_hexadecimal(text).has_value()) << "`" << text << "`";
    }
}

}  // namespace canproof::host::test
