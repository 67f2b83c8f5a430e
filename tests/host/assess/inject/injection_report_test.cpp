// SPDX-License-Identifier: Apache-2.0
// Tests the table and the JSON report of an injection campaign, and the merging of its shards.
#include "host/assess/inject/injection_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace canproof::host::test {

namespace {

/// Seven faults: two masked, two detected, one leads to the safe state, two are silent.
InjectionCampaign seven_runs() {
    InjectionCampaign made;
    made.regions = {{"device", 100}, {"queue", 28}};
    made.calls = 40;
    made.runs = {{{0, 0, 1, 0}, FaultEffect::masked},       {{1, 0, 2, 1}, FaultEffect::watchdog},
                 {{2, 1, 3, 2}, FaultEffect::emergency},    {{3, 0, 4, 3}, FaultEffect::safe_state},
                 {{4, 0, 5, 4}, FaultEffect::wrong_output}, {{5, 1, 6, 5}, FaultEffect::wrong_pdo},
                 {{6, 1, 7, 6}, FaultEffect::masked}};
    return made;
}

InjectionOptions seven() {
    InjectionOptions options;
    options.seed = 9;
    options.faults = 7;
    return options;
}

void write_shards(const std::filesystem::path& folder, std::size_t count) {
    for (std::size_t number = 1; number <= count; ++number) {
        InjectionOptions options = seven();
        options.shard = {number, count};
        InjectionCampaign part = seven_runs();
        part.runs = share_of(part.runs, options.shard);
        write_file(folder / injection_shard_name("box", options.shard), write_injection_shard("box", options, part));
    }
}

}  // namespace

TEST(InjectionReport, TableHasTheNumberOfRunsAndThePercentageOfEachKindOfEffect) {
    const std::string table = injection_table("box", seven(), seven_runs());
    EXPECT_NE(table.find("box: 7 runs; each run inverts one bit in the 128 bytes of memory before one of the 40 calls "
                         "of the device; seed 9"),
              std::string::npos);
    EXPECT_NE(table.find("\n\n"
                         "                          device     queue       all\n"
                         "processor fault                0         0         0\n"
                         "watchdog                       1         0         1\n"
                         "EMCY                           0         1         1\n"
                         "boot-up or heartbeat           0         0         0\n"
                         "safe state                     1         0         1\n"
                         "wrong output                   1         0         1\n"
                         "wrong PDO data                 0         1         1\n"
                         "PDO missing or late            0         0         0\n"
                         "wrong answer                   0         0         0\n"
                         "masked                         1         1         2\n"
                         "\n"),
              std::string::npos)
        << table;
    // 5 of 7 have an effect; 2 of 5 are detected, 1 of 5 is safe, 2 of 5 are silent.
    EXPECT_NE(table.find("5 of 7 have an effect (71.4 %); of these 40.0 % are detected, 20.0 % lead to the safe state, "
                         "40.0 % send or output a wrong value silently"),
              std::string::npos)
        << table;
}

TEST(InjectionReport, JsonNamesEachFaultWhoseWrongEffectIsNotDetected) {
    const auto json = nlohmann::json::parse(injection_json("box", seven(), seven_runs()));
    EXPECT_EQ(json["effects"]["EMCY"], 1);
    EXPECT_EQ(json["by_region"]["queue"]["masked"], 1);
    EXPECT_EQ(json["silent"], nlohmann::json::parse(R"([
        {"call": 4, "region": "device", "byte": 5, "bit": 4, "effect": "wrong output"},
        {"call": 5, "region": "queue", "byte": 6, "bit": 5, "effect": "wrong PDO data"}])"));
}

TEST(InjectionReport, MergedShardsGiveTheSameReport) {
    const canproof::test::ScratchFolder folder;
    write_shards(folder / "", 3);
    InjectionOptions options;
    const InjectionCampaign merged = merge_injection_shards(folder / "", "box", options);
    EXPECT_EQ(injection_json("box", options, merged), injection_json("box", seven(), seven_runs()));
}

TEST(InjectionReport, MissingShardIsRefused) {
    const canproof::test::ScratchFolder folder;
    write_shards(folder / "", 3);
    std::filesystem::remove(folder / "" / injection_shard_name("box", {2, 3}));
    InjectionOptions options;
    EXPECT_THROW(merge_injection_shards(folder / "", "box", options), InputError);
    EXPECT_THROW(merge_injection_shards(folder / "", "other", options), InputError);
}

TEST(InjectionReport, ShardOfAnotherCampaignIsRefused) {
    const canproof::test::ScratchFolder folder;
    write_shards(folder / "", 2);
    InjectionOptions options = seven();
    options.shard = {2, 2};
    options.seed = 10;
    InjectionCampaign part = seven_runs();
    part.runs = share_of(part.runs, options.shard);
    write_file(folder / "" / injection_shard_name("box", options.shard), write_injection_shard("box", options, part));
    EXPECT_THROW(merge_injection_shards(folder / "", "box", options), InputError);
}

TEST(InjectionReport, ShardMadeFromOtherSourcesIsRefused) {
    const canproof::test::ScratchFolder folder;
    write_shards(folder / "", 2);
    InjectionOptions options = seven();
    options.shard = {2, 2};
    options.sources = "other";
    InjectionCampaign part = seven_runs();
    part.runs = share_of(part.runs, options.shard);
    write_file(folder / "" / injection_shard_name("box", options.shard), write_injection_shard("box", options, part));
    EXPECT_THROW(merge_injection_shards(folder / "", "box", options), InputError);
}

TEST(InjectionReport, DamagedShardIsRefused) {
    for (const char* const text :
         {"", "{}",
          R"({"shard": "1/1", "sources": "", "campaign": {"calls": 1, "regions": []}, "runs": [[0, 0, 0, 0, 99]]})"}) {
        const canproof::test::ScratchFolder folder;
        write_file(folder / "" / injection_shard_name("box", {1, 1}), text);
        InjectionOptions options;
        EXPECT_THROW(merge_injection_shards(folder / "", "box", options), InputError) << text;
    }
}

}  // namespace canproof::host::test
