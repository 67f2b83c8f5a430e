// The report of a conformance run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "host/conform/report/report_files.hpp"
#include "host/conform/report/report_records.hpp"
#include "tests/host/conform/conform_bench.hpp"

namespace canproof::host::conform::test {

namespace {

using testing::HasSubstr;
using testing::Not;

ConformReport some_report() {
    VirtualTarget target{sound_slave(), 5};
    return run_on(target, case_text("good", "read 1000:00") +
                              case_text("bad", "read 1000:00 fails any", "public = [\"2.1\"]") +
                              case_text("left-out", "read 1000:00", "needs = [\"5555\"]"));
}

TEST(ConformReportFiles, ReportsAreTheSameForTheSameRun) {
    EXPECT_EQ(report_files(some_report()), report_files(some_report()));
}

TEST(ConformReportFiles, ReportShowsEachFailedCaseWithItsFrames) {
    const auto files = report_files(some_report());
    const std::string page = files.at("case-bad.html");
    EXPECT_THAT(page, HasSubstr("CiA 301 7.2.4.3"));
    EXPECT_THAT(page, HasSubstr("can0 605#4000100000000000 tester"));
    EXPECT_THAT(page, HasSubstr("can0 585#43001000"));
    EXPECT_THAT(page, HasSubstr("1000h:00 was taken; it must be refused"));
    EXPECT_EQ(files.count("case-good.html"), 0U);
    EXPECT_THAT(files.at("sdo.html"), HasSubstr("no object 5555h"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("case-bad.html"));
    EXPECT_THAT(files.at("report.txt"), HasSubstr("1 passed, 1 failed, 1 skipped"));
}

TEST(ConformReportFiles, JunitCountsTheVerdicts) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(write_junit_xml(some_report()).c_str()));
    const auto suite = document.child("testsuites").child("testsuite");
    EXPECT_STREQ(suite.attribute("name").value(), "sdo");
    EXPECT_STREQ(suite.attribute("tests").value(), "3");
    EXPECT_STREQ(suite.attribute("failures").value(), "1");
    EXPECT_STREQ(suite.attribute("skipped").value(), "1");
    const auto failed = suite.find_child_by_attribute("name", "bad");
    EXPECT_THAT(failed.child("failure").attribute("message").value(), HasSubstr("must be refused"));
}

TEST(ConformReportFiles, JsonHasVerdictsAndTimes) {
    const auto json = nlohmann::json::parse(write_json(some_report()));
    EXPECT_EQ(json["counts"]["passed"], 1);
    EXPECT_EQ(json["exit_status"], 1);
    EXPECT_EQ(json["cases"][1]["public"][0], "2.1");
    EXPECT_EQ(json["cases"][0]["times"]["SDO answer"]["count"], 1);
    EXPECT_EQ(json["sheet_sha256"].get<std::string>().size(), 64U);
}

TEST(ConformSpread, SpreadIsSmallestMeanAndLargest) {
    const Spread spread = spread_of({10, 40, 25});
    EXPECT_EQ(spread.smallest, 10U);
    EXPECT_EQ(spread.mean, 25U);
    EXPECT_EQ(spread.largest, 40U);
    EXPECT_EQ(spread_of({}).count, 0U);
}

}  // namespace

}  // namespace canproof::host::conform::test
