// SPDX-License-Identifier: Apache-2.0
// Tests that the audit detects each thing that is missing, with a small register and hand-made evidence.
#include "host/assess/trace/audit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>

#include "host/assess/story/story.hpp"
#include "host/assess/trace/audit_filter.hpp"
#include "host/base/input_error.hpp"
#include "host/register/fingerprint.hpp"

namespace canproof::host {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Requirement requirement(const std::string& id, const std::string& source, std::vector<std::string> verify) {
    Requirement one;
    one.id = id;
    one.text = "It does what " + source + " says.";
    one.sources = {source};
    one.kind = "functional";
    one.verify = std::move(verify);
    return one;
}

/// Reviews all items of the device and all sections of its manual, as `canproof spec review` records it.
void review(Part& part, const Manual& manual) {
    part.reviews.clear();
    for (const auto& prints : {fingerprints(part), fingerprints(manual)}) {
        for (const auto& [id, print] : prints) {
            part.reviews[id] = {print, "", "", "2026-01-02", "someone", "author", "", {}};
        }
    }
}

class AuditOfASmallRegister : public testing::Test {
  protected:
    AuditOfASmallRegister() {
        Manual manual;
        manual.key = "M";
        manual.sections = {{"1", "rules", true, "", {"6411h"}, {}, {}},
                           {"2", "more", true, "", {}, {}, {}},
                           {"3", "cables", false, "wiring", {}, {}, {}}};
        content.manuals = {manual};
        Part part;
        part.name = "device";
        part.info.manual = "M";
        part.requirements = {requirement("D-A-001", "M:1", {"test", "property"}),
                             requirement("D-A-002", "M:2", {"test"})};
        Decision decision;
        decision.id = "D-D-001";
        decision.chosen = "the first";
        decision.affects = {"D-A-002"};
        part.decisions = {decision};
        review(part, content.manuals[0]);
        content.parts = {part};
        evidence.verdicts["D-A-001"] = {{"S.One", "test", true}, {"S.Law", "property", true}};
        evidence.verdicts["D-A-002"] = {{"S.Two", "test", true, 0.0, "tests/devices/two_test.cpp"}};
        evidence.implemented = {{"D-A-001", {"src/firmware/a.cpp:3"}}, {"D-A-002", {"src/firmware/b.cpp:4"}}};
        evidence.runs = {{"S.Two", "tests/devices/two_test.cpp", true, true}};
    }
    Part& part() { return content.parts[0]; }
    PartAudit audit() { return audit_part(content, part(), evidence); }
    std::vector<std::string> gaps() { return audit().gaps; }
    std::optional<Story> story(const std::string& subject) {
        const auto audits = audit_all(content, evidence);
        return StoryTeller{content, audits, evidence, mutations}.tell(subject);
    }

    Register content;
    Evidence evidence;
    CountsByItem mutations;
};

}  // namespace

TEST_F(AuditOfASmallRegister, AuditWithoutGapsReportsNothing) {
    EXPECT_THAT(gaps(), IsEmpty());
    EXPECT_THAT(audit().suspects, IsEmpty());
    EXPECT_THAT(orphans(evidence), IsEmpty());
    EXPECT_EQ(audit().items[0].status(), "shown");
}

TEST_F(AuditOfASmallRegister, TraceReportOfADecisionContainsItsTopicChoiceAndReason) {
    EXPECT_THAT(story("D-D-001")->text, Not(HasSubstr("topic")));
    part().decisions[0].answer = {"heartbeat.range", "any", "its manual says so", "section 1 says so", {}};
    const std::string text = story("D-D-001")->text;
    for (const char* told : {"heartbeat.range: any", "its manual says so", "section 1 says so"}) {
        EXPECT_THAT(text, HasSubstr(told));
    }
}

TEST_F(AuditOfASmallRegister, RequirementWithoutOneOfItsRequiredKindsOfTestIsAGap) {
    evidence.verdicts["D-A-001"].pop_back();
    EXPECT_THAT(gaps(), ElementsAre("D-A-001: there is no passed property"));
}

TEST_F(AuditOfASmallRegister, RequirementWithoutATestIsAGap) {
    evidence.verdicts.erase("D-A-002");
    EXPECT_THAT(gaps(), ElementsAre("D-A-002: there is no passed test"));
    EXPECT_EQ(audit().items[1].status(), "open");
}

TEST_F(AuditOfASmallRegister, FailedTestIsAGapDespiteAPassedTest) {
    evidence.verdicts["D-A-002"].push_back({"S.Three", "test", false});
    EXPECT_THAT(gaps(), ElementsAre("D-A-002: a test that verifies this item has failed"));
    EXPECT_EQ(audit().items[1].status(), "failed");
}

TEST_F(AuditOfASmallRegister, RequirementWithoutCodeIsAGap) {
    evidence.implemented.erase("D-A-002");
    EXPECT_THAT(gaps(), ElementsAre("D-A-002: no code implements this item"));
    part().requirements[1].verify = {"inspection"};
    evidence.verdicts["D-A-002"] = {{"S.Two", "inspection", true}};
    EXPECT_THAT(gaps(), IsEmpty()) << "what is read needs no code";
}

TEST_F(AuditOfASmallRegister, DeviceRequirementMayBeImplementedByTheCodeOfASharedRequirement) {
    part().requirements[1].by = "CO-A-001";
    evidence.implemented_by = {{"D-A-002", "CO-A-001"}};
    review(part(), content.manuals[0]);
    EXPECT_THAT(gaps(), ElementsAre("D-A-002: no code implements CO-A-001"));
    evidence.implemented["CO-A-001"] = {"src/firmware/canopen/a.cpp:3"};
    evidence.implemented.erase("D-A-002");
    EXPECT_THAT(gaps(), IsEmpty());
    EXPECT_THAT(story("D-A-002")->text, HasSubstr("CO-A-001"));
    EXPECT_THAT(story("D-A-002")->text, HasSubstr("code         src/firmware/canopen/a.cpp:3\n"));
    EXPECT_THAT(story("D-A-001")->text, Not(HasSubstr("CO-A-001")));
    EXPECT_THAT(story("src/firmware/canopen/a.cpp")->text, HasSubstr("D-A-002"));
}

TEST_F(AuditOfASmallRegister, NamingTheImplementingRequirementDoesNotMakeAReviewExpire) {
    part().requirements[1].by = "CO-A-001";
    EXPECT_THAT(audit().suspects, IsEmpty());
}

TEST_F(AuditOfASmallRegister, LinkWithoutCodeBelowItIsListedAmongTheOrphans) {
    evidence.misplaced = {"src/firmware/a.cpp:3: no code follows that can implement the item"};
    EXPECT_THAT(orphans(evidence), ElementsAre(HasSubstr("a.cpp:3: no code follows that can implement the item")));
}

TEST_F(AuditOfASmallRegister, NormativeSectionWithoutRequirementIsAGap) {
    part().requirements[1].sources = {"M:1"};
    EXPECT_THAT(gaps(), ElementsAre("M:2 (more): the section is normative, but no item names it as its source"));
}

TEST_F(AuditOfASmallRegister, SectionIsCoveredByARequirementOfItsObject) {
    part().requirements[0].sources = {"M:6411h"};
    EXPECT_THAT(gaps(), IsEmpty());
}

TEST_F(AuditOfASmallRegister, RetiredRequirementNeedsNoTest) {
    part().requirements[1].retired = "merged";
    evidence.verdicts.erase("D-A-002");
    EXPECT_THAT(gaps(), IsEmpty());
}

TEST_F(AuditOfASmallRegister, EditedRequirementIsSuspectUntilItIsReviewedAgain) {
    part().requirements[0].text = "It does something else.";
    EXPECT_THAT(audit().suspects, ElementsAre("D-A-001: changed since its review of 2026-01-02"));
    EXPECT_EQ(audit().items[0].status(), "suspect");
    review(part(), content.manuals[0]);
    EXPECT_THAT(audit().suspects, IsEmpty());
}

TEST_F(AuditOfASmallRegister, ItemsAffectedByAnEditedDecisionAreSuspect) {
    part().decisions[0].chosen = "the second";
    EXPECT_THAT(audit().suspects,
                ElementsAre("D-A-002: D-D-001, which affects this item, changed since its review of 2026-01-02"));
}

TEST_F(AuditOfASmallRegister, UnreviewedItemIsSuspect) {
    part().reviews.erase("D-A-001");
    EXPECT_THAT(audit().suspects, ElementsAre("D-A-001: never reviewed"));
}

TEST_F(AuditOfASmallRegister, UnreviewedOrChangedHazardIsSuspect) {
    Hazard hazard;
    hazard.id = "D-H-001";
    hazard.safe_state = "off";
    part().hazards = {hazard};
    EXPECT_THAT(audit().suspects, ElementsAre("D-H-001: never reviewed"));
    review(part(), content.manuals[0]);
    EXPECT_THAT(audit().suspects, IsEmpty());
    part().hazards[0].safe_state = "on";
    EXPECT_THAT(audit().suspects, ElementsAre("D-H-001: changed since its review of 2026-01-02"));
}

TEST_F(AuditOfASmallRegister, UnreviewedOrChangedNormativeOrInformativeDispositionIsSuspect) {
    part().reviews.erase("M:1");
    content.manuals[0].sections[2].reason = "a drawing of the cables";
    EXPECT_THAT(audit().suspects, ElementsAre("M:1 (rules): its disposition: never reviewed",
                                              "M:3 (cables): its disposition: changed since its review of 2026-01-02"));
}

TEST_F(AuditOfASmallRegister, FirmwareTestWithoutARequirementIsAnOrphan) {
    evidence.runs.push_back({"S.Stray", "tests/firmware/stray_test.cpp", true, false});
    evidence.runs.push_back({"Bus.Tool", "tests/host/bus/tool_test.cpp", true, false});
    evidence.untraced = {"src/firmware/stray.hpp"};
    EXPECT_THAT(orphans(evidence),
                ElementsAre(HasSubstr("src/firmware/stray.hpp"),
                            "S.Stray (tests/firmware/stray_test.cpp): the test verifies no requirement"));
}

TEST_F(AuditOfASmallRegister, TestPropertyOrCorpusOfADeviceWithoutARequirementIsAnOrphan) {
    evidence.runs = {{"S.A", "tests/devices/ax130751/ramp_test.cpp", true, false},
                     {"S.B", "properties/devices/ax130751/ramp_property.cpp", true, false},
                     {"S.C", "fuzz/devices/ax130751/ax130751_fuzz.cpp", true, false},
                     {"S.D", "properties/host/candump_property.cpp", true, false},
                     {"S.E", "tests/devices/ax130751/other_test.cpp", true, true}};
    EXPECT_THAT(orphans(evidence), ElementsAre(HasSubstr("S.A"), HasSubstr("S.B"), HasSubstr("S.C")));
}

TEST_F(AuditOfASmallRegister, FilterBySectionIncludesItsSubsections) {
    part().requirements[1].sources = {"M:2.1 Table 7"};
    const PartAudit all = audit();
    const auto takes = [&](const AuditFilter& filter) { return passes(all.items[1], filter); };
    EXPECT_TRUE(takes({"M:2", "", ""}));
    EXPECT_TRUE(takes({"M:Table 7", "", ""}));
    EXPECT_FALSE(takes({"M:1", "", ""}));
    EXPECT_FALSE(takes({"M:2.10", "", ""}));
    EXPECT_TRUE(takes({"", "functional", "shown"}));
    EXPECT_TRUE(takes({"", "requirement", ""}));
    EXPECT_FALSE(takes({"", "timing", ""}));
    EXPECT_FALSE(takes({"", "", "open"}));
}

TEST_F(AuditOfASmallRegister, SectionFilterWithoutAManualNameUsesTheManualOfTheDevice) {
    const std::vector<PartAudit> all{audit()};
    EXPECT_EQ(resolved({"2", "functional", ""}, content, all).section, "M:2");
    EXPECT_EQ(resolved({"M:2", "", ""}, content, all).section, "M:2");
    EXPECT_EQ(resolved({"M:Table 7", "requirement", ""}, content, all).section, "M:Table 7");
}

TEST_F(AuditOfASmallRegister, FilterRefusesUnknownSectionsManualsAndKinds) {
    const std::vector<PartAudit> all{audit()};
    const auto refusal = [&](const AuditFilter& filter) -> std::string {
        try {
            resolved(filter, content, all);
        } catch (const InputError& error) {
            return error.what();
        }
        return "taken";
    };
    EXPECT_EQ(refusal({"9.9", "", ""}),
              "no manual has a section 9.9; `canproof spec statements KEY` lists the sections of a manual");
    EXPECT_EQ(refusal({"M:9.9", "", ""}),
              "the manual M has no section 9.9; `canproof spec statements M` lists its sections");
    EXPECT_EQ(refusal({"X:1", "", ""}), "no manual has the key X; the keys are M");
    EXPECT_THAT(refusal({"", "timings", ""}),
                HasSubstr("no item is of the kind `timings`; the kinds are functional, "));
}

TEST_F(AuditOfASmallRegister, TraceReportOfAnItemGoesFromItsManualSectionToItsMutants) {
    mutations["D-A-002"] = {12, 10, 2};
    const auto told = story("D-A-002");
    ASSERT_TRUE(told.has_value());
    EXPECT_FALSE(told->open);
    for (const char* part_of_it :
         {"M:2: more", "D-D-001: the first", "src/firmware/b.cpp:4", "passed S.Two",
          "10 of 12 noticed, 2 with a reason", "2026-01-02 by someone", "verdict      shown"}) {
        EXPECT_THAT(told->text, HasSubstr(part_of_it));
    }
}

TEST_F(AuditOfASmallRegister, TraceReportFindsAnItemByItsSectionDecisionCodeOrTest) {
    for (const char* subject : {"M:2", "D-D-001", "src/firmware/b.cpp", "S.Two", "tests/devices/two_test.cpp"}) {
        const auto told = story(subject);
        ASSERT_TRUE(told.has_value()) << subject;
        EXPECT_THAT(told->text, HasSubstr("  D-A-002 ")) << subject;
        EXPECT_THAT(told->text, Not(HasSubstr("  D-A-001 "))) << subject;
    }
    EXPECT_FALSE(story("S.Nobody").has_value());
}

TEST_F(AuditOfASmallRegister, TraceReportOfAnItemWithoutAPassedTestIsMarkedOpen) {
    evidence.verdicts.erase("D-A-002");
    EXPECT_TRUE(story("M:2")->open);
    EXPECT_FALSE(story("M:1")->open);
}

namespace {

/// Returns the CPU seconds of the quickest of three audits of `count` requirements in a tenth as many sections.
double cost_of(std::size_t count) {
    Register content;
    Evidence evidence;
    Manual manual;
    manual.key = "M";
    Part part;
    part.name = "device";
    part.info.manual = "M";
    for (std::size_t i = 0; i < count; ++i) {
        const std::string section = std::to_string(i / 10);
        const std::string id = "D-A-" + std::to_string(i);
        part.requirements.push_back(requirement(id, "M:" + section + " Table 1", {"test"}));
        if (i % 10 == 0) {
            manual.sections.push_back({section, "section", true, "", {}, {}, {}});
        }
        evidence.verdicts[id] = {{"S.T" + id, "test", true}};
        evidence.implemented[id] = {"src/firmware/a.cpp:1"};
    }
    review(part, manual);
    content.manuals = {manual};
    content.parts = {part};
    double least = 1.0e9;
    for (int i = 0; i < 3; ++i) {
        const std::clock_t start = std::clock();
        EXPECT_THAT(audit_all(content, evidence).at(0).gaps, IsEmpty());
        least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return least;
}

}  // namespace

TEST(AuditOfALargeRegister, AuditCostGrowsLessThanQuadraticallyWithTheRegister) {
    // Ten times the requirements and sections take ten times the work; the limit allows 25 times. An audit that
    // compares each section with each item would take a hundred times as much.
    EXPECT_LT(cost_of(5000), 25.0 * cost_of(500));
}

}  // namespace canproof::host
