// SPDX-License-Identifier: Apache-2.0
// Tests the audit of statements, with a small manual and with items that have passed tests or none, and the report on
// each statement.
#include "host/assess/trace/statement_audit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/assess/story/story.hpp"
#include "host/assess/trace/audit_filter.hpp"
#include "host/assess/trace/audit_json.hpp"
#include "host/base/input_error.hpp"
#include "host/register/fingerprint.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Requirement requirement(const std::string& id) {
    Requirement one;
    one.id = id;
    one.text = "It blinks.";
    one.sources = {"M:1"};
    one.kind = "functional";
    one.verify = {"test"};
    return one;
}

Statement statement(const std::string& section, unsigned number, std::vector<std::string> covered,
                    const std::string& reason = "") {
    Statement one;
    one.section = section;
    one.number = number;
    one.text = "The lamp of " + section + " blinks.";
    one.marks = {{20 + number, "00000000000a"}};
    one.covered = std::move(covered);
    one.reason = reason;
    return one;
}

/// Manual M: sections 1 (which describes 6411h) and 2 are normative, 3 is not. Items cover every statement, and passed
/// tests show every item.
class AuditOfStatements : public testing::Test {
  protected:
    AuditOfStatements() {
        Manual manual;
        manual.key = "M";
        manual.sections = {{"1", "lamps", true, "", {"6411h"}, {}, {}},
                           {"2", "rates", true, "", {}, {}, {}},
                           {"3", "cables", false, "wiring", {}, {}, {}}};
        manual.statements = {statement("1", 1, {"D-A-001"}), statement("6411h", 1, {"D-A-001", "D-A-002"}),
                             statement("2", 1, {"D-D-001"}), statement("2", 2, {}, "repeats M:1/1")};
        content.manuals = {manual};
        Part part;
        part.name = "device";
        part.info.manual = "M";
        part.requirements = {requirement("D-A-001"), requirement("D-A-002")};
        Decision decision;
        decision.id = "D-D-001";
        decision.chosen = "the first";
        decision.affects = {"D-A-002"};
        part.decisions = {decision};
        for (const auto& prints : {fingerprints(part), fingerprints(manual)}) {
            for (const auto& [id, print] : prints) {
                part.reviews[id] = {print, "", "", "2026-01-02", "someone", "author", "", {}};
            }
        }
        content.parts = {part};
        for (const char* id : {"D-A-001", "D-A-002"}) {
            evidence.verdicts[id] = {{std::string{"S.T"} + id, "test", true, 0.0, "tests/a_test.cpp"}};
            evidence.implemented[id] = {"src/firmware/a.cpp:3"};
        }
    }

    std::vector<Statement>& statements() { return content.manuals[0].statements; }
    std::vector<PartAudit> audits() { return audit_all(content, evidence); }
    std::vector<std::string> gaps() { return audits().at(0).gaps; }
    std::map<std::string, std::string> status() {
        std::map<std::string, std::string> all;
        const auto found = audits();
        for (const auto& one : found.at(0).statements) {
            all[one.id] = one.status;
        }
        return all;
    }
    std::optional<Story> story(const std::string& subject) {
        const auto all = audits();
        return StoryTeller{content, all, evidence, mutations}.tell(subject);
    }

    Register content;
    Evidence evidence;
    CountsByItem mutations;
};

}  // namespace

TEST_F(AuditOfStatements, AuditReportsNothingWhenAllStatementsAreCoveredOrExplained) {
    EXPECT_THAT(gaps(), IsEmpty());
    EXPECT_THAT(status(), ElementsAre(testing::Pair("M:1/1", "shown"), testing::Pair("M:2/1", "shown"),
                                      testing::Pair("M:2/2", "explained"), testing::Pair("M:6411h/1", "shown")));
}

TEST_F(AuditOfStatements, UncoveredStatementIsReported) {
    statements()[1].covered.clear();
    EXPECT_THAT(
        gaps(),
        ElementsAre(
            "M:6411h/1: no item covers the statement, and the statement has no reason (The lamp of 6411h blinks.)"));
    EXPECT_EQ(status()["M:6411h/1"], "open");
}

TEST_F(AuditOfStatements, NormativeSectionWithoutStatementsIsReported) {
    statements().resize(2);
    EXPECT_THAT(gaps(), ElementsAre("M:2 (rates): the section is normative, but it has no statement"));
    EXPECT_FALSE(audits()[0].sections[1].covered);
}

TEST_F(AuditOfStatements, StatementAboutAnObjectBelongsToTheSectionOfTheObject) {
    statements().erase(statements().begin());
    EXPECT_THAT(gaps(), IsEmpty());
    const auto sections = by_section(content.manuals[0], audits()[0].statements);
    EXPECT_THAT(sections.at("1"), ElementsAre(0U));
    EXPECT_THAT(sections.at("2"), ElementsAre(1U, 2U));
}

TEST_F(AuditOfStatements, SectionWhoseStatementsAreCoveredNeedsNoItemThatNamesIt) {
    // No item has section 2 as its source. The section has two statements: a decision covers one, and the other has a
    // reason why no item covers it.
    EXPECT_THAT(audits()[0].sections[1].covered_by, IsEmpty());
    EXPECT_TRUE(audits()[0].sections[1].covered);
}

TEST_F(AuditOfStatements, ManualWithoutStatementsIsAuditedBySection) {
    statements().clear();
    EXPECT_THAT(gaps(), ElementsAre("M:2 (rates): the section is normative, but no item names it as its source"));
}

TEST_F(AuditOfStatements, StatementHasTheStateOfItsWeakestItem) {
    evidence.verdicts["D-A-002"][0].passed = false;
    EXPECT_EQ(status()["M:1/1"], "shown");
    EXPECT_EQ(status()["M:6411h/1"], "failed");
    EXPECT_EQ(status()["M:2/1"], "failed") << "the decision affects D-A-002";
    evidence.verdicts.erase("D-A-002");
    EXPECT_EQ(status()["M:6411h/1"], "open");
    EXPECT_THAT(gaps(), ElementsAre("D-A-002: there is no passed test"));
}

TEST_F(AuditOfStatements, EditedItemMakesItsStatementSuspect) {
    content.parts[0].requirements[1].text = "It blinks twice.";
    EXPECT_EQ(status()["M:6411h/1"], "suspect");
    EXPECT_EQ(count_statements(audits()[0])["suspect"], 2U);
    EXPECT_EQ(count_statements(audits()[0])["shown"], 1U);
}

TEST_F(AuditOfStatements, StatementCoveredByASharedRequirementOfCanproofCountsAsVerified) {
    Part shared;
    shared.name = "canopen";
    shared.inherited = true;
    shared.requirements = {requirement("CO-A-001")};
    content.parts.insert(content.parts.begin(), shared);
    statements()[0].covered = {"CO-A-001"};
    EXPECT_EQ(audits().size(), 1U);
    EXPECT_EQ(status()["M:1/1"], "shown");
    EXPECT_THAT(story("M:1/1")->text,
                HasSubstr("CO-A-001               shared item of canproof; canproof's own audit shows its status"));
}

TEST_F(AuditOfStatements, TraceReportOfAStatementShowsItsSectionPassageAndItems) {
    const auto told = story("M:6411h/1");
    ASSERT_TRUE(told.has_value());
    EXPECT_FALSE(told->open);
    for (const char* said :
         {"M:6411h/1 (statement, ", "The lamp of 6411h blinks.", "section      1 lamps", "passage      21:00000000000a",
          "  D-A-001 ", "passed S.TD-A-001 tests/a_test.cpp", "  D-A-002 ", "verdict      shown"}) {
        EXPECT_THAT(told->text, HasSubstr(said));
    }
    EXPECT_THAT(story("M:2/1")->text, HasSubstr("decision    the first"));
    EXPECT_THAT(story("M:2/2")->text, HasSubstr("not covered  repeats M:1/1"));
    statements()[1].covered.clear();
    EXPECT_TRUE(story("M:6411h/1")->open);
    EXPECT_THAT(story("M:6411h/1")->text, HasSubstr("nothing, and there is no reason"));
    EXPECT_FALSE(story("M:6411h/2").has_value());
}

TEST_F(AuditOfStatements, TraceReportOfASectionHasItsStatements) {
    const auto told = story("M:1");
    EXPECT_FALSE(told->open);
    EXPECT_THAT(told->text, HasSubstr("  M:1/1 "));
    EXPECT_THAT(told->text, HasSubstr("  M:6411h/1 "));
    EXPECT_THAT(told->text, Not(HasSubstr("  M:2/1 ")));
    statements()[1].covered.clear();
    EXPECT_TRUE(story("M:1")->open);
    statements().resize(1);
    EXPECT_TRUE(story("M:2")->open) << "a normative section without a statement";
}

TEST_F(AuditOfStatements, StatementsAreFilteredBySectionKindAndStatus) {
    statements()[1].covered.clear();
    const auto all = audits();
    const auto taken = [&](const AuditFilter& filter) {
        std::string ids;
        for (const auto& one : all[0].statements) {
            ids += passes(one, content.manuals[0], filter) ? one.id + " " : "";
        }
        return ids;
    };
    EXPECT_EQ(taken({"M:1", "", ""}), "M:1/1 M:6411h/1 ");
    EXPECT_EQ(taken({"M:6411h", "", ""}), "M:6411h/1 ");
    EXPECT_EQ(taken({"M:", "", ""}), "M:1/1 M:6411h/1 M:2/1 M:2/2 ");
    EXPECT_EQ(taken({"", "statement", "open"}), "M:6411h/1 ");
    EXPECT_EQ(taken({"", "", "explained"}), "M:2/2 ");
    EXPECT_EQ(taken({"", "functional", ""}), "");
    EXPECT_EQ(resolved({"", "statement", ""}, content, all).kind, "statement");
    statements().clear();
    EXPECT_THROW(resolved({"", "statement", ""}, content, audits()), InputError);
}

TEST_F(AuditOfStatements, JsonOfTheAuditHasTheStatements) {
    statements()[1].covered.clear();
    const auto whole = nlohmann::json::parse(write_audit_json(content, audits(), {}, {{"orphans", {"a stray"}}}));
    const auto& part = whole.at("parts").at(0);
    EXPECT_EQ(part.at("counts_by"), "statement");
    EXPECT_EQ(part.at("items").size(), 2U);
    EXPECT_EQ(part.at("items").at(0).at("implemented_by"), "D-A-001");
    EXPECT_EQ(part.at("statements").size(), 4U);
    EXPECT_EQ(part.at("statements").at(0).at("covered").at(0), "D-A-001");
    EXPECT_EQ(part.at("statements").at(1).at("status"), "open");
    EXPECT_EQ(part.at("statements").at(3).at("reason"), "repeats M:1/1");
    EXPECT_EQ(part.at("gaps").size(), 1U);
    EXPECT_EQ(whole.at("orphans").at(0), "a stray");
    const auto listed = nlohmann::json::parse(write_audit_json(content, audits(), {"", "", "open"}, {}));
    EXPECT_EQ(listed.at("parts").at(0).at("items").size(), 0U);
    EXPECT_EQ(listed.at("parts").at(0).at("statements").size(), 1U);
    statements().clear();
    EXPECT_EQ(nlohmann::json::parse(write_audit_json(content, audits(), {}, {})).at("parts").at(0).at("counts_by"),
              "section");
}

}  // namespace canproof::host::test
