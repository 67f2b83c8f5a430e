// SPDX-License-Identifier: Apache-2.0
// Tests the conformance case that checks the data sheet itself: number 1.0 of the public transcript of a CANopen
// conformance run.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "host/conform/link/virtual_target.hpp"
#include "host/conform/run/run_cases.hpp"
#include "host/sim/devices/generic_simulation.hpp"
#include "tests/support/slave_register.hpp"

namespace canproof::host::conform::test {

namespace {

CaseResult judged(const ConformSheet& sheet) {
    VirtualTarget target{std::make_unique<GenericSimulation>(canproof::test::slave_part()), sheet.node_id};
    ConformOptions options;
    options.cases = {"1.0"};
    return run_cases(built_in_cases(), sheet, target, options).results.front();
}

/// Returns the data sheet of the slave with `found` replaced.
ConformSheet altered(const std::string& found, const std::string& replacement) {
    const ConformSheet sheet = sheet_of(canproof::test::slave_part());
    std::string text = sheet.text;
    const std::size_t at = text.find(found);
    EXPECT_NE(at, std::string::npos) << found;
    text.replace(at, found.size(), replacement);
    return read_sheet(text, "slave.eds", sheet.node_id);
}

}  // namespace

TEST(EdsFormCase, DataSheetOfTheSlavePassesTheConformanceCase) {
    const CaseResult result = judged(sheet_of(canproof::test::slave_part()));
    EXPECT_EQ(result.verdict, Verdict::passed) << result.why;
}

TEST(EdsFormCase, DataSheetWithAnErrorFailsTheConformanceCaseWithItsLine) {
    // The list counts two of the three mandatory objects of CiA 301.
    const CaseResult result = judged(altered("SupportedObjects=3", "SupportedObjects=2"));
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_NE(result.why.find("error(s); the first is: slave.eds:"), std::string::npos) << result.why;
}

TEST(EdsFormCase, DataSheetWithAWarningPassesTheConformanceCaseWithANote) {
    const CaseResult result = judged(altered("FileName=slave.eds", "FileName=other.eds"));
    EXPECT_EQ(result.verdict, Verdict::passed) << result.why;
    ASSERT_FALSE(result.notes.empty());
    EXPECT_NE(result.notes.front().find("fileinfo-name-differs"), std::string::npos) << result.notes.front();
}

}  // namespace canproof::host::conform::test
