// SPDX-License-Identifier: Apache-2.0
// Tests the page of hazards: each failure with the requirement that prevents it and whether passed tests verify this
// requirement, or with the reason why nothing prevents the failure.
#include "host/assess/evidence/hazards_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/register/fingerprint.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;
using testing::Not;

class HazardsPage : public testing::Test {
  protected:
    HazardsPage() {
        requirement_.id = "D-R-1";
        Hazard hazard;
        hazard.id = "D-H-1";
        hazard.text = "The output is on.";
        hazard.safe_state = "OFF";
        hazard.decisions = {"D-D-1"};
        hazard.failures = {{"The bus is lost.", {"D-R-1"}, "", {}}, {"The <driver> fails.", {}, "Not measured.", {}}};
        part_.name = "device";
        part_.info.title = "Device 1";
        part_.hazards = {hazard};
        Decision decision;
        decision.id = "D-D-1";
        part_.decisions = {decision};
        AuditedItem item;
        item.item = &requirement_;
        PartAudit audit;
        audit.part = &part_;
        audit.items = {item};
        input_.audits = {audit};
        content_.parts = {part_};
        input_.content = &content_;
    }

    Requirement requirement_;
    Part part_;
    Register content_;
    PackInput input_;
};

}  // namespace

TEST_F(HazardsPage, HazardShowsItsReviewOnce) {
    EXPECT_THAT(hazards_page(input_), HasSubstr("<small>never reviewed</small>"));
    part_.reviews["D-H-1"] = {fingerprint(part_.hazards[0]), "", "", "2026-01-02", "a reader", "independent", "", {}};
    content_.parts = {part_};
    const std::string page = hazards_page(input_);
    const std::string note = "<small>reviewed 2026-01-02 by a reader, not the author of the change</small>";
    EXPECT_THAT(page, HasSubstr(note));
    EXPECT_EQ(page.find(note), page.rfind(note));
}

TEST_F(HazardsPage, PageShowsForEachFailureItsRequirementOrTheReasonWhyItIsNotPrevented) {
    const std::string page = hazards_page(input_);
    EXPECT_THAT(page, HasSubstr("<h2>Device 1</h2>"));
    EXPECT_THAT(page, HasSubstr("<h3 id=\"D-H-1\"><code>D-H-1</code> The output is on.</h3></summary>\n"
                                "<p>Safe state: OFF</p>\n"));
    EXPECT_THAT(page, HasSubstr("<caption>Failures of D-H-1</caption>"));
    EXPECT_THAT(page, HasSubstr("<a href=\"audit-device.html#D-R-1\">D-R-1</a>"));
    EXPECT_THAT(page, HasSubstr("<a href=\"decisions.html#D-D-1\">D-D-1</a>"));
    EXPECT_THAT(page, HasSubstr("The &lt;driver&gt; fails."));
    EXPECT_THAT(page, HasSubstr("Not measured."));
    EXPECT_THAT(page, HasSubstr("not prevented"));
}

TEST_F(HazardsPage, FailuresAreCountedByTheStateOfTheirRequirements) {
    FailureCounts counts = count_failures(input_);
    EXPECT_EQ(counts.hazards, 1U);
    EXPECT_EQ(counts.failures, 2U);
    EXPECT_EQ(counts.unprevented, 1U);
    EXPECT_EQ(counts.open, 0U);
    input_.audits[0].items[0].failed = true;
    counts = count_failures(input_);
    EXPECT_EQ(counts.open, 1U);
    EXPECT_THAT(hazards_page(input_), HasSubstr("open"));
}

TEST_F(HazardsPage, DeviceWithoutHazardsIsLeftOut) {
    part_.hazards.clear();
    EXPECT_THAT(hazards_page(input_), Not(HasSubstr("Device 1")));
}

}  // namespace canproof::host::test
