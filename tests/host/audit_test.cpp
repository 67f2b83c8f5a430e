// The audit sees what is missing: a small register and evidence made by hand.
#include "host/trace/audit.hpp"

#include <gtest/gtest.h>

namespace canproof::host {

namespace {

class AuditOfASmallRegister : public testing::Test {
  protected:
    AuditOfASmallRegister() {
        Manual manual;
        manual.key = "M";
        manual.sections = {{"1", "rules", true, "", {"6411h"}, {}},
                           {"2", "more", true, "", {}, {}},
                           {"3", "cables", false, "wiring", {}, {}}};
        content.manuals = {manual};
        Part part;
        part.name = "device";
        part.info.manual = "M";
        Requirement first;
        first.id = "D-A-001";
        first.sources = {"M:1"};
        first.verify = {"test", "property"};
        Requirement second;
        second.id = "D-A-002";
        second.sources = {"M:2"};
        second.verify = {"test"};
        part.requirements = {first, second};
        content.parts = {part};
        evidence.verdicts["D-A-001"] = {{"S.One", "test", true}, {"S.Law", "property", true}};
        evidence.verdicts["D-A-002"] = {{"S.Two", "test", true}};
    }
    std::vector<std::string> gaps() { return audit_part(content, content.parts[0], evidence).gaps; }

    Register content;
    Evidence evidence;
};

}  // namespace

TEST_F(AuditOfASmallRegister, WithoutGapsIsSilent) {
    EXPECT_TRUE(gaps().empty());
}

TEST_F(AuditOfASmallRegister, AMissingKindIsAGap) {
    evidence.verdicts["D-A-001"].pop_back();
    EXPECT_EQ(gaps(), (std::vector<std::string>{"D-A-001: no passed property"}));
}

TEST_F(AuditOfASmallRegister, ARequirementWithoutATestIsAGap) {
    evidence.verdicts.erase("D-A-002");
    EXPECT_EQ(gaps(), (std::vector<std::string>{"D-A-002: no passed test"}));
}

TEST_F(AuditOfASmallRegister, AFailedTestIsAGapEvenBesideAPassedOne) {
    evidence.verdicts["D-A-002"].push_back({"S.Three", "test", false});
    EXPECT_EQ(gaps(), (std::vector<std::string>{"D-A-002: a test that claims it has failed"}));
}

TEST_F(AuditOfASmallRegister, ANormativeSectionWithoutRequirementIsAGap) {
    content.parts[0].requirements[1].sources = {"M:1"};
    EXPECT_EQ(gaps(), (std::vector<std::string>{"M:2 (more): normative, and nothing has it as its source"}));
}

TEST_F(AuditOfASmallRegister, ASectionIsCoveredThroughItsObjectToo) {
    content.parts[0].requirements[0].sources = {"M:6411h"};
    EXPECT_TRUE(gaps().empty());
}

TEST_F(AuditOfASmallRegister, ARetiredRequirementDemandsNothing) {
    content.parts[0].requirements[1].retired = "merged";
    evidence.verdicts.erase("D-A-002");
    EXPECT_TRUE(gaps().empty());
}

}  // namespace canproof::host
