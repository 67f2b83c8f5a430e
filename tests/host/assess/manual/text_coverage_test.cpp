// SPDX-License-Identifier: Apache-2.0
// Tests the search in the text of a manual: for passages by their marks (hashes), for sections by their headings, and
// for text that no statement covers. The text is invented; no manual is quoted.
#include "host/assess/manual/text_coverage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

#include "host/assess/manual/find_marks.hpp"
#include "host/assess/manual/manual_text.hpp"
#include "host/assess/manual/section_lines.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

const std::string text_of_manual =
    "Contents\n"
    "1. Lamp .... 4\n"
    "1.1. Blinking of the lamp .... 5\n"
    "2. Cables .... 6\n"
    "\n"
    "# 1. Lamp\n"
    "The lamp is\n"
    "green. It never sleeps.\n"
    "## **1.1. Blinking of the Lamp**\n"
    "Table 1 Rates\n"
    "### Notes\n"
    "| fast | 10 Hz |\n"
    "# 2. Cables\n"
    "Red and black.\n";

Section section(const std::string& ref, const std::string& title, bool normative) {
    return {ref, title, normative, normative ? "" : "wiring", {}, {}, {}};
}

Manual manual() {
    Manual made;
    made.key = "M";
    made.sections = {section("1", "Lamp", true), section("1.1", "Blinking lamp", true), section("2", "Cables", false),
                     section("Table 1", "Rates", true)};
    return made;
}

Manual with_passages(const std::vector<std::string>& passages) {
    Manual made = manual();
    for (const auto& passage : passages) {
        Statement statement;
        statement.section = "1";
        statement.number = static_cast<unsigned>(made.statements.size() + 1);
        statement.marks = {mark_of(passage)};
        made.statements.push_back(statement);
    }
    return made;
}

std::vector<std::string> told(const TextCoverage& coverage) {
    std::vector<std::string> all;
    for (const auto& line : coverage.uncovered) {
        all.push_back(std::to_string(line.line) + " " + line.section + " " + line.words);
    }
    return all;
}

}  // namespace

TEST(ManualTextMarks, PassageIsFoundByItsHashAcrossLinesAndAtEachOccurrence) {
    const ManualText text{"The lamp is\ngreen; the *lamp* is GREEN."};
    // Numbers of letters before each passage: "Thelampisgreen" has 14; "the" begins at 14, "lamp" at 3 and 17.
    EXPECT_THAT(find_marks(text, {mark_of("the lamp is green"), mark_of("lamp is"), mark_of("red")}),
                ElementsAre(Pair(mark_of("lamp is"), ElementsAre(3U, 17U)),
                            Pair(mark_of("the lamp is green"), ElementsAre(0U, 14U))));
}

TEST(ManualTextMarks, PassageFoundByItsHashBeginsAtTheStartOfAWord) {
    const ManualText text{"unlit lamp"};
    EXPECT_THAT(find_marks(text, {mark_of("lit")}), IsEmpty());
    EXPECT_THAT(find_marks(text, {mark_of("unlit")}), testing::SizeIs(1));
}

TEST(ManualTextMarks, PassageFoundByItsHashMayEndWithinAWord) {
    const ManualText text{"two lamps"};
    EXPECT_THAT(find_marks(text, {mark_of("two lamp")}), ElementsAre(Pair(mark_of("two lamp"), ElementsAre(0U))));
}

TEST(ManualTextMarks, NoPassageIsFoundInAnEmptyText) {
    EXPECT_THAT(find_marks(ManualText{""}, {mark_of("a")}), IsEmpty());
    EXPECT_THAT(find_marks(ManualText{"...\n\n"}, {mark_of("a")}), IsEmpty());
}

TEST(ManualTextSections, SectionsBeginAtTheirHeadingsAndNotInTheTableOfContents) {
    const Manual made = manual();
    const auto found = section_lines(made, ManualText{text_of_manual}.lines());
    ASSERT_EQ(found.size(), 3U);
    // Lines count from 0: the headings are lines 6, 9 and 13 counted from 1.
    EXPECT_EQ(found[0].section->ref, "1");
    EXPECT_EQ(found[0].begin, 5U);
    EXPECT_EQ(found[0].end, 8U);
    EXPECT_EQ(found[1].section->ref, "1.1");
    EXPECT_EQ(found[1].begin, 8U);
    EXPECT_EQ(found[1].end, 12U);
    EXPECT_EQ(found[2].section->ref, "2");
    EXPECT_EQ(found[2].end, 14U);
}

TEST(ManualTextSections, NumberedListsAndReferencesAreNoSections) {
    Manual made;
    made.sections = {section("1", "Lamp colours", true), section("2", "Blinking lamp", true)};
    const std::vector<std::string> lines{"1 Lamp colours", "2 green wires", "2 Blinking lamp", "see 1 Lamp colours",
                                         "1 Lamp colours are listed"};
    const auto found = section_lines(made, lines);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].begin, 0U);
    EXPECT_EQ(found[1].begin, 2U);
}

TEST(ManualTextSections, SectionWithAThreePartNumberIsFoundUnderAParaphrasedTitle) {
    Manual made;
    made.sections = {section("1.2", "Colours", true), section("1.2.3", "What red means", true)};
    const std::vector<std::string> lines{"1.2.3 Red lamp 17", "1.2 of the lamps", "1.2.3 Red lamp (x = 1...4)"};
    const auto found = section_lines(made, lines);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].section->ref, "1.2.3");
    EXPECT_EQ(found[0].begin, 2U);
}

TEST(ManualTextCoverage, PassageThatTheTextDoesNotContainIsReported) {
    const TextCoverage coverage = cover_text(with_passages({"The lamp is green", "The lamp is red"}), text_of_manual);
    EXPECT_EQ(coverage.marks, 2U);
    EXPECT_THAT(coverage.missing, ElementsAre("M:1/2: " + mark_of("The lamp is red").text()));
}

TEST(ManualTextCoverage, UncoveredTextOfNormativeSectionsIsListed) {
    const TextCoverage coverage = cover_text(with_passages({"The lamp is green"}), text_of_manual);
    EXPECT_THAT(told(coverage), ElementsAre("8 1 It never sleeps.", "12 1.1 fast | 10 Hz |"));
    EXPECT_THAT(coverage.not_located, IsEmpty());
    // "The lamp is" has 9 letters, "green. It never sleeps." 5 + 13, "fast 10 Hz" 8; of these 14 are covered.
    EXPECT_EQ(coverage.normative.all, 35U);
    EXPECT_EQ(coverage.normative.covered, 14U);
    EXPECT_DOUBLE_EQ(coverage.normative.percent(), 40.0);
}

TEST(ManualTextCoverage, CoverageIsCompleteWhenEachSentenceHasAStatement) {
    const TextCoverage coverage =
        cover_text(with_passages({"The lamp is green", "It never sleeps", "fast 10 Hz"}), text_of_manual);
    EXPECT_THAT(told(coverage), IsEmpty());
    EXPECT_DOUBLE_EQ(coverage.normative.percent(), 100.0);
    EXPECT_LT(coverage.whole.percent(), 100.0) << "contents and cables have no statement";
}

TEST(ManualTextCoverage, NormativeSectionsWithoutAHeadingAreReported) {
    EXPECT_THAT(cover_text(manual(), "1. Lamp\nIt is green.\n").not_located, ElementsAre("1.1"));
}

namespace {

/// Returns the CPU seconds of the quickest of three searches for 50 passages in a text of this number of words.
double cost_of(const unsigned words) {
    std::string text;
    for (unsigned i = 0; i < words; ++i) {
        text += std::to_string(10000U + i * 7U % 50021U) + " ";
    }
    Manual made = manual();
    for (std::size_t i = 0; i < 50; ++i) {
        Statement statement;
        statement.marks = {mark_of(text.substr(0, 100 + 6 * i))};
        made.statements.push_back(statement);
    }
    double least = 1.0e9;
    for (int i = 0; i < 3; ++i) {
        const std::clock_t start = std::clock();
        EXPECT_THAT(cover_text(made, text).missing, IsEmpty());
        least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return least;
}

}  // namespace

TEST(ManualTextCoverage, CoverageCostGrowsLessThanQuadraticallyWithTheText) {
    // Four times the text takes four times the work; the limit allows twice that. Quadratic work would take sixteen
    // times as much.
    EXPECT_LT(cost_of(8000), 8.0 * cost_of(2000));
}

}  // namespace canproof::host::test
