// SPDX-License-Identifier: Apache-2.0
// Tests how a run of conformance cases starts with a slave that behaves wrongly from its first answer on. The run
// reports its faults and executes the cases. If the slave sends nothing, the run ends.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "host/base/input_error.hpp"
#include "host/conform/link/virtual_target.hpp"
#include "host/conform/run/run_cases.hpp"
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"
#include "tests/conformance/zoo/wrong_slave.hpp"
#include "tests/support/slave_register.hpp"

namespace canproof::test::zoo {

namespace {

namespace conform = host::conform;

using conform::Verdict;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

conform::ConformReport run_one_case(const Distortion& distortion, const std::string& id) {
    static const conform::ConformSheet sheet = conform::sheet_of(slave_part());
    conform::VirtualTarget target{std::make_unique<WrongSlave>(distortion), 5};
    conform::ConformOptions options;
    options.cases = {id};
    return conform::run_cases(conform::built_in_cases(), sheet, target, options);
}

const Distortion& fault(const std::string& id) {
    return std::find_if(all_faults().begin(), all_faults().end(), [&](const Fault& one) { return one.id == id; })
        ->distortion;
}

}  // namespace

TEST(StartOfARun, CorrectSlaveCausesNoReportAtTheStart) {
    EXPECT_THAT(run_one_case({}, "sdo-device-type").troubles, IsEmpty());
}

TEST(StartOfARun, WrongValueOfTheSlaveIsReportedAndTheConformanceCasesStillRun) {
    const conform::ConformReport report = run_one_case(fault("sdo-upload-size"), "sdo-device-type");
    EXPECT_THAT(report.troubles, Contains("1008h:00 cannot be read: the slave announced 18 bytes, but sent 17"));
    ASSERT_EQ(report.results.size(), 1U);
    EXPECT_EQ(report.results.front().verdict, Verdict::passed);
}

TEST(StartOfARun, MissingBootUpMessageIsReportedAndTheConformanceCasesStillRun) {
    const conform::ConformReport report = run_one_case(fault("nmt-no-boot-up"), "sdo-device-type");
    EXPECT_THAT(report.troubles, ElementsAre("the slave sent no boot-up message after reset node"));
    ASSERT_EQ(report.results.size(), 1U);
    EXPECT_EQ(report.results.front().verdict, Verdict::passed);
    EXPECT_THAT(report.results.front().notes,
                ElementsAre("the slave sends no boot-up message after a reset, or not after every reset"));
}

TEST(StartOfARun, RunEndsWhenTheSlaveDoesNotAnswer) {
    const Distortion silent = keeps_back([](WrongSlave&, const Frame&) { return true; });
    EXPECT_THROW(run_one_case(silent, "sdo-device-type"), host::InputError);
}

}  // namespace canproof::test::zoo
