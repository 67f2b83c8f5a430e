// SPDX-License-Identifier: Apache-2.0
// Tests fuzzing campaigns that are split over several machines. A shell script takes the place of libFuzzer.
#include "host/assess/fuzz/campaign_shards.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "host/assess/fuzz/campaign.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// The script that takes the place of libFuzzer: it finds the input `one` and, in target c, an input that violates a
/// requirement.
const char* const stand_in_script = R"(#!/bin/sh
mode=run
for a; do case $a in
    -fork=*) mode=fuzz ;;
    -merge=1) mode=merge ;;
    -minimize_crash=1) mode=shrink ;;
    -exact_artifact_path=*) exact=${a#*=} ;;
    -artifact_prefix=*) prefix=${a#*=} ;;
    -*) ;;
    *) if [ -z "$first" ]; then first=$a; else second=${second:-$a}; fi ;;
esac; done
case $mode in
    fuzz)
        echo '#300: cov: 12 ft: 24 corp: 4 exec/s: 100 oom/timeout/crash: 0/0/0 time: 2s job: 2 dft_time: 0'
        printf "${0##*/}" > "$first/one"
        case $0 in */c_fuzz) printf BUG > "${prefix}crash-1" ;; esac ;;
    merge) cp "$second/one" "$first/one" ;;
    shrink) printf BUG > "$exact" ;;
    run)
        if grep -q BUG "$first"; then
            echo 'requirement violated at /home/x/fuzz/pdo_fuzz.cpp:7' >&2
            exit 77
        fi ;;
esac
)";

class ShardedCampaign : public testing::Test {
  protected:
    ShardedCampaign() {
        std::string name = (fs::temp_directory_path() / "campaign-XXXXXX").string();
        folder = mkdtemp(name.data());
        fs::create_directories(folder / "build");
        options.minutes = 0.05;
        options.build = (folder / "build").string();
        options.land = (folder / "land").string();
        options.jobs = 2;
        options.seed = 5;
        options.second_pass = false;
        options.coverage = false;
        options.plain = true;
        options.root = folder.string();
        for (const char* target : {"a", "b", "c", "d", "e"}) {
            add_target(target);
        }
    }
    ~ShardedCampaign() override { fs::remove_all(folder); }

    void add_target(const std::string& name) const {
        const fs::path program = folder / "build" / (name + "_fuzz");
        std::ofstream{program} << stand_in_script;
        fs::permissions(program, fs::perms::owner_all);
        std::ofstream{folder / "build" / "fuzz_targets.txt", std::ios::app}
            << name << '\t' << (folder / "fuzz").string() << '\t' << (folder / "seeds" / name).string() << '\n';
    }
    int run(
        const std::string& place, const std::optional<Shard>& shard,
        const Interrupted& interrupted = [] { return false; }) {
        options.corpus = (folder / place).string();
        options.out = (folder / (fs::path{place}.filename().string() + "-out")).string();
        options.shard = shard;
        options.merge = "";
        return run_campaign(options, interrupted);
    }
    int merge() {
        options.corpus = (folder / "merged").string();
        options.out = (folder / "merged-out").string();
        options.shard.reset();
        options.merge = (folder / "shards").string();
        return run_campaign(options, [] { return false; });
    }
    std::string complaint() {
        try {
            merge();
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
    /// Returns the report without dates, durations and folders.
    nlohmann::json report(const std::string& place) const {
        auto report = read_json(folder / (place + "-out") / "report.json");
        report.erase("started");
        for (auto& target : report["targets"]) {
            target.erase("seconds");
            for (auto& sample : target["samples"]) {
                sample.erase("seconds");
            }
        }
        for (auto& finding : report["findings"]) {
            finding.erase("first_seen");
            finding.erase("folder");
        }
        report.erase("plateaued");  // depends on the durations
        return report;
    }

    fs::path folder;
    CampaignOptions options;
};

TEST_F(ShardedCampaign, MergedReportOfShardsEqualsTheReportOfOneMachine) {
    EXPECT_EQ(run("whole", std::nullopt), 1);
    options.jobs = 1;
    EXPECT_EQ(run("shards/first", Shard{1, 2}), 0);
    EXPECT_EQ(run("shards/second", Shard{2, 2}), 0);
    EXPECT_FALSE(fs::exists(folder / "first-out"));
    EXPECT_EQ(merge(), 1);
    EXPECT_EQ(report("merged"), report("whole"));
    EXPECT_EQ(report("merged")["findings"][0]["title"], "requirement violated at fuzz/pdo_fuzz.cpp:7");
    for (const std::string target : {"a", "b", "c", "d", "e"}) {
        EXPECT_EQ(read_text(folder / "merged" / target / "one"), target + "_fuzz");
    }
}

TEST_F(ShardedCampaign, MoreShardsThanFuzzTargetsAreAllowed) {
    for (std::size_t number = 1; number <= 7; ++number) {
        EXPECT_EQ(run("shards/" + std::to_string(number), Shard{number, 7}), 0);
    }
    EXPECT_EQ(merge(), 1);
    EXPECT_EQ(report("merged")["targets"].size(), 5U);
}

TEST_F(ShardedCampaign, SameCommandContinuesAShard_AndDoesNothingAfterItsEnd) {
    EXPECT_EQ(run("shards/first", Shard{1, 2}, [] { return true; }), 130);
    EXPECT_EQ(run("shards/second", Shard{2, 2}), 0);
    EXPECT_THAT(complaint(), HasSubstr("first has not finished fuzzing"));
    EXPECT_EQ(run("shards/first", Shard{1, 2}), 0);
    const auto state = read_text(folder / "shards/first/campaign/state.json");
    EXPECT_EQ(run("shards/first", Shard{1, 2}), 0);
    EXPECT_EQ(read_text(folder / "shards/first/campaign/state.json"), state);
    EXPECT_EQ(merge(), 1);
}

TEST_F(ShardedCampaign, ShardOfAnotherCampaignIsRefused) {
    EXPECT_EQ(run("shards/first", Shard{1, 2}), 0);
    EXPECT_THAT(complaint(), HasSubstr("shard 2/2 is missing"));
    options.seed = 6;
    EXPECT_EQ(run("shards/second", Shard{2, 2}), 0);
    EXPECT_THAT(complaint(), HasSubstr("give each shard the same --minutes and --seed"));
    options.seed = 5;
    options.restart = true;
    EXPECT_EQ(run("shards/second", Shard{2, 2}), 0);
    options.restart = false;
    add_target("f");
    EXPECT_THAT(complaint(), HasSubstr("fuzzed other targets; run shard 2/2"));
}

TEST_F(ShardedCampaign, ShardMadeFromOtherSourcesIsRefused) {
    EXPECT_EQ(run("shards/first", Shard{1, 2}), 0);
    fs::create_directories(folder / "src");
    std::ofstream{folder / "src" / "new.cpp"} << "int changed;";
    EXPECT_EQ(run("shards/second", Shard{2, 2}), 0);
    EXPECT_THAT(complaint(), HasSubstr("come from different sources; run all shards from one commit"));
}

TEST_F(ShardedCampaign, ShardWithoutASeedIsRefused) {
    options.seed = 0;
    EXPECT_THROW(run("shards/first", Shard{1, 2}), InputError);
}

TEST_F(ShardedCampaign, ShardIsNotMixedWithAnotherShard) {
    EXPECT_EQ(run("shards/first", Shard{1, 2}), 0);
    EXPECT_THROW(run("shards/first", Shard{2, 2}), InputError);
    EXPECT_THROW(run("shards/first", std::nullopt), InputError);
}

}  // namespace
}  // namespace canproof::host
