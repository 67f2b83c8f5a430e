// SPDX-License-Identifier: Apache-2.0
// Tests which texts are UTF-8. The limits are those of RFC 3629, section 4.
#include "host/base/utf8.hpp"

#include <gtest/gtest.h>

namespace canproof::host::test {

TEST(Utf8, CharactersAtTheLimitsOfEachLengthAreUtf8) {
    for (const char* text : {"", "~", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80",
                             "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF", "a\xC3\xB6z"}) {
        EXPECT_TRUE(is_utf8(text)) << text;
    }
}

TEST(Utf8, OverlongCharactersSurrogatesAndCutCharactersAreNotUtf8) {
    for (const char* text : {"\x80", "\xC1\xBF", "\xC3", "\xC3z", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xE2\x82",
                             "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "gr\xF6sse"}) {
        EXPECT_FALSE(is_utf8(text)) << text;
    }
}

TEST(Utf8, ShownTextReplacesEachWrongByteAndKeepsLineBreaks) {
    EXPECT_EQ(shown_text("a\xFF\x01\n\xC3\xB6"), "a\xEF\xBF\xBD\xEF\xBF\xBD\n\xC3\xB6");
}

}  // namespace canproof::host::test
