// SPDX-License-Identifier: Apache-2.0
// Tests the page of a manual: each section with its state, our own statements with links, and no text of the manual.
#include "host/assess/evidence/manual_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/assess/evidence/csv.hpp"
#include "host/assess/evidence/own_exhibits.hpp"
#include "host/assess/trace/statement_audit.hpp"
#include "host/register/fingerprint.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;
using testing::Not;

/// A device with the items D-A-001 and D-A-002, which passed tests verify, unless a test of this file changes this.
class ManualPage : public testing::Test {
  protected:
    ManualPage() {
        Manual manual;
        manual.key = "M";
        manual.title = "Manual <of> a lamp";
        manual.sections = {{"1", "lamps & more", true, "", {"6411h"}, {}, {}},
                           {"2", "rates", true, "", {}, {}, {}},
                           {"3", "cables", false, "wiring", {}, {}, {}},
                           {"4", "place", false, "", {}, {"It stays dry."}, {}},
                           {"Table 1", "colours", true, "", {}, {}, {}}};
        add(manual, "1", {"D-A-001", "D-D-001"}, "");
        add(manual, "6411h", {"D-A-002"}, "");
        add(manual, "2", {}, "repeats M:1/1");
        add(manual, "Table 1", {"D-A-001"}, "");
        content_.manuals = {manual};
        part_.name = "lamp";
        part_.info.manual = "M";
        first_.id = "D-A-001";
        first_.sources = {"M:1"};
        second_.id = "D-A-002";
        Decision decision;
        decision.id = "D-D-001";
        part_.decisions = {decision};
        content_.parts = {part_};
        input_.content = &content_;
    }

    static void add(Manual& manual, const std::string& section, std::vector<std::string> covered,
                    const std::string& reason) {
        Statement one;
        one.section = section;
        one.number = 1;
        one.text = "A <lamp> of " + section + " blinks.";
        one.marks = {{20, "00000000000a"}};
        one.covered = std::move(covered);
        one.reason = reason;
        manual.statements.push_back(one);
    }

    Manual& manual() { return content_.manuals[0]; }

    std::string page() {
        PartAudit audit;
        audit.part = &content_.parts[0];
        AuditedItem first;
        first.item = &first_;
        AuditedItem second;
        second.item = &second_;
        second.failed = failed_;
        audit.items = {first, second};
        for (const Section& section : manual().sections) {
            if (section.normative) {
                audit.sections.push_back({&section, {}, false});
            }
        }
        input_.audits = {audit};
        audit_statements(content_, input_.audits);
        return manual_page(input_, input_.audits[0], manual());
    }
    /// Returns the HTML of the tile that shows section `ref` in the overview.
    std::string tile(const std::string& ref) {
        const std::string markup = page();
        const auto end = markup.find(" " + ref + "</a>");
        const auto begin = markup.rfind("<a class=\"tile ", end);
        return markup.substr(begin, end - begin);
    }

    Register content_;
    Part part_;
    Requirement first_;
    Requirement second_;
    PackInput input_;
    bool failed_{false};
};

}  // namespace

TEST_F(ManualPage, EachSectionIsShownWithItsState) {
    EXPECT_THAT(tile("1"), HasSubstr("\"tile proven\" href=\"#1\" title=\"lamps &amp; more: shown\">✓"));
    EXPECT_THAT(tile("2"), HasSubstr("\"tile aside\" href=\"#2\" title=\"rates: explained\">–"));
    EXPECT_THAT(tile("3"), HasSubstr("title=\"cables: informative\">·"));
    EXPECT_THAT(tile("4"), HasSubstr("title=\"place: condition of use\">§"));
    EXPECT_THAT(tile("Table 1"), HasSubstr("href=\"#Table-1\" title=\"colours: shown\">✓"));
}

TEST_F(ManualPage, SectionShowsTheReviewOfItsNormativeOrInformativeDisposition) {
    EXPECT_THAT(page(), HasSubstr("<small>never reviewed</small>"));
    const std::string id = manual().sections[0].id(manual().key);
    content_.parts[0].reviews[id] = {
        fingerprint(manual().sections[0]), "", "", "2026-01-02", "a reader", "independent", "", {}};
    EXPECT_THAT(page(), HasSubstr("<small>reviewed 2026-01-02 by a reader, not the author of the change</small>"));
    manual().sections[0].objects = {"1000h"};
    EXPECT_THAT(page(), HasSubstr("<small>changed since its review of 2026-01-02</small>"));
}

TEST_F(ManualPage, SectionWithAFailedItemIsMarked) {
    failed_ = true;
    EXPECT_THAT(tile("1"), HasSubstr("\"tile unproven\" href=\"#1\" title=\"lamps &amp; more: not shown\">◐"));
    EXPECT_THAT(tile("Table 1"), HasSubstr("shown\">✓"));
}

TEST_F(ManualPage, SectionWithAnUncoveredOrMissingStatementIsMarked) {
    manual().statements[1].covered.clear();
    EXPECT_THAT(tile("1"), HasSubstr("\"tile uncovered\" href=\"#1\" title=\"lamps &amp; more: uncovered\">✗"));
    manual().statements.pop_back();
    EXPECT_THAT(tile("Table 1"), HasSubstr("colours: uncovered\">✗"));
}

TEST_F(ManualPage, StatementsAreListedWithLinksToTheirItems) {
    const std::string markup = page();
    EXPECT_THAT(markup, HasSubstr("<li id=\"1/1\">"));
    EXPECT_THAT(markup, HasSubstr("A &lt;lamp&gt; of 1 blinks."));
    EXPECT_THAT(markup, HasSubstr("<a href=\"audit-lamp.html#D-A-001\">D-A-001</a>"));
    EXPECT_THAT(markup, HasSubstr("<a href=\"decisions.html#D-D-001\">D-D-001</a>"));
    EXPECT_THAT(markup, HasSubstr("repeats M:1/1"));
    EXPECT_THAT(markup, HasSubstr("It stays dry."));
    EXPECT_THAT(markup, HasSubstr("<b>4</b> statements: 3 shown, 1 explained by a reason, 0 suspect, 0 open"));
    EXPECT_THAT(markup, Not(HasSubstr("<of>")));
    EXPECT_EQ(manual_page_name(part_), "manual-lamp.html");
}

TEST_F(ManualPage, ManualWithoutStatementsShowsTheStateOfEachSection) {
    manual().statements.clear();
    EXPECT_THAT(tile("2"), HasSubstr("rates: uncovered"));
    content_.parts[0].requirements = {first_};
    EXPECT_THAT(tile("1"), HasSubstr("lamps &amp; more: shown"));
    EXPECT_THAT(page(), HasSubstr("The register has no statements of this manual"));
}

TEST_F(ManualPage, ClaimThatAllManualStatementsAreCoveredIsOpenWhileOneIsNot) {
    page();
    const Exhibit holds = exhibits_of(input_).at("statements");
    EXPECT_EQ(holds.state, Exhibit::State::holds);
    EXPECT_EQ(holds.says,
              "4 normative statements, 0 of them with neither an item nor a reason; 3 shown, 1 explained by a reason, "
              "0 with an "
              "item that is not shown");
    manual().statements[1].covered.clear();
    page();
    EXPECT_EQ(exhibits_of(input_).at("statements").state, Exhibit::State::open);
    EXPECT_THAT(exhibits_of(input_).at("statements").says, HasSubstr("1 of them with neither an item nor a reason"));
}

TEST_F(ManualPage, ClaimThatAllManualStatementsAreCoveredIsAbsentWithoutStatements) {
    manual().statements.clear();
    page();
    EXPECT_EQ(exhibits_of(input_).count("statements"), 0U);
}

TEST_F(ManualPage, StatementsAreExportedAsCsv) {
    page();
    EXPECT_THAT(write_statements_csv(input_.audits),
                HasSubstr("\r\nM:1/1,lamp,A <lamp> of 1 blinks.,20:00000000000a,D-A-001; D-D-001,,shown\r\n"));
}

}  // namespace canproof::host::test
