// SPDX-License-Identifier: Apache-2.0
// Tests the language of conformance cases: expressions, frames, filters, and messages for a line that is no step.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "host/conform/language/data_pattern.hpp"
#include "host/conform/language/expression.hpp"
#include "host/conform/language/filter.hpp"
#include "host/conform/language/functions.hpp"
#include "tests/host/conform/conform_bench.hpp"

namespace canproof::host::conform::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Value evaluated(const std::string& text, Radix radix = Radix::decimal) {
    Scope scope;
    scope.set("N", Value{5});
    scope.set("x", Value{Bytes{0x34, 0x12}});
    Scanner line{text, {"some.toml", 1}};
    const Expression expression = parse_expression(line, radix);
    line.finish();
    return expression(scope);
}

std::int64_t number(const std::string& text) {
    return number_of(evaluated(text));
}

std::vector<std::string> faults_of_steps(const std::string& steps, const std::string& keys = "") {
    std::vector<std::string> faults;
    book_of(case_text("some", steps, keys), &faults);
    return faults;
}

TEST(ConformExpression, OperatorPrecedenceIsThatOfC) {
    EXPECT_EQ(number("1 + 2 * 3"), 7);
    EXPECT_EQ(number("(1 + 2) * 3"), 9);
    EXPECT_EQ(number("1 << 4 | 3"), 19);
    EXPECT_EQ(number("6 & 3 == 3"), 0);  // 6 & 1, as in C
    EXPECT_EQ(number("7 - 2 - 1"), 4);
    EXPECT_EQ(number("-5 + 3"), -2);
    EXPECT_EQ(number("!0 && ~0 == -1"), 1);
    EXPECT_EQ(number("17 % 5 + 17 / 5"), 5);
}

TEST(ConformExpression, RadixFollowsFromPrefixSuffixOrContext) {
    EXPECT_EQ(number("0x1F"), 31);
    EXPECT_EQ(number("1Fh"), 31);
    EXPECT_EQ(number("100"), 100);
    EXPECT_EQ(number_of(evaluated("100", Radix::hexadecimal)), 256);
    EXPECT_EQ(number_of(evaluated("600+N", Radix::hexadecimal)), 0x605);
}

// The greatest number of 64 bits is 2^64 - 1 = 18446744073709551615; as a signed number its bits are -1.
TEST(ConformExpression, NumbersHave64BitsInEachRadix) {
    EXPECT_EQ(number("18446744073709551615"), -1);
    EXPECT_EQ(number("0xFFFFFFFFFFFFFFFF"), -1);
    EXPECT_EQ(number("12000000000000000000 == 0xA688906BD8B00000"), 1);
    EXPECT_THROW(number("18446744073709551616"), LanguageError);
    EXPECT_THROW(number("0x10000000000000000"), LanguageError);
    EXPECT_THROW(number("100000000000000000000"), LanguageError);
}

TEST(ConformExpression, TimesAreCountedInMicroseconds) {
    EXPECT_EQ(number("100 us"), 100);
    EXPECT_EQ(number("2 ms + 1 s"), 1002000);
    EXPECT_EQ(number("(1 + 1) ms"), 2000);
}

TEST(ConformExpression, BytesInExpressionsAreLittleEndian) {
    EXPECT_EQ(number("$x"), 0x1234);
    EXPECT_EQ(number("$x[1]"), 0x12);
    EXPECT_EQ(number("size(join($x, hex(01 02 03)))"), 5);
    EXPECT_EQ(evaluated("le(0x1234, 2)").bytes, (Bytes{0x34, 0x12}));
    EXPECT_EQ(evaluated("slice(hex(01 02 03 04), 1, 2)").bytes, (Bytes{2, 3}));
    EXPECT_EQ(number("$x == hex(34 12)"), 1);
}

TEST(ConformExpression, DivisionByZeroShiftBy64AndUnknownVariableAreRefused) {
    EXPECT_THROW(number("1 / 0"), BrokenCase);
    EXPECT_THROW(number("1 << 64"), BrokenCase);
    EXPECT_THROW(number("$nothing"), BrokenCase);
}

// CRC-16 with polynomial 1021h and start value 0: the check value of "123456789" is 31C3h.
TEST(ConformFunctions, CrcFunctionGivesTheCrcOfSdoBlockTransfer) {
    const std::string digits = "123456789";
    EXPECT_EQ(block_crc(Bytes(digits.begin(), digits.end())), 0x31C3);
}

TEST(ConformFunctions, PatternFunctionRepeatsNoSegmentOfSevenBytes) {
    const Bytes bytes = bytes_of(evaluated("pattern(7 * 300)"));
    std::set<Bytes> segments;
    for (std::size_t i = 0; i < bytes.size(); i += 7) {
        const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(i);
        EXPECT_TRUE(segments.insert(Bytes(first, first + 7)).second) << i;
    }
}

bool fits(const std::string& pattern, const Bytes& data, Captures& captures) {
    Scope scope;
    scope.set("x", Value{0x1234});
    Scanner line{pattern, {"some.toml", 1}};
    return DataPattern::parse(line).matches(scope, data, captures);
}

TEST(ConformDataPattern, PatternComparesEachByte) {
    Captures none;
    EXPECT_TRUE(fits("40 ?? 4? ?1", {0x40, 0xFF, 0x4E, 0x31}, none));
    EXPECT_FALSE(fits("40 ?? 4? ?1", {0x40, 0xFF, 0x5E, 0x31}, none));
    EXPECT_TRUE(fits("C2|C6", {0xC6}, none));
    EXPECT_FALSE(fits("C2|C6", {0xC4}, none));
    EXPECT_TRUE(fits("%1x000001", {0xC1}, none));
    EXPECT_FALSE(fits("%1x000001", {0x41}, none));
    EXPECT_TRUE(fits("$x:u16 @1017:00", {0x34, 0x12, 0x17, 0x10, 0x00}, none));
}

TEST(ConformDataPattern, PatternNeedsTheExactLengthUnlessOpenEnded) {
    Captures none;
    EXPECT_FALSE(fits("40", {0x40, 0x00}, none));
    EXPECT_FALSE(fits("40 00", {0x40}, none));
    EXPECT_TRUE(fits("40 ...", {0x40}, none));
    EXPECT_TRUE(fits("40 ...", {0x40, 0x01, 0x02}, none));
    EXPECT_TRUE(fits("", {}, none));
    EXPECT_FALSE(fits("", {0x00}, none));
}

TEST(ConformDataPattern, PatternCapturesValuesInLittleEndian) {
    Captures captures;
    EXPECT_TRUE(fits("43 ->size:u32 ->rest:all", {0x43, 0x10, 0x27, 0, 0, 0xAA, 0xBB}, captures));
    EXPECT_EQ(captures.at("size").number, 10000);
    EXPECT_EQ(captures.at("rest").bytes, (Bytes{0xAA, 0xBB}));
}

TEST(ConformFilter, FilterSelectsEntriesOfTheDataSheet) {
    const ConformSheet sheet = slave_sheet();
    Scanner line{"rw, u16, index 1017", {"some.toml", 1}};
    const auto found = parse_filter(line, "").select(sheet);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().object->index, 0x1017);
    Scanner none{"writable, const", {"some.toml", 1}};
    EXPECT_TRUE(parse_filter(none, "").select(sheet).empty());
}

TEST(ConformLanguage, ErrorNamesFileLineAndFix) {
    const auto faults = faults_of_steps("read 1000:00\nexpekt 580+N: 43 ...");
    // [[case]] is line 1; id, group, shows, section and an empty line follow, then steps = ''' in line 7.
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_THAT(faults.front(), HasSubstr("spec/conformance/some.toml:9: `expekt` is no step"));
    EXPECT_THAT(faults.front(), HasSubstr("begin with one of send, expect"));
}

struct BadLine {
    const char* steps;
    const char* told;

    friend std::ostream& operator<<(std::ostream& out, const BadLine& line) { return out << line.steps; }
};

class ConformBadLine : public testing::TestWithParam<BadLine> {};

TEST_P(ConformBadLine, InvalidLineIsReportedWithItsFix) {
    const auto faults = faults_of_steps(GetParam().steps);
    ASSERT_FALSE(faults.empty()) << GetParam().steps;
    EXPECT_THAT(faults.front(), HasSubstr(GetParam().told));
}

INSTANTIATE_TEST_SUITE_P(
    Steps, ConformBadLine,
    testing::Values(BadLine{"send 600+N", "write a colon and its bytes"}, BadLine{"send 600+N: 4", "is no byte"},
                    BadLine{"send 600+N: $x", "give the width"}, BadLine{"read 1017", "is no object"},
                    BadLine{"write 1017:00 100", "write 1017:00 = 100"},
                    BadLine{"read 1000:01 fails 0609", "eight hexadecimal digits"},
                    BadLine{"silence 580+N", "write silence 580+N for 500 ms"},
                    BadLine{"period 700+N = 100 ms over 20", "give the tolerance"},
                    BadLine{"count 180+N for 1 s", "`>= 5` or `<= 5`"}, BadLine{"check $x == 1", "double quotes"},
                    BadLine{"check $x = 1 \"text\"", "double quotes"}, BadLine{"repeat 3 {\nwait 1 ms", "has no end"},
                    BadLine{"wait 1 ms\n}", "no block to close"},
                    BadLine{"choose E: writeable", "is no filter for entries"},
                    BadLine{"do nothing-known", "there is no procedure"}, BadLine{"nmt go", "is no NMT command"},
                    BadLine{"lss hello", "is no LSS service"}, BadLine{"wait 1 ms now", "is not expected here"},
                    BadLine{"block write 1008:00 = zeros(9) lost 3", "is no option of a block transfer"},
                    BadLine{"let x = foo", "functions are"}, BadLine{"each object as E {\n}", "`each` has no list"}));

TEST(ConformLanguage, UnknownKeysAndRepeatedNamesOfCasesAreRefused) {
    EXPECT_THAT(faults_of_steps("wait 1 ms", "risk = \"some\""), ElementsAre(HasSubstr("none")));
    EXPECT_THAT(faults_of_steps("wait 1 ms", "needs = [\"a unicorn\"]"),
                ElementsAre(HasSubstr("is no condition for `needs`")));
    EXPECT_THAT(faults_of_steps("wait 1 ms", "colour = \"red\""), ElementsAre(HasSubstr("colour")));
    std::vector<std::string> twice;
    book_of(case_text("same", "wait 1 ms") + case_text("same", "wait 1 ms"), &twice);
    EXPECT_THAT(twice, ElementsAre(HasSubstr("there are two cases same")));
}

}  // namespace

}  // namespace canproof::host::conform::test
