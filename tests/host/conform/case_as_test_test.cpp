// SPDX-License-Identifier: Apache-2.0
// Runs the conformance cases that take the place of a test, on the simulated slave for conformance. The result of a
// case counts for the requirements that the case names.
//
// A case does not replace a test of tests/conformance that does more than a case can. Such a test also runs on the
// microcontroller, where no case runs. Or it requires one exact abort code, time or frame where CiA 301 leaves a slave
// the choice.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/host/conform/conform_bench.hpp"

namespace canproof::host::conform::test {

namespace {

class CaseAsTest : public testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(CaseAsTest, CasePassesOnTheConformanceSlave) {
    const std::vector<Case>& cases = built_in_cases().cases;
    const auto one = std::find_if(cases.begin(), cases.end(), [](const Case& any) { return any.id == GetParam(); });
    ASSERT_NE(one, cases.end()) << GetParam();
    ASSERT_FALSE(one->tests.empty()) << "it counts for no requirement";
    for (const std::string& requirement : one->tests) {
        RecordProperty(requirement, "test");
    }
    VirtualTarget target{sound_slave(), 5};
    ConformOptions options;
    options.cases = {one->id};
    const CaseResult result = run_cases(built_in_cases(), slave_sheet(), target, options).results.at(0);
    EXPECT_EQ(result.verdict, Verdict::passed) << result.why << " " << result.step;
}

INSTANTIATE_TEST_SUITE_P(Store, CaseAsTest,
                         testing::Values("verify-configuration-unsaved", "verify-configuration-parts"),
                         [](const auto& one) {
                             std::string name = one.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace canproof::host::conform::test
