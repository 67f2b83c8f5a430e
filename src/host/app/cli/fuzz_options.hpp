// SPDX-License-Identifier: Apache-2.0
// The options of the command `fuzz`.
#pragma once

#include <string>
#include <vector>

#include "host/app/cli/command.hpp"
#include "host/assess/fuzz/campaign.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace canproof::host {

class FuzzCommand : Command {
  public:
    FuzzCommand(CLI::App& app, Chosen& chosen);

  private:
    /// An option that names a folder. Its default is a path below the project's folder (--root).
    struct Folder {
        const CLI::Option* option;
        std::string* path;
    };

    void add_folder(CLI::Option* option, std::string& path);
    void put_folders_below_root() const;

    CampaignOptions options_;
    std::vector<Folder> folders_;
    std::string shard_;
    double hours_{0.0};  ///< duration of the campaign in hours; 0: --minutes sets the duration
};

}  // namespace canproof::host
