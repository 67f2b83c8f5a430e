// SPDX-License-Identifier: Apache-2.0
// The files and the context that all phases of a fuzzing campaign use.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "host/assess/fuzz/campaign.hpp"
#include "host/assess/fuzz/campaign_state.hpp"
#include "host/assess/fuzz/fuzz_target.hpp"

namespace canproof::host {

class CampaignDisplay;

/// The paths of a campaign's files below the corpus folder.
class CampaignFiles {
  public:
    explicit CampaignFiles(const std::filesystem::path& corpus) : corpus_{std::filesystem::absolute(corpus)} {}

    std::filesystem::path inputs(const std::string& target) const { return corpus_ / target; }
    std::filesystem::path findings() const { return corpus_ / "findings"; }
    std::filesystem::path history() const { return corpus_ / "history.json"; }
    std::filesystem::path work() const { return corpus_ / "campaign"; }
    std::filesystem::path state() const { return work() / "state.json"; }
    std::filesystem::path scratch() const { return work() / "tmp"; }
    std::filesystem::path log(const std::string& name) const { return work() / "log" / (name + ".txt"); }
    std::filesystem::path artifacts(const std::string& target) const { return work() / "artifacts" / target; }

  private:
    std::filesystem::path corpus_;
};

struct CampaignContext {
    const CampaignOptions& options;
    const std::vector<FuzzTarget>& targets;
    const CampaignFiles& files;
    CampaignState& state;
    CampaignDisplay& display;
    Interrupted interrupted;

    TargetRecord& record(const std::string& target) const;
    void save() const { write_json(files.state(), state); }
};

/// Returns the environment variables of a fuzz target: the sanitizers print names of functions, and temporary files go
/// to the campaign's scratch folder. Creates this folder.
std::map<std::string, std::string> fuzzer_environment(const CampaignFiles& files);
/// Returns the regular files of a folder in alphabetical order; none when the folder does not exist.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder);
std::string read_text(const std::filesystem::path& file);

}  // namespace canproof::host
