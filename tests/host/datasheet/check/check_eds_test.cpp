// SPDX-License-Identifier: Apache-2.0
// Tests every rule of `canproof eds check` with a bad and a good example, and tests the fixes.
#include "host/datasheet/check/check_eds.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "host/base/input_error.hpp"
#include "host/datasheet/check/fix_eds.hpp"
#include "host/datasheet/read_eds.hpp"
#include "host/datasheet/write_dictionary.hpp"
#include "tests/host/datasheet/check/examples.hpp"
#include "tests/host/datasheet/check/good_sheet.hpp"

namespace canproof::host::test {

namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<RuleExample> all_examples() {
    std::vector<RuleExample> all;
    for (const auto& some : {file_examples(), object_examples(), entry_examples(), service_examples()}) {
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

std::vector<EdsFinding> findings_in(const std::string& text) {
    return check_eds(text, "box.eds");
}

/// Returns the lines in which a rule has a finding.
std::vector<unsigned> lines_of(const std::vector<EdsFinding>& findings, const std::string& rule) {
    std::vector<unsigned> lines;
    for (const EdsFinding& finding : findings) {
        if (finding.rule.id == rule) {
            lines.push_back(finding.line);
        }
    }
    return lines;
}

std::set<std::string> rules_in(const std::string& text) {
    std::set<std::string> rules;
    for (const EdsFinding& finding : findings_in(text)) {
        rules.insert(finding.rule.id);
    }
    return rules;
}

std::string dictionary_of(const std::string& text) {
    return write_object_json(read_eds(text, "box.eds").part);
}

}  // namespace

TEST(EdsCheck, GoodSheetHasNoFindings) {
    std::string all;
    for (const EdsFinding& finding : findings_in(good_sheet())) {
        all += fmt::format("{}: {}: {}\n", finding.line, finding.rule.id, finding.what);
    }
    EXPECT_EQ(all, "");
}

TEST(EdsCheck, EveryRuleHasOneExampleAndADescriptionFixAndSource) {
    std::multiset<std::string> examples;
    for (const RuleExample& example : all_examples()) {
        examples.insert(example.rule);
    }
    std::multiset<std::string> rules;
    for (const EdsRule& rule : eds_rules()) {
        rules.insert(rule.id);
        EXPECT_GT(std::string{rule.what}.size(), 10U) << rule.id;
        EXPECT_GT(std::string{rule.fix}.size(), 5U) << rule.id;
        EXPECT_EQ(std::string{rule.source}.rfind("CiA 30", 0), 0U) << rule.id;
        EXPECT_EQ(std::string{rule.id}.find_first_not_of("abcdefghijklmnopqrstuvwxyz0-"), std::string::npos) << rule.id;
    }
    EXPECT_EQ(examples, rules);
    EXPECT_GE(rules.size(), 80U);
}

TEST(EdsCheck, EachRuleHasAFindingInTheLineOfItsBadExample) {
    for (const RuleExample& example : all_examples()) {
        const PatchedSheet sheet = patched_sheet(example.bad);
        const auto lines = lines_of(findings_in(sheet.text), example.rule);
        ASSERT_THAT(lines, testing::Not(IsEmpty())) << example.rule;
        for (const unsigned line : lines) {
            EXPECT_THAT(sheet.lines, Contains(line)) << example.rule;
        }
    }
}

TEST(EdsCheck, NoRuleHasAFindingInItsGoodExample) {
    for (const RuleExample& example : all_examples()) {
        EXPECT_THAT(lines_of(findings_in(patched_sheet(example.good).text), example.rule), IsEmpty()) << example.rule;
    }
}

TEST(EdsCheck, WarningsOfTheConformanceTestToolAreFound) {
    const PatchedSheet sheet = patched_sheet(
        "[FileInfo] Editor=Nobody | [6200sub1] AccessType=rw | @[FileInfo] Editor | @[1600sub1] DefaultValue | "
        "@[6200sub1] AccessType");
    std::vector<std::string> found;
    std::vector<unsigned> lines;
    for (const EdsFinding& finding : findings_in(sheet.text)) {
        found.emplace_back(finding.rule.id);
        lines.push_back(finding.line);
        EXPECT_EQ(finding.rule.severity, EdsSeverity::warning);
    }
    EXPECT_THAT(found, ElementsAre("fileinfo-key-unknown", "map-no-direction", "mapping-no-direction"));
    EXPECT_EQ(lines, sheet.lines);
}

TEST(EdsCheck, FindingsDoNotDependOnCarriageReturnsAtLineEnds) {
    std::string text;
    for (const char c : patched_sheet("[1017] DataType=0x0099").text) {
        text += c == '\n' ? std::string{"\r\n"} : std::string{c};
    }
    EXPECT_THAT(rules_in(text), ElementsAre("data-type-unknown"));
}

TEST(EdsCheck, FileNameKeyIsCheckedOnlyWhenTheNameOfTheFileIsGiven) {
    EXPECT_THAT(check_eds(good_sheet()), IsEmpty());
    EXPECT_EQ(lines_of(check_eds(good_sheet(), "crate.eds"), "fileinfo-name-differs").size(), 1U);
}

TEST(EdsCheck, DeviceConfigurationFileHasItsOwnKeys) {
    const std::string text =
        patched_sheet(
            "[FileInfo] FileName=box.dcf | [DeviceComissioning] NodeID=5 | [DeviceComissioning] Baudrate=125 | "
            "[1017] ParameterValue=500")
            .text;
    EXPECT_THAT(check_eds(text, "box.dcf"), IsEmpty());
    EXPECT_EQ(lines_of(check_eds(text, "box.eds"), "dcf-section").size(), 1U);
}

TEST(EdsCheck, TextThatIsNoDataSheetIsRefused) {
    EXPECT_THROW(check_eds(""), InputError);
    EXPECT_THROW(check_eds("<?xml version=\"1.0\"?>\n"), InputError);
    std::string nonsense = "[FileInfo]\n";
    for (int i = 0; i < 1001; ++i) {
        nonsense += "nonsense\n";
    }
    EXPECT_THROW(check_eds(nonsense), InputError);
    EXPECT_THROW(check_eds("[FileInfo]\n" + std::string(1000000, '\n')), InputError);
    EXPECT_THROW(check_eds("<xml>\n[FileInfo]\n"), InputError);
}

TEST(EdsCheck, EverySafeFixRemovesItsFindingAndKeepsTheDictionary) {
    int fixed_rules = 0;
    for (const RuleExample& example : all_examples()) {
        const std::string bad = patched_sheet(example.bad).text;
        const auto findings = findings_in(bad);
        const bool fixable = std::any_of(findings.begin(), findings.end(), [&](const EdsFinding& finding) {
            return finding.rule.id == example.rule && finding.is_fixable();
        });
        if (!fixable) {
            continue;
        }
        ++fixed_rules;
        const EdsFixed fixed = fix_eds(bad, "box.eds");
        const auto before = rules_in(bad);
        const auto after = rules_in(fixed.text);
        EXPECT_EQ(after.count(example.rule), 0U) << example.rule << "\n" << fixed.text;
        EXPECT_TRUE(std::includes(before.begin(), before.end(), after.begin(), after.end())) << example.rule;
        EXPECT_EQ(dictionary_of(fixed.text), dictionary_of(bad)) << example.rule;
        EXPECT_EQ(lines_of(fixed.done, example.rule).size(), lines_of(findings, example.rule).size()) << example.rule;
    }
    EXPECT_GE(fixed_rules, 25);
}

TEST(EdsFix, ManyFaultsAreFixed_AndTheDictionaryIsThatOfTheGoodSheet) {
    const std::string bad = patched_sheet(
                                "[FileInfo] CreationDate=2020-02-29 | [DeviceInfo] NrOfRXPDO=7 | "
                                "[Comments] Lines=0 | [1003] SubNumber=2 | [1017] DataType~datatype=0x0006 | "
                                "[1014] DefaultValue=0x80+$NODEID | [OptionalObjects] SupportedObjects=1 | "
                                "[1029sub1] AccessType=RW | [MandatoryObjects] 2=0x1018 | [MandatoryObjects] 3=0x1001 "
                                "| [FileInfo] ~[FILEINFO]")
                                .text;
    EXPECT_NE(bad, good_sheet());
    const EdsFixed fixed = fix_eds(bad, "box.eds");
    EXPECT_THAT(rules_in(fixed.text), IsEmpty());
    EXPECT_EQ(dictionary_of(fixed.text), dictionary_of(good_sheet()));
    EXPECT_EQ(fix_eds(fixed.text, "box.eds").text, fixed.text);
}

TEST(EdsFix, ThousandUnlistedObjectsAreListedAtOnce) {
    std::string text = "[MandatoryObjects]\nSupportedObjects=0\n";
    for (unsigned index = 0x2000; index < 0x2400; ++index) {
        text += fmt::format("[{:04X}]\nParameterName=A\nObjectType=0x7\nDataType=0x0005\nAccessType=rw\n", index);
    }
    const EdsFixed fixed = fix_eds(text);
    EXPECT_THAT(fixed.text, testing::HasSubstr("[ManufacturerObjects]\nSupportedObjects=1024\n1=0x2000\n"));
    EXPECT_EQ(lines_of(check_eds(fixed.text), "list-none").size(), 0U);
}

TEST(EdsFix, FaultsThatNeedADecisionAreLeftUnchanged) {
    const std::string bad = patched_sheet("[2000] DefaultValue=101 | -[2004] | [1017] DataType=0x0099").text;
    const EdsFixed fixed = fix_eds(bad, "box.eds");
    EXPECT_EQ(fixed.text, bad);
    EXPECT_THAT(fixed.done, IsEmpty());
}

}  // namespace canproof::host::test
