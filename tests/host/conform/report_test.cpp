// SPDX-License-Identifier: Apache-2.0
// Tests the report files of a conformance run.
#include <fmt/format.h>
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

TEST(ConformReportFiles, ReportShowsAFailedCaseWithItsFrames) {
    const auto files = report_files(some_report());
    const std::string page = files.at("case-bad.html");
    EXPECT_THAT(page, HasSubstr("CiA 301 7.2.4.3"));
    EXPECT_THAT(page, HasSubstr("can0 605#4000100000000000 tester"));
    EXPECT_THAT(page, HasSubstr("can0 585#43001000"));
    EXPECT_THAT(page, HasSubstr("1000h:00 was accepted, but must be refused"));
    EXPECT_EQ(files.count("case-good.html"), 0U);
    EXPECT_THAT(files.at("sdo.html"), HasSubstr("no object 5555h"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("case-bad.html"));
    EXPECT_THAT(files.at("report.txt"), HasSubstr("1 passed, 1 failed, 1 skipped"));
}

TEST(ConformReportFiles, JunitReportCountsCasesByVerdict) {
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

// The case measures eleven gaps between heartbeats of 100 ms. It accepts a mean of 95 to 105 ms, and 80 to 120 ms for
// each gap.
TEST(ConformReportFiles, ReportDrawsMeasuredTimesWithTheLimitsOfTheCase) {
    VirtualTarget target{sound_slave(), 5};
    const ConformReport report =
        run_on(target, case_text("heartbeat", "write 1017:00 = 100\nperiod 700+N = 100 ms +- 5 % over 11 jitter 20 %"));
    const std::string page = report_files(report).at("sdo.html");
    EXPECT_THAT(page, HasSubstr("gap of 705h"));
    EXPECT_THAT(page, HasSubstr("mean 95.000 to 105.000, each 80.000 to 120.000"));
    EXPECT_THAT(page, HasSubstr("11 times between 80.000 ms and 120.000 ms"));
    // the plot is 240 units wide: the limits are at 0, 90, 150 and 240
    for (const char* const x : {"0.0", "90.0", "150.0", "240.0"}) {
        EXPECT_THAT(page, HasSubstr(fmt::format("<line x1=\"{0}\" x2=\"{0}\"", x)));
    }
    const auto times = nlohmann::json::parse(write_json(report))["cases"][0]["times"]["gap of 705h"];
    EXPECT_EQ(times["accepted_mean"]["least_us"], 95000.0);
    EXPECT_EQ(times["accepted_each"]["most_us"], 120000.0);
    EXPECT_EQ(times["histogram"]["from_us"], 80000.0);
    EXPECT_EQ(times["histogram"]["bin_us"], 1000.0);
    EXPECT_EQ(times["histogram"]["counts"][20], 11);  // 100 ms: the slave is exact in virtual time
}

// The background traffic loads 80 % of 125 kbit/s for two seconds.
TEST(ConformReportFiles, ReportShowsTheMeasuredBusLoad) {
    VirtualTarget target{sound_slave(), 5};
    const ConformReport report =
        run_on(target, case_text("full", "traffic 80 % high\nwait 2 s\ntraffic off\nwait 8 s\nread 1000:00"));
    ASSERT_TRUE(report.highest_load().has_value());
    EXPECT_NEAR(*report.highest_load(), 80.0, 8.0);
    EXPECT_NEAR(*report.mean_load(), 16.0, 4.0);
    EXPECT_THAT(report_files(report).at("index.html"), HasSubstr("in the busiest second; "));
    EXPECT_GT(nlohmann::json::parse(write_json(report))["bus"]["tester_frames"], 1000);
}

TEST(ConformReportFiles, ReportGivesNoBusLoadWithoutABitRate) {
    ConformReport report = some_report();
    report.bit_rate = 0;
    EXPECT_FALSE(report.mean_load().has_value());
    EXPECT_THAT(report_files(report).at("index.html"), HasSubstr("the bit rate is not known"));
    EXPECT_FALSE(nlohmann::json::parse(write_json(report))["bus"].contains("mean_load_percent"));
}

}  // namespace

}  // namespace canproof::host::conform::test
