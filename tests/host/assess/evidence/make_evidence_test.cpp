// SPDX-License-Identifier: Apache-2.0
// Tests which evidence `canproof evidence --full` makes, in which order, and with which messages.
#include "host/assess/evidence/make_evidence.hpp"

#include <gmock/gmock.h>

#include <csignal>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host::test {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Exhibit exhibit(const std::string& key, const Exhibit::State state) {
    return {key, key, state, "", ""};
}

std::vector<std::string> keys_of(const std::vector<ExpectedEvidence>& all) {
    std::vector<std::string> keys;
    for (const auto& one : all) {
        keys.push_back(one.key);
    }
    return keys;
}

}  // namespace

TEST(MakeEvidence, AbsentOrStaleEvidenceIsSelectedWhenItHasACommand) {
    Argument argument;
    argument.evidence = {{"coverage", "", "", "true", 1},
                         {"fuzz", "", "", "true", 1},
                         {"misra", "", "", "true", 1},
                         {"target", "", "", "", 1},
                         {"scale", "", "", "true", 1}};
    using State = Exhibit::State;
    Exhibits exhibits{{"tests", exhibit("tests", State::holds)},
                      {"coverage", exhibit("coverage", State::holds)},
                      {"fuzz", exhibit("fuzz", State::stale)},
                      {"misra", exhibit("misra", State::open)},
                      {"target", exhibit("target", State::absent)}};
    // The result of misra is open but up to date, so measuring it again would not help. That of scale is absent.
    EXPECT_THAT(keys_of(makeable(argument, exhibits)), ElementsAre("fuzz", "scale"));
    exhibits["tests"].state = State::stale;
    EXPECT_THAT(keys_of(makeable(argument, exhibits)), ElementsAre("coverage", "fuzz", "scale"));
    EXPECT_THAT(keys_of(makeable(argument, {})), ElementsAre("coverage", "fuzz", "misra", "scale"));
}

TEST(MakeEvidence, FailedCommandIsReportedWithItsOutputAndTheRestContinues) {
    const std::filesystem::path root = std::filesystem::path{::testing::TempDir()} / "make evidence";
    std::filesystem::remove_all(root);
    std::filesystem::create_directories(root);
    std::vector<std::string> told;
    const auto tell = [&told](const std::string& line) { told.push_back(line); };
    const std::vector<ExpectedEvidence> wanted{{"one", "First", "", "echo told; exit 3", 5},
                                               {"two", "Second", "", "touch made; test -x \"$CANPROOF\"", 7}};
    EXPECT_EQ(make_evidence(wanted, root, tell), 1U);
    EXPECT_TRUE(std::filesystem::exists(root / "made"));
    EXPECT_EQ(read_file(root / "build/log/evidence-one.log"), "told\n");
    ASSERT_THAT(told, SizeIs(4));
    EXPECT_EQ(told[0], "[1/2] First: about 5 min; 12 min for all remaining steps; its output is in " +
                           (root / "build/log/evidence-one.log").string());
    EXPECT_THAT(told[1], HasSubstr("[1/2] First: failed with status 3 after 0:0"));
    EXPECT_THAT(told[1], HasSubstr("build/log/evidence-one.log"));
    EXPECT_THAT(told[2], HasSubstr("[2/2] Second: about 7 min; 7 min for all remaining steps; its output is in "));
    EXPECT_THAT(told[3], HasSubstr("[2/2] Second: done after"));
    std::filesystem::remove_all(root);
}

TEST(MakeEvidence, RunIsRefusedWhileAStepOfThePreviousRunIsAlive) {
    const std::filesystem::path root = std::filesystem::path{::testing::TempDir()} / "outliving step";
    std::filesystem::remove_all(root);
    std::filesystem::create_directories(root);
    const auto silent = [](const std::string&) {};
    const std::vector<ExpectedEvidence> outlives{{"one", "", "", "tail -f /dev/null & echo $! >process", 1}};
    const std::vector<ExpectedEvidence> next{{"two", "", "", "touch made", 1}};
    EXPECT_EQ(make_evidence(outlives, root, silent), 0U);
    const pid_t process = std::stoi(read_file(root / "process"));
    EXPECT_THROW(make_evidence(next, root, silent), InputError);
    EXPECT_FALSE(std::filesystem::exists(root / "made"));
    EXPECT_EQ(kill(process, SIGKILL), 0);
    std::filesystem::remove_all(root);
}

TEST(MakeEvidence, NewRunIsAllowedAfterThePreviousRunHasFinished) {
    const std::filesystem::path root = std::filesystem::path{::testing::TempDir()} / "finished run";
    const auto silent = [](const std::string&) {};
    const std::vector<ExpectedEvidence> wanted{{"one", "", "", "true", 1}};
    EXPECT_EQ(make_evidence(wanted, root, silent), 0U);
    EXPECT_EQ(make_evidence(wanted, root, silent), 0U);
    std::filesystem::remove_all(root);
}

}  // namespace canproof::host::test
