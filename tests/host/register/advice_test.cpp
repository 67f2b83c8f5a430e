// SPDX-License-Identifier: Apache-2.0
// Tests warnings about a valid register: uncovered statements, statements whose items cite another section, and
// requirements with several demands.
#include "host/register/advice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string requirement(const std::string& text, const std::string& source = "M1:1") {
    return "[[requirement]]\nid = \"AO4-R-1\"\ntext = \"" + text + "\"\nsource = [\"" + source +
           "\"]\nkind = \"functional\"\nverify = [\"test\"]\n";
}

std::string statement(const std::string& place, const std::string& rest) {
    return "[[statement]]\nsection = \"" + place + "\"\ntext = \"It blinks.\"\nmark = \"8:00000000000a\"\n" + rest;
}

std::vector<std::string> advice_of(const SpecFiles& files) {
    const LoadResult loaded = load_register(files);
    EXPECT_EQ(all_faults(loaded), "");
    std::vector<std::string> all;
    for (const Fault& one : advice_on(loaded.content)) {
        all.push_back(one.text());
    }
    return all;
}

std::vector<std::string> advice_on_text(const std::string& text) {
    return advice_of(with(items_file, requirement(text)));
}

std::vector<std::string> advice_on_statement(const std::string& place, const std::string& rest,
                                             const std::string& source) {
    SpecFiles files = with(items_file, requirement("It shall blink.", source));
    files["spec/manuals/m/1.toml"] = statement(place, rest);
    return advice_of(files);
}

}  // namespace

TEST(RegisterAdvice, OneDemandInOneSentenceGivesNoAdvice) {
    EXPECT_THAT(advice_on_text("When bit 3 of 1.5 V is set, e.g. by a master, the box shall blink (see 2000h)."),
                IsEmpty());
}

TEST(RegisterAdvice, RequirementOfSeveralDemandsIsReported) {
    EXPECT_THAT(advice_on_text("The box shall blink and shall not sound."),
                ElementsAre("spec/devices/box/items.toml:1: AO4-R-1 demands several things: 1 sentence(s), \"shall\" "
                            "2 time(s); write one requirement for each demand"));
    EXPECT_THAT(advice_on_text("The box shall blink. It is silent."), ElementsAre(HasSubstr("2 sentence(s)")));
    EXPECT_THAT(advice_on_text("The box shall blink (fast). 3 s later it ends."),
                ElementsAre(HasSubstr("2 sentence(s)")));
}

TEST(RegisterAdvice, SecondConditionBehindASemicolonIsReported) {
    EXPECT_THAT(advice_on_text("When bit 3 is set, the box shall blink; when it is clear, the box is silent."),
                ElementsAre("spec/devices/box/items.toml:1: AO4-R-1 has a second condition behind a semicolon: \"; "
                            "when\"; write one requirement for each condition, or one condition for both"));
    for (const char* condition : {"if", "whenever", "while", "where", "unless", "until", "after", "before", "once"}) {
        EXPECT_THAT(advice_on_text(std::string{"The box shall blink; "} + condition + " bit 3 is set, it is silent."),
                    testing::SizeIs(1))
            << condition;
    }
}

TEST(RegisterAdvice, OtherwiseClauseOrDefinitionBehindASemicolonGivesNoAdvice) {
    EXPECT_THAT(advice_on_text("While bit 3 is set, the box shall blink; otherwise it is silent."), IsEmpty());
    EXPECT_THAT(advice_on_text("The box shall blink while bit 3 is set; the period is 2 s."), IsEmpty());
    EXPECT_THAT(advice_on_text("The box shall set 2000h; 0 means off and 1 on, if bit 3 is set."), IsEmpty());
    EXPECT_THAT(advice_on_text("The box shall blink, when bit 3 is set."), IsEmpty());
}

TEST(RegisterAdvice, RetiredRequirementGivesNoAdvice) {
    const std::string text = requirement("The box blinks. It is silent; if asked.") + "retired = \"merged\"\n";
    EXPECT_THAT(advice_of(with(items_file, text)), IsEmpty());
}

TEST(RegisterAdvice, UncoveredStatementIsReported) {
    EXPECT_THAT(advice_on_statement("1", "", "M1:1"),
                ElementsAre("spec/manuals/m/1.toml:1: M1:1/1 has neither `covered` nor `reason`; name in `covered` the "
                            "items that cover the statement, or give in `reason` why no item covers it"));
    EXPECT_THAT(advice_on_statement("1", "reason = \"hardware\"\n", "M1:1"), IsEmpty());
}

TEST(RegisterAdvice, StatementWhoseItemsCiteOnlyOtherManualSectionsIsReported) {
    EXPECT_THAT(
        advice_on_statement("1", "covered = [\"AO4-R-1\"]\n", "M1:Table 3"),
        ElementsAre(
            "spec/manuals/m/1.toml:5: M1:1/1 is covered by AO4-R-1, but none of these items names 1 as its source; "
            "add the place to the source of one item, or name an item that has this source"));
}

TEST(RegisterAdvice, CitationOfAnObjectEqualsThatOfTheSectionThatDescribesIt) {
    EXPECT_THAT(advice_on_statement("2000h", "covered = [\"AO4-R-1\"]\n", "M1:1"), IsEmpty());
    EXPECT_THAT(advice_on_statement("1", "covered = [\"AO4-R-1\"]\n", "M1:Table 3 2000h"), IsEmpty());
}

TEST(RegisterAdvice, CitedSectionIncludesItsSubsections) {
    EXPECT_THAT(advice_on_statement("2.1", "covered = [\"AO4-R-1\"]\n", "M1:Table 3"), testing::SizeIs(1));
    SpecFiles files = with(items_file, requirement("It shall blink.", "M1:2"));
    files[manual_file] += "[[section]]\nref = \"2\"\ntitle = \"t\"\ndisposition = \"normative\"\n";
    files["spec/manuals/m/1.toml"] = statement("2.1", "covered = [\"AO4-R-1\"]\n");
    EXPECT_THAT(advice_of(files), IsEmpty());
}

}  // namespace canproof::host::test
