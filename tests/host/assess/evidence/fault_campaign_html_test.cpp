// SPDX-License-Identifier: Apache-2.0
// Tests the section of the evidence pack about faults injected into the processor, with invented figures.
#include "host/assess/evidence/fault_campaign_html.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "host/base/input_error.hpp"

namespace canproof::test {

namespace {

using testing::HasSubstr;
using testing::Not;

class FaultCampaignHtml : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::create_directories(folder / "faults"); }
    void TearDown() override { std::filesystem::remove_all(folder); }
    void leave(const std::string& file, const std::string& text) { std::ofstream{folder / "faults" / file} << text; }

    const std::filesystem::path folder = std::filesystem::path{testing::TempDir()} / "fault_campaign_html";
};

const char* const campaign = R"({"head": {}, "table": {"RAM": {"faults": 2000, "effective": 800, "detected": 790,
    "detected after a wrong value": 3, "longest ms": 12.5, "safe": 4, "other": 2, "silent": 4,
    "mechanisms": {"masked": 1200, "outputs": 90, "state": 700, "wrong output": 4}}}})";

}  // namespace

TEST_F(FaultCampaignHtml, WithoutCampaignFilesThePageSaysNotMeasured) {
    const std::string page = host::write_fault_campaign_html(folder);
    EXPECT_THAT(page, HasSubstr("state quiet"));
    EXPECT_THAT(page, HasSubstr("not measured"));
}

TEST_F(FaultCampaignHtml, RowHasTheFaultCountsOfOnePartOfTheProcessor) {
    leave("one.json", campaign);
    const std::string page = host::write_fault_campaign_html(folder);
    EXPECT_THAT(page, HasSubstr("1,200"));                        // masked: 2000 - 800
    EXPECT_THAT(page, HasSubstr("790: state 700, outputs 90<"));  // only detections, the most frequent first
    EXPECT_THAT(page, HasSubstr("3, at most 12.5 ms"));
    EXPECT_THAT(page, HasSubstr("4 (0.50 % of those with an effect)"));  // 4 / 800
    EXPECT_THAT(page, HasSubstr(">not measured"));                       // there is no campaign without self-tests
}

TEST_F(FaultCampaignHtml, ResultWithoutSelfTestsIsAColumnBesideTheResultWithSelfTests) {
    leave("one.json", campaign);
    leave("one-without.json", R"({"head": {}, "table": {"RAM": {"faults": 1000, "effective": 60, "silent": 15}}})");
    const std::string page = host::write_fault_campaign_html(folder);
    EXPECT_THAT(page, HasSubstr("15 of 1000 (1.50 %)"));
    EXPECT_THAT(page, Not(HasSubstr("one-without")));
}

TEST_F(FaultCampaignHtml, DamagedCampaignFileIsRefused) {
    leave("one.json", "{");
    EXPECT_THROW(host::write_fault_campaign_html(folder), host::InputError);
}

}  // namespace canproof::test
