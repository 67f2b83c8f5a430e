// SPDX-License-Identifier: Apache-2.0
// Tests the run of a test program before alterations: it passes, or the error names the tests that fail.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "host/assess/mutation/test_server.hpp"
#include "host/base/input_error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;
using testing::Not;

/// Writes a program that stands for a test program: it writes `results` to its output file and ends with `status`.
std::filesystem::path program_of(const canproof::test::ScratchFolder& folder, const std::string& results, int status) {
    const auto path = folder / "program";
    std::ofstream{path} << "#!/bin/sh\n"
                        << (results.empty() ? "" : "echo '" + results + "' > \"${1#--gtest_output=xml:}\"\n") << "exit "
                        << status << "\n";
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
}

const std::string one_failure = R"(<testsuites>
<testcase classname="Relay" name="Opens" status="run" time="0.1"/>
<testcase classname="Relay" name="Closes" status="run" time="0.1"><failure message="no"/></testcase>
</testsuites>)";

std::string error_of(const std::filesystem::path& file, const std::filesystem::path& verdicts) {
    try {
        pass_unaltered(file, verdicts);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(UnalteredRun, ErrorNamesOnlyTheTestsThatFail) {
    const canproof::test::ScratchFolder folder;
    const std::string error = error_of(program_of(folder, one_failure, 1), folder / "verdicts.xml");
    EXPECT_THAT(error, HasSubstr("exit status 1"));
    EXPECT_THAT(error, HasSubstr("Relay.Closes"));
    EXPECT_THAT(error, Not(HasSubstr("Relay.Opens")));
}

TEST(UnalteredRun, ErrorSaysThatAProgramEndedWithoutResults) {
    const canproof::test::ScratchFolder folder;
    // Results of an earlier run do not count.
    std::ofstream{folder / "verdicts.xml"} << one_failure;
    const std::string error = error_of(program_of(folder, "", 3), folder / "verdicts.xml");
    EXPECT_THAT(error, HasSubstr("exit status 3"));
    EXPECT_THAT(error, HasSubstr("no test reports a failure"));
}

TEST(UnalteredRun, ProgramThatPassesIsNoError) {
    const canproof::test::ScratchFolder folder;
    EXPECT_EQ(error_of(program_of(folder, one_failure, 0), folder / "verdicts.xml"), "");
}

}  // namespace canproof::host::test
