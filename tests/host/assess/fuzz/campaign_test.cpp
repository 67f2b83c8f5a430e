// SPDX-License-Identifier: Apache-2.0
// Tests whole fuzzing campaigns, with a shell script instead of libFuzzer.
#include "host/assess/fuzz/campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "host/assess/fuzz/campaign_files.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {
namespace {

namespace fs = std::filesystem;

/// Returns a script that behaves as the campaign expects of libFuzzer. An input with the word BUG violates a
/// requirement. Fuzzing finds the input `one` and prints two lines of progress; `fuzzing` has additional commands.
std::string stand_in(const std::string& fuzzing) {
    return R"(#!/bin/sh
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
        echo '#100: cov: 10 ft: 20 corp: 3 exec/s: 100 oom/timeout/crash: 0/0/0 time: 1s job: 1 dft_time: 0'
        printf one > "$first/one"
        printf same > "$first/superfluous"
        echo '#300: cov: 12 ft: 24 corp: 4 exec/s: 100 oom/timeout/crash: 0/0/0 time: 2s job: 2 dft_time: 0'
        )" +
           fuzzing + R"(
        ;;
    merge) cp "$second/one" "$first/one" ;;
    shrink) printf BUG > "$exact" ;;
    run)
        if grep -q BUG "$first"; then
            echo 'requirement violated at /home/x/fuzz/pdo_fuzz.cpp:7' >&2
            exit 77
        fi ;;
esac
)";
}

std::string text_of(const fs::path& file) {
    return read_text(file);
}

class Campaign : public testing::Test {
  protected:
    Campaign() {
        std::string name = (fs::temp_directory_path() / "campaign-XXXXXX").string();
        folder = mkdtemp(name.data());
        fs::create_directories(folder / "build");
        options.minutes = 0.05;
        options.corpus = (folder / "corpus").string();
        options.out = (folder / "out").string();
        options.build = (folder / "build").string();
        options.replay_build = (folder / "no-build").string();
        options.land = (folder / "land").string();
        options.jobs = 2;
        options.seed = 5;
        options.second_pass = false;
        options.coverage = false;
        options.plain = true;
    }
    ~Campaign() override { fs::remove_all(folder); }

    void add_target(const std::string& name, const std::string& fuzzing) {
        const fs::path program = folder / "build" / (name + "_fuzz");
        std::ofstream{program} << stand_in(fuzzing);
        fs::permissions(program, fs::perms::owner_all);
        list_target(name);
    }
    /// Adds the line of a target to fuzz_targets.txt, as the configure step does.
    void list_target(const std::string& name) {
        std::ofstream{folder / "build" / "fuzz_targets.txt", std::ios::app}
            << name << '\t' << (folder / "fuzz").string() << '\t' << (folder / "fuzz" / "seeds" / name).string()
            << '\n';
    }
    int run(const Interrupted& interrupted = [] { return false; }) { return run_campaign(options, interrupted); }
    nlohmann::json report() const { return read_json(folder / "out" / "report.json"); }

    fs::path folder;
    CampaignOptions options;
};

TEST_F(Campaign, CampaignCountsExecutionsMinimisesTheCorpusAndWritesAReport) {
    add_target("a", "");
    add_target("b", "");
    EXPECT_EQ(run(), 0);
    const auto told = report();
    EXPECT_TRUE(told["finished"]);
    EXPECT_EQ(told["executions"], 600);
    ASSERT_EQ(told["targets"].size(), 2U);
    EXPECT_EQ(told["targets"][0]["name"], "a");
    EXPECT_EQ(told["targets"][0]["samples"][1]["edges"], 12);
    EXPECT_EQ(told["targets"][0]["inputs_found"], 2);
    EXPECT_EQ(told["targets"][0]["inputs_kept"], 1);
    EXPECT_EQ(text_of(folder / "corpus" / "a" / "one"), "one");
    EXPECT_FALSE(fs::exists(folder / "corpus" / "a" / "superfluous"));
    EXPECT_NE(text_of(folder / "out" / "index.html").find("No finding."), std::string::npos);
}

TEST_F(Campaign, CampaignWritesItsResultsForTheEvidencePack) {
    const auto exhibit = [&] { return read_json(folder / "out" / "exhibit.json"); };
    add_target("a", "");
    add_target("b", "");
    run();
    EXPECT_EQ(exhibit()["state"], "holds");
    EXPECT_EQ(exhibit()["page"], "index.html");
    EXPECT_EQ(exhibit()["says"].get<std::string>().find("2 targets, "), 0U) << exhibit()["says"];
    EXPECT_NE(exhibit()["says"].dump().find("600 executions, 0 finding(s)"), std::string::npos) << exhibit()["says"];
    add_target("b", R"(printf BUGs > "${prefix}crash-2")");
    run();
    EXPECT_EQ(exhibit()["state"], "open");
    EXPECT_EQ(exhibit()["open"][0], "b: requirement violated at fuzz/pdo_fuzz.cpp:7");
}

TEST_F(Campaign, RepeatedCrashIsOneFinding) {
    add_target("a", R"(printf longerBUGinput > "${prefix}crash-1"; printf BUGs > "${prefix}crash-2")");
    EXPECT_EQ(run(), 1);
    const auto told = report();
    ASSERT_EQ(told["findings"].size(), 1U);
    const auto& finding = told["findings"][0];
    EXPECT_EQ(finding["title"], "requirement violated at fuzz/pdo_fuzz.cpp:7");
    EXPECT_EQ(finding["times"], 2);
    EXPECT_EQ(finding["bytes"], 3);
    const fs::path kept{finding["folder"].get<std::string>()};
    EXPECT_EQ(text_of(kept / "input"), "BUG");
    EXPECT_NE(text_of(kept / "output.txt").find("requirement violated"), std::string::npos);
    EXPECT_EQ(text_of(finding["regression"].get<std::string>()), "BUG");
    EXPECT_EQ(fs::path{finding["regression"].get<std::string>()}.parent_path(), folder / "land" / "a");
}

TEST_F(Campaign, FindingIsAddedToTheCorpusOfItsTarget) {
    options.land.reset();
    add_target("a", R"(printf BUGs > "${prefix}crash-1")");
    EXPECT_EQ(run(), 1);
    const fs::path landed{report()["findings"][0]["regression"].get<std::string>()};
    EXPECT_EQ(landed.parent_path(), folder / "fuzz" / "seeds" / "a");
    EXPECT_EQ(text_of(landed), "BUG");
}

TEST_F(Campaign, FindingIsAddedToNoCorpusWhenOptionLandIsEmpty) {
    options.land = "";
    add_target("a", R"(printf BUGs > "${prefix}crash-1")");
    EXPECT_EQ(run(), 1);
    EXPECT_EQ(report()["findings"][0]["regression"], "");
    EXPECT_FALSE(fs::exists(folder / "fuzz" / "seeds" / "a"));
}

TEST_F(Campaign, UnreproducibleCrashIsAFinding) {
    add_target("a", R"(printf harmless > "${prefix}crash-1")");
    EXPECT_EQ(run(), 1);
    const auto told = report();
    ASSERT_EQ(told["findings"].size(), 1U);
    EXPECT_FALSE(told["findings"][0]["reproduces"]);
    EXPECT_EQ(told["findings"][0]["regression"], "");
}

TEST_F(Campaign, CampaignComparesWithThePreviousCampaign) {
    add_target("a", "");
    run();
    EXPECT_TRUE(report()["last_night"].is_null());
    add_target("a", R"(echo '#400: cov: 15 ft: 30 corp: 5 ')");
    run();
    EXPECT_EQ(report()["last_night"]["edges"]["a"], 12);
    EXPECT_NE(text_of(folder / "out" / "index.html").find("Change since the last campaign\">+3"), std::string::npos);
    EXPECT_EQ(report()["targets"][0]["inputs_before"], 1);
}

TEST_F(Campaign, InterruptedCampaignWritesAReport_AndTheSameCommandContinuesIt) {
    add_target("a", "");
    add_target("b", R"(mkfifo "$first.never"; read nothing < "$first.never")");  // waits until it gets SIGINT
    const auto b_has_begun = [&] { return fs::exists(folder / "corpus" / "b.never"); };
    EXPECT_EQ(run(b_has_begun), 130);
    const auto told = report();
    EXPECT_FALSE(told["finished"]);
    EXPECT_NE(text_of(folder / "out" / "index.html").find("Not finished: the campaign was stopped during “fuzzing”"),
              std::string::npos);
    EXPECT_TRUE(fs::exists(folder / "corpus" / "b" / "one"));

    add_target("b", "");
    EXPECT_EQ(run(), 0);
    EXPECT_TRUE(report()["finished"]);
    EXPECT_EQ(report()["started"], told["started"]);
    EXPECT_EQ(report()["targets"][0]["slices"], 1);
    EXPECT_EQ(report()["targets"][1]["slices"], 1);
}

TEST_F(Campaign, UnfinishedCampaignIsNotMixedWithAnother) {
    add_target("a", "");
    run([] { return true; });
    options.minutes = 7;
    try {
        run();
        FAIL() << "went on with another campaign";
    } catch (const InputError& error) {
        EXPECT_NE(std::string{error.what()}.find("--restart"), std::string::npos);
    }
    options.minutes = 0.05;
    options.restart = true;
    EXPECT_EQ(run(), 0);
}

TEST_F(Campaign, ReportRoundsTheMinutesOfACampaign) {
    add_target("a", "");
    add_target("b", "");
    options.minutes = 0.1 + 0.2;  // 0.30000000000000004
    EXPECT_EQ(run(), 0);
    EXPECT_NE(text_of(folder / "out" / "index.html").find(", 0.3 minutes on 2 job(s)"), std::string::npos);
    const auto exhibit = read_json(folder / "out" / "exhibit.json");
    EXPECT_THAT(exhibit["says"].get<std::string>(), testing::StartsWith("2 targets, 0.3 minutes on 2 job(s)"));
}

TEST_F(Campaign, FuzzTargetThatEndsEarlyIsAFailure) {
    add_target("a", "exit 3");
    EXPECT_EQ(run(), 2);
    EXPECT_NE(report()["remarks"].dump().find("a ended with status 3"), std::string::npos);
    const auto exhibit = read_json(folder / "out" / "exhibit.json");
    EXPECT_EQ(exhibit["state"], "open");
    EXPECT_EQ(exhibit["open"][0], "a: 1 slice(s) of the fuzzing time ended too early");
}

TEST_F(Campaign, MissingBuildOrTargetIsReportedWithItsRemedy) {
    const auto complaint = [&] {
        try {
            run();
        } catch (const InputError& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    EXPECT_NE(complaint().find("cmake --preset fuzz"), std::string::npos);
    add_target("a", "");
    options.targets = {"c"};
    EXPECT_NE(complaint().find("no target `c`; its targets are a"), std::string::npos);
    list_target("c");
    EXPECT_NE(complaint().find("c_fuzz is not built"), std::string::npos);
    options.targets = {"a"};
    options.second_pass = true;
    EXPECT_NE(complaint().find("--no-second-pass"), std::string::npos);
    options.second_pass = false;
    options.coverage = true;
    options.coverage_build = (folder / "no-build").string();
    EXPECT_NE(complaint().find("cmake --preset fuzz-coverage"), std::string::npos);
}

TEST_F(Campaign, OptionsAndDictionaryOfAFuzzTargetAreReadFromItsFiles) {
    add_target("a", R"(echo "$@" > "$first/arguments")");
    fs::create_directories(folder / "fuzz");
    std::ofstream{folder / "fuzz" / "a.options"} << "[libfuzzer]\nmax_len = 4096\n";
    std::ofstream{folder / "fuzz" / "a.dict"} << "\"x\"\n";
    const auto targets = find_fuzz_targets(options.build, {});
    ASSERT_EQ(targets.size(), 1U);
    EXPECT_EQ(targets[0].options.back(), "-max_len=4096");
    EXPECT_EQ(targets[0].dictionary, folder / "fuzz" / "a.dict");
    EXPECT_EQ(targets[0].seeds, folder / "fuzz" / "seeds" / "a");
    std::ofstream{folder / "fuzz" / "a.options"} << "[libfuzzer]\nmax_len 4096\n";
    EXPECT_THROW(find_fuzz_targets(options.build, {}), InputError);
}

TEST_F(Campaign, InvalidLineOfTheTargetListIsReportedWithItsNumber) {
    add_target("a", "");
    std::ofstream{folder / "build" / "fuzz_targets.txt", std::ios::app} << "b of two words\n";
    try {
        find_fuzz_targets(options.build, {});
        FAIL() << "took the line for a target";
    } catch (const InputError& error) {
        EXPECT_NE(std::string{error.what()}.find("fuzz_targets.txt:2: "), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace canproof::host
