// SPDX-License-Identifier: Apache-2.0
// Tests coverage, from the export of llvm-cov to gaps (code that no test reaches), their recorded reasons, and
// Cobertura (host/assess/coverage). The source below is small enough to count by hand.
#include "host/assess/coverage/coverage.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <pugixml.hpp>

#include "host/assess/coverage/cobertura.hpp"
#include "host/assess/coverage/coverage_records.hpp"
#include "host/assess/coverage/read_coverage.hpp"
#include "host/assess/coverage/stale_records.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host::test {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Lines 1 to 12. `run` is called with a = true, b = false, never with a = false; `idle` is never called.
const char* const source =
    "int run(bool a, bool b) {\n"
    "    if (a && b) {\n"
    "        return 1;\n"
    "    }\n"
    "    if (a) {\n"
    "        return 2;\n"
    "    }\n"
    "    return 3;\n"
    "}\n"
    "int idle() {\n"
    "    return 4;\n"
    "}\n";

const char* const measured = R"({"version": "2.0.1", "data": [{
 "files": [{"filename": "/elsewhere/src/firmware/base/one.cpp",
  "segments": [[1,25,1,true,true,false],[2,9,1,true,true,false],[2,15,1,true,false,false],[2,17,0,true,true,false],
               [4,6,1,true,false,false],[5,9,1,true,true,false],[5,10,1,true,false,false],[5,12,1,true,true,false],
               [7,6,0,true,false,false],[8,5,0,true,true,false],[9,2,0,false,false,false],[10,12,0,true,true,false],
               [12,2,0,false,false,false]],
  "branches": [[2,9,2,10,1,0,0,0,4],[2,14,2,15,0,1,0,0,4],[5,9,5,10,1,0,0,0,4]],
  "mcdc_records": [[2,9,2,15,0,5,[false,false]]],
  "expansions": [], "summary": {}},
  {"filename": "/elsewhere/tests/two.cpp", "segments": [], "branches": [], "mcdc_records": []}],
 "functions": [
  {"name": "_ZN8canproof3runEbb", "count": 1, "filenames": ["/elsewhere/src/firmware/base/one.cpp"],
   "regions": [[1,25,9,2,1,0,0,0]], "branches": [], "mcdc_records": []},
  {"name": "one.cpp:_ZN8canproof12_GLOBAL__N_14idleEv", "count": 0,
   "filenames": ["/elsewhere/src/firmware/base/one.cpp"], "regions": [[10,12,12,2,0,0,0,0]], "branches": [],
   "mcdc_records": []}]}]})";

class Coverage : public ::testing::Test {
  protected:
    void SetUp() override {
        root_ = std::filesystem::path{::testing::TempDir()} /
                ("coverage" + std::string{::testing::UnitTest::GetInstance()->current_test_info()->name()});
        std::filesystem::create_directories(root_ / "src/firmware/base");
        write("src/firmware/base/one.cpp", source);
        write("measured.json", measured);
    }
    void TearDown() override { std::filesystem::remove_all(root_); }

    void write(const std::string& file, const std::string& text) { std::ofstream{root_ / file} << text; }
    std::vector<FileCoverage> read() { return read_coverage(root_ / "measured.json", root_); }

    std::string told(const std::string& file) {
        try {
            static_cast<void>(file == "records.toml" ? read_coverage_records(root_ / file).size()
                                                     : read_coverage(root_ / file, root_).size());
        } catch (const InputError& error) {
            return error.what();
        }
        return "nothing";
    }

    std::filesystem::path root_;
};

std::vector<std::string> words(const std::vector<CoverageGap>& gaps) {
    std::vector<std::string> all;
    for (const auto& gap : gaps) {
        all.push_back(std::to_string(gap.line) + " " + gap.kind + " " + gap.code + ": " + gap.missing);
    }
    return all;
}

}  // namespace

TEST_F(Coverage, UnreachedCodeIsListedWithItsText) {
    const auto files = read();
    ASSERT_THAT(files, SizeIs(1));  // only the firmware is measured
    EXPECT_EQ(files[0].file, "src/firmware/base/one.cpp");
    EXPECT_THAT(words(files[0].gaps),
                ElementsAre("2 condition a: not shown to decide alone", "2 condition b: not shown to decide alone",
                            "3 line return 1;: never run", "5 branch a: never false", "8 line return 3;: never run",
                            "10 function canproof::idle: never called"));
}

TEST_F(Coverage, CoverageOfDeviceFirmwareIsMeasuredAndThatOfItsSimulationIsNot) {
    const auto renamed = [this](const std::string& to) {
        std::string text = measured;
        const std::string from = "src/firmware/base/one.cpp";
        for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
            text.replace(at, from.size(), to);
        }
        std::filesystem::create_directories((root_ / to).parent_path());
        write(to, source);
        write("measured.json", text);
    };
    renamed("src/devices/ax130751/firmware/one.cpp");
    const auto files = read();
    ASSERT_THAT(files, SizeIs(1));
    EXPECT_EQ(files[0].file, "src/devices/ax130751/firmware/one.cpp");
    EXPECT_THAT(files[0].gaps, SizeIs(6));
    renamed("src/devices/ax130751/simulation/one.cpp");
    EXPECT_THAT(told("measured.json"), HasSubstr("measures no file of the firmware"));
}

TEST_F(Coverage, CodeOfTheHostBusesHasItsOwnCoverageTotals) {
    std::string text = measured;
    const std::string firmware = text.substr(
        text.find("{\"filename\""), text.find("  {\"filename\": \"/elsewhere/tests") - text.find("{\"filename\""));
    std::string host = firmware;
    host.replace(host.find("src/firmware/base/one.cpp"), std::string{"src/firmware/base/one.cpp"}.size(),
                 "src/host/sim/bus/one.cpp");
    text.insert(text.find(firmware), host);
    std::filesystem::create_directories(root_ / "src/host/sim/bus");
    write("src/host/sim/bus/one.cpp", source);
    write("measured.json", text);
    const auto files = read();
    ASSERT_THAT(files, SizeIs(2));
    EXPECT_FALSE(files[0].is_host());
    EXPECT_TRUE(files[1].is_host());
    EXPECT_EQ(files[1].file, "src/host/sim/bus/one.cpp");
    EXPECT_EQ(totals_of(files).conditions.total, 2U);
    EXPECT_EQ(host_totals_of(files).conditions.total, 2U);
    EXPECT_EQ(judge_coverage(files, {}).host_conditions.total, 2U);
    EXPECT_EQ(judge_coverage(files, {}).conditions.total, 2U);
    EXPECT_EQ(write_cobertura(files).find("src/host/"), std::string::npos);
    CoverageVerdict verdict;
    verdict.host_conditions = {95, 100};
    EXPECT_TRUE(verdict.holds());
    verdict.host_conditions = {94, 99};  // 94.95 %
    EXPECT_FALSE(verdict.holds());
}

TEST_F(Coverage, LinesBranchesConditionsAndFunctionsAreCounted) {
    const FileCoverage one = read().at(0);
    // All twelve lines have code. Executed: 1, 2, 5, 6, 7. Line 4 ends a block that never ran, line 9 one that never
    // ran to its end.
    EXPECT_EQ(one.line_count().total, 12U);
    EXPECT_EQ(one.line_count().covered, 5U);
    EXPECT_EQ(one.branches.total, 6U);  // three branches, two ways each
    EXPECT_EQ(one.branches.covered, 3U);
    EXPECT_EQ(one.conditions.total, 2U);
    EXPECT_EQ(one.conditions.covered, 0U);
    EXPECT_EQ(one.functions.total, 2U);
    EXPECT_EQ(one.functions.covered, 1U);
    EXPECT_DOUBLE_EQ(one.branches.percent(), 50.0);
    EXPECT_DOUBLE_EQ(CoverageCount{}.percent(), 100.0);
}

TEST_F(Coverage, CoverageGapWithARecordedReasonIsClosed_AndUnusedReasonsAreReported) {
    write("records.toml",
          "[[record]]\nfile = \"src/firmware/\"\nkind = \"branch\"\ncode = \"a\"\nreason = \"always true here\"\n"
          "[[record]]\nfile = \"src/firmware/base/two.cpp\"\nkind = \"branch\"\ncode = \"a\"\nreason = \"gone\"\n"
          "[[record]]\nfile = \"src/firmware/\"\nkind = \"line\"\ncode = \"a\"\nreason = \"of another kind\"\n");
    const auto records = read_coverage_records(root_ / "records.toml");
    const CoverageVerdict verdict = judge_coverage(read(), records);
    EXPECT_THAT(verdict.gaps, SizeIs(6));
    EXPECT_EQ(verdict.open(), 5U);
    EXPECT_EQ(verdict.gaps[3].reason, "always true here");
    ASSERT_THAT(verdict.unused, SizeIs(2));
    EXPECT_EQ(verdict.unused[0].line, 6U);
    EXPECT_EQ(verdict.unused[1].reason, "of another kind");
}

TEST_F(Coverage, CoverageGoalIs99PercentOfConditions_NoGapWithoutAReason_NoUnusedReason) {
    CoverageVerdict verdict;
    verdict.conditions = {99, 100};
    EXPECT_TRUE(verdict.holds());
    verdict.conditions = {98, 99};  // 98.99 %
    EXPECT_FALSE(verdict.enough_conditions());
    EXPECT_FALSE(verdict.holds());
    verdict.conditions = {200, 200};
    verdict.gaps.push_back({{"branch", "a.cpp", 1, "a", "never true"}, "cannot be"});
    EXPECT_TRUE(verdict.holds());
    verdict.gaps.push_back({{"branch", "a.cpp", 2, "b", "never true"}, ""});
    EXPECT_FALSE(verdict.holds());
    verdict.gaps.clear();
    verdict.unused.push_back({"a.cpp", "branch", "a", "cannot be", 1});
    EXPECT_FALSE(verdict.holds());
    // The measurement of the fixture: two conditions, neither of which is shown to decide alone.
    EXPECT_EQ(judge_coverage(read(), {}).conditions.total, 2U);
    EXPECT_EQ(judge_coverage(read(), {}).conditions.covered, 0U);
}

TEST_F(Coverage, RecordedReasonOfAFileAppliesToNoFileWithALongerName) {
    const auto open = [this](const std::string& file) {
        return judge_coverage(read(), {CoverageRecord{file, "branch", "a", "reason", 1}}).open();
    };
    const std::size_t all = judge_coverage(read(), {}).open();
    EXPECT_EQ(open("src/firmware/base/one.cpp"), all - 1);
    EXPECT_EQ(open("src/firmware/base/one.c"), all);
    EXPECT_EQ(open("src/firmware/base"), all);
    EXPECT_EQ(open("src/firmware/base/"), all - 1);
}

TEST_F(Coverage, RecordedReasonOfRemovedCodeIsReportedEvenWithoutAMeasurement) {
    const auto record = [](const std::string& file, const std::string& kind, const std::string& code) {
        return CoverageRecord{file, kind, code, "reason", 1};
    };
    const std::string one = "src/firmware/base/one.cpp";
    EXPECT_THAT(
        stale_records({record(one, "branch", "a && b"), record("src/firmware/", "line", "return 2;"),
                       record(one, "condition", "b) { return 1;"),  // spaces stand for line breaks of the source
                       record(one, "function", "canproof::idle"), record(one, "function", "canproof::run")},
                      root_),
        IsEmpty());
    const auto stale =
        stale_records({record(one, "branch", "a || b"), record("src/firmware/base/two.cpp", "branch", "a"),
                       record("src/firmware/canopen/", "branch", "a"), record(one, "function", "canproof::idl"),
                       record(one, "function", "canproof::b")},
                      root_);
    EXPECT_THAT(stale, SizeIs(5));
}

TEST_F(Coverage, InstantiationsOfATemplateCountTogether) {
    std::string twice = measured;
    const std::string branch = "[2,9,2,10,1,0,0,0,4]";
    twice.replace(twice.find(branch), branch.size(), branch + ",[2,9,2,10,0,7,0,0,4]");
    const std::string record = "[2,9,2,15,0,5,[false,false]]";
    twice.replace(twice.find(record), record.size(), record + ",[2,9,2,15,0,5,[true,false]]");
    write("measured.json", twice);
    const FileCoverage one = read().at(0);
    EXPECT_EQ(one.branches.total, 6U);
    EXPECT_EQ(one.branches.covered, 4U);
    EXPECT_EQ(one.conditions.covered, 1U);
}

TEST_F(Coverage, FunctionNameInAGapHasNoTemplateArguments) {
    // _ZN8canproof4made… is std::array<int, 9ul> canproof::made<int, 9ul>(std::array<int, 9ul> const&).
    std::string one = measured;
    const std::string idle = "_ZN8canproof12_GLOBAL__N_14idleEv";
    one.replace(one.find(idle), idle.size(), "_ZN8canproof4madeIiLm9EEESt5arrayIT_XT0_EERKS3_");
    write("measured.json", one);
    EXPECT_EQ(words(read().at(0).gaps).back(), "10 function canproof::made: never called");
}

TEST_F(Coverage, InvalidAndOutdatedCoverageFilesAreReported) {
    EXPECT_THAT(told("absent.json"), HasSubstr("run tests/coverage"));
    write("broken.json", "{\"data\": []}");
    EXPECT_THAT(told("broken.json"), HasSubstr("is no export of llvm-cov"));
    write("empty.json", R"({"data": [{"files": [], "functions": []}]})");
    EXPECT_THAT(told("empty.json"), HasSubstr("measures no file of the firmware"));
    write("src/firmware/base/one.cpp", source);
    std::filesystem::last_write_time(
        root_ / "src/firmware/base/one.cpp",
        std::filesystem::last_write_time(root_ / "measured.json") + std::chrono::seconds{1});
    EXPECT_THAT(told("measured.json"), HasSubstr("has changed since it was measured"));
    std::filesystem::remove(root_ / "src/firmware/base/one.cpp");
    EXPECT_THAT(told("measured.json"), HasSubstr("one.cpp was measured but does not exist any more"));
    write("records.toml", "[[record]]\nfile = \"a\"\nkind = \"colour\"\ncode = \"b\"\nreason = \"c\"\n");
    EXPECT_THAT(told("records.toml"), HasSubstr("records.toml:3: "));
    write("records.toml", "[[record]]\nfile = \"a\"\nkind = \"line\"\ncode = \"b\"\n");
    EXPECT_THAT(told("records.toml"), HasSubstr("reason"));
    write("records.toml", "[[record\n");
    EXPECT_THAT(told("records.toml"), HasSubstr("records.toml:1: "));
}

TEST_F(Coverage, CoberturaFileHasEachLineOfCodeAndItsBranches) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(write_cobertura(read()).c_str()));
    const pugi::xml_node coverage = document.child("coverage");
    EXPECT_STREQ(coverage.attribute("line-rate").value(), "0.4167");
    EXPECT_STREQ(coverage.attribute("branches-valid").value(), "6");
    const pugi::xml_node lines = document.select_node("//class/lines").node();
    EXPECT_EQ(std::distance(lines.begin(), lines.end()), 12);
    const pugi::xml_node second = document.select_node("//line[@number='2']").node();
    EXPECT_STREQ(second.attribute("hits").value(), "1");
    EXPECT_STREQ(second.attribute("condition-coverage").value(), "50% (2/4)");
    EXPECT_STREQ(document.select_node("//line[@number='3']").node().attribute("branch").value(), "false");
}

}  // namespace canproof::host::test
