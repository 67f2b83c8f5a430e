// SPDX-License-Identifier: Apache-2.0
// `canproof replay`: plays a log to one device in virtual time.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace canproof::host {

struct ReplayOptions {
    std::string device;
    std::string eds;                  ///< data sheet of the device; replaces `device`
    std::string log;                  ///< file, or - for standard input
    std::optional<std::string> node;  ///< node-ID; without a value, the node-ID as shipped
    std::vector<std::string> factory;
    std::string nvm;
    std::string stimulus;
    std::string outputs;
    std::optional<double> start;
    std::optional<double> until;
};

/// Prints the device's frames. Returns the exit status.
int replay_log(const ReplayOptions& options);

}  // namespace canproof::host
