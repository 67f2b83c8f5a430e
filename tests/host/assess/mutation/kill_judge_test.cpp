// SPDX-License-Identifier: Apache-2.0
// Tests when a test is recorded as noticing a mutant of an item. Shell scripts take the place of the test programs.
#include "host/assess/mutation/kill_judge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/files.hpp"
#include "tests/support/scratch_folder.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// `at_run` is the number of a mutant that a test notices when it is chosen in the running program. `at_start` is the
/// number of a mutant that a test notices only when the program starts with it.
constexpr std::size_t at_run = 2;
constexpr std::size_t at_start = 7;
constexpr std::size_t unnoticed = 4;

/// A program of tests: `--serve` answers as tests/mutation/main.cpp does; without it, all tests run.
const char* const program = R"(#!/bin/sh
if [ "$1" = --serve ]; then
    while read -r number seconds filter; do
        if [ "$number" = 2 ]; then printf '%s\tkilled\t%s\n' "$number" "$filter"; else printf '%s\tsurvived\n' "$number"; fi
    done
    exit 0
fi
read -r flag <"${2#--gtest_flagfile=}"
[ "$flag" = --gtest_filter=Suite.Test ] && [ "$CANPROOF_ALTER" != 7 ]
)";

class KillTrial : public testing::Test {
  protected:
    KillTrial() {
        for (const char* name : {"canproof_tests", "canproof_properties", "code_mutants"}) {
            write_file(folder_ / name, program);
            std::filesystem::permissions(folder_ / name, std::filesystem::perms::owner_all);
        }
        mutants.at_startup.resize(10);
        told["Suite.Test"] = {"Suite.Test", 0.001, {at_run, unnoticed}};
    }
    KillLine judge(bool is_property = false) {
        KillJudge judging{folder_ / "", mutants, told};
        return judging.judge({"Suite.Test", "hash", is_property, {"AO4-A-1"}, "mark"});
    }

    ItemMutants mutants;
    std::map<std::string, ToldTest> told;

  private:
    canproof::test::ScratchFolder folder_;
};

}  // namespace

TEST_F(KillTrial, TestThatNoticesATableValueAlteredInARunningProgramKillsTheMutant) {
    mutants.cells["AO4-A-1"] = {unnoticed};
    EXPECT_THAT(judge().kills, IsEmpty());
    mutants.cells["AO4-A-1"] = {unnoticed, at_run};
    EXPECT_THAT(judge().kills, ElementsAre("AO4-A-1"));
    EXPECT_THAT(judge(true).kills, ElementsAre("AO4-A-1"));
    EXPECT_EQ(judge().body, "hash");
    EXPECT_EQ(judge().code, "mark");
}

TEST_F(KillTrial, TestThatNoticesATableValueAlteredAtProgramStartKillsTheMutant) {
    mutants.cells["AO4-A-1"] = {unnoticed, at_start};
    EXPECT_THAT(judge().kills, ElementsAre("AO4-A-1"));
    EXPECT_THAT(judge(true).kills, ElementsAre("AO4-A-1"));
}

TEST_F(KillTrial, MutantOfCodeIsKilledOnlyByATestThatReachesIt) {
    mutants.code["AO4-A-1"] = {at_run};
    EXPECT_THAT(judge().kills, ElementsAre("AO4-A-1"));
    told["Suite.Test"].mutants = {unnoticed};
    EXPECT_THAT(judge().kills, IsEmpty());
}

TEST_F(KillTrial, MutantOfCodeThatRunsAtProgramStartCanBeKilled) {
    mutants.code["AO4-A-1"] = {unnoticed, at_start};
    EXPECT_THAT(judge().kills, IsEmpty());
    mutants.at_startup[at_start] = true;
    EXPECT_THAT(judge().kills, ElementsAre("AO4-A-1"));
}

TEST_F(KillTrial, ItemWithoutMutantsIsListed) {
    EXPECT_THAT(judge().without_mutants, ElementsAre("AO4-A-1"));
    EXPECT_THAT(judge().kills, IsEmpty());
}

}  // namespace canproof::host::test
