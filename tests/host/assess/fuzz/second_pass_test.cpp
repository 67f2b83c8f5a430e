// SPDX-License-Identifier: Apache-2.0
// Tests the second pass of a fuzzing campaign, which runs the kept inputs under valgrind. A shell script takes the
// place of valgrind.
#include "host/assess/fuzz/second_pass.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "host/assess/fuzz/campaign_display.hpp"

namespace canproof::host {
namespace {

class SecondPass : public testing::Test {
  protected:
    SecondPass() {
        std::string name = (std::filesystem::temp_directory_path() / "second-pass-XXXXXX").string();
        folder_ = mkdtemp(name.data());
        std::filesystem::create_directories(CampaignFiles{folder_}.work());
        const auto valgrind = folder_ / "valgrind";
        std::ofstream{valgrind} << "#!/bin/sh\nexit 0\n";
        std::filesystem::permissions(valgrind, std::filesystem::perms::owner_all);
        setenv("PATH", (folder_.string() + ":" + path_).c_str(), 1);
    }
    ~SecondPass() override {
        setenv("PATH", path_.c_str(), 1);
        std::filesystem::remove_all(folder_);
    }
    void add_target(const std::string& name, unsigned inputs) {
        FuzzTarget target;
        target.name = name;
        targets_.push_back(target);
        TargetRecord record;
        record.name = name;
        state_.targets.push_back(record);
        std::filesystem::create_directories(folder_ / name);
        for (unsigned i = 0; i < inputs; ++i) {
            std::ofstream{folder_ / name / std::to_string(i)} << i;
        }
    }
    /// Runs the pass after a campaign of this duration. Returns the numbers of inputs that it ran, by target.
    std::vector<std::size_t> run(double minutes) {
        CampaignOptions options;
        options.jobs = 2;
        state_.minutes = minutes;
        const CampaignFiles files{folder_};
        CampaignDisplay display{stdout, false};
        const CampaignContext context{options, targets_, files, state_, display, [] { return false; }};
        EXPECT_TRUE(look_again_with_valgrind(context));
        std::vector<std::size_t> counts;
        for (const TargetRecord& one : state_.targets) {
            counts.push_back(one.inputs_second_pass);
        }
        return counts;
    }

  private:
    const std::string path_{std::getenv("PATH")};
    std::filesystem::path folder_;
    std::vector<FuzzTarget> targets_;
    CampaignState state_;
};

// A chunk has at most 10 inputs. With no time left, the pass runs the first chunk of each target and no other.
TEST_F(SecondPass, FirstInputsOfEachFuzzTargetRunUnderValgrindEvenWithoutTimeLeft) {
    add_target("none", 0);
    add_target("few", 3);
    add_target("many", 25);
    EXPECT_EQ(run(0.0), (std::vector<std::size_t>{0, 3, 10}));
    EXPECT_EQ(run(10.0), (std::vector<std::size_t>{0, 3, 25}));
}

TEST_F(SecondPass, FuzzTargetWithoutInputsIsNotRunUnderValgrind) {
    add_target("none", 0);
    EXPECT_EQ(run(0.0), (std::vector<std::size_t>{0}));
}

}  // namespace
}  // namespace canproof::host
