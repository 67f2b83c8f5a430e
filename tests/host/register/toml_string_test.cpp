// SPDX-License-Identifier: Apache-2.0
#include "host/register/toml_string.hpp"

#include <gtest/gtest.h>

namespace canproof::host::test {

TEST(TomlString, TextIsPutInQuotationMarks) {
    EXPECT_EQ(toml_string("CAN-CBX"), "\"CAN-CBX\"");
    EXPECT_EQ(toml_string(""), "\"\"");
}

TEST(TomlString, QuotationMarksAndBackslashesAreEscaped) {
    EXPECT_EQ(toml_string(R"(a "b" \c)"), R"("a \"b\" \\c")");
}

TEST(TomlString, ControlCharactersAreWrittenAsTheirCode) {
    EXPECT_EQ(toml_string("a\nb\x7F"), R"("a\u000Ab\u007F")");  // line feed 0Ah, delete 7Fh
}

}  // namespace canproof::host::test
