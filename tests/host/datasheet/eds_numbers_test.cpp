// SPDX-License-Identifier: Apache-2.0
// Tests how numbers of CiA 306 are read: bases, signs, bit patterns, reals, and sums with the node-ID.
#include "host/datasheet/eds_numbers.hpp"

#include <gtest/gtest.h>

namespace canproof::host::test {

namespace {

std::string value_of(const std::string& text, const std::string& type) {
    const auto value = eds_value(text, type);
    return value ? to_text(*value) : "none";
}

}  // namespace

TEST(EdsNumbers, NumberBasesAreThoseOfC) {
    EXPECT_EQ(value_of("10", "UNSIGNED32"), "10");
    EXPECT_EQ(value_of("0x10", "UNSIGNED32"), "16");
    EXPECT_EQ(value_of("0XfF", "UNSIGNED32"), "255");
    EXPECT_EQ(value_of("010", "UNSIGNED32"), "8");
    EXPECT_EQ(value_of("0", "UNSIGNED32"), "0");
    EXPECT_EQ(value_of("0x10UL", "UNSIGNED32"), "16");  // the notation of C, with suffixes
    EXPECT_EQ(value_of("10u", "UNSIGNED32"), "10");
    EXPECT_EQ(value_of("-5L", "INTEGER64"), "-5");
    EXPECT_EQ(value_of("0x1234567890ABCDEFLL", "INTEGER64"), "1311768467294899695");
    for (const char* wrong :
         {"", "x", "UL", "0xUL", "1UL0", "0x", "09", "1 h", "12abc", "+5", "--1", "0x1G", "99999999999999999999999"}) {
        EXPECT_EQ(value_of(wrong, "UNSIGNED32"), "none") << wrong;
    }
}

TEST(EdsNumbers, ValuesMustFitTheirType) {
    EXPECT_EQ(value_of("255", "UNSIGNED8"), "255");
    EXPECT_EQ(value_of("256", "UNSIGNED8"), "none");
    EXPECT_EQ(value_of("-1", "UNSIGNED8"), "none");
    EXPECT_EQ(value_of("-128", "INTEGER8"), "-128");
    EXPECT_EQ(value_of("-129", "INTEGER8"), "none");
    EXPECT_EQ(value_of("-9223372036854775808", "INTEGER64"), "-9223372036854775808");
    EXPECT_EQ(value_of("0xFFFFFFFFFFFFFFFF", "UNSIGNED64"), "-1");  // the same 64 bits as a signed number
    EXPECT_EQ(value_of("1", "BOOLEAN"), "true");
    EXPECT_EQ(value_of("2", "BOOLEAN"), "none");
}

TEST(EdsNumbers, HexadecimalOfASignedTypeMayBeItsBitPattern) {
    EXPECT_EQ(value_of("0x8000", "INTEGER16"), "-32768");
    EXPECT_EQ(value_of("0xFFFF", "INTEGER16"), "-1");
    EXPECT_EQ(value_of("0x7FFF", "INTEGER16"), "32767");
    EXPECT_EQ(value_of("0x10000", "INTEGER16"), "none");
    EXPECT_EQ(value_of("32768", "INTEGER16"), "none");  // a decimal number is never a bit pattern
    EXPECT_EQ(value_of("0xFFFFFFFFFFFFFFFE", "INTEGER64"), "-2");
}

TEST(EdsNumbers, RealsAreDecimalOrIeeeBits) {
    EXPECT_EQ(value_of("1.5", "REAL32"), "1.5");
    EXPECT_EQ(value_of("-2.5E2", "REAL32"), "-250");
    EXPECT_EQ(value_of("0x3FC00000", "REAL32"), "1.5");  // sign 0, exponent 127, mantissa 1.1
    EXPECT_EQ(value_of("0xC000000000000000", "REAL64"), "-2");
    EXPECT_EQ(value_of("1.5f", "REAL32"), "1.5");
    for (const char* wrong : {"f", "nan", "inf", "1e40", "0x7F800000", "0x1FFFFFFFF", "1.5.2", "e", ""}) {
        EXPECT_EQ(value_of(wrong, "REAL32"), "none") << wrong;
    }
}

TEST(EdsNumbers, NodeIdVariableIsReadAsATermOfASum) {
    const auto split = [](const std::string& text) {
        const auto term = split_node_id(text);
        return term ? term->rest + (term->has_node_id ? " + node-ID" : "") : std::string{"none"};
    };
    EXPECT_EQ(split("0x180"), "0x180");
    EXPECT_EQ(split("$NODEID+0x180"), "0x180 + node-ID");
    EXPECT_EQ(split("$NodeId + 0x180"), "0x180 + node-ID");
    EXPECT_EQ(split("0x180+$NODEID"), "0x180 + node-ID");
    EXPECT_EQ(split("$NODEID"), "0 + node-ID");
    EXPECT_EQ(split("$NODEID*2"), "none");
    EXPECT_EQ(split("$NODE+1"), "none");
    EXPECT_EQ(split("$"), "none");
}

TEST(EdsNumbers, HexadecimalDigitsOfOctetsComeInPairs) {
    EXPECT_EQ(eds_octets("01 a0 FF").value(), std::string("\x01\xA0\xFF", 3));
    EXPECT_EQ(eds_octets("01A0").value(), std::string("\x01\xA0", 2));
    EXPECT_EQ(eds_octets("").value(), "");
    EXPECT_FALSE(eds_octets("01A").has_value());
    EXPECT_FALSE(eds_octets("zz").has_value());
}

}  // namespace canproof::host::test
