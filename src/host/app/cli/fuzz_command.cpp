// SPDX-License-Identifier: Apache-2.0
// The `fuzz` command: runs a fuzzing campaign, which Ctrl-C stops in an orderly way.
#include "host/app/cli/fuzz_command.hpp"

#include <csignal>

#include "host/assess/fuzz/campaign.hpp"

namespace canproof::host {

namespace {

volatile std::sig_atomic_t stop_asked = 0;

}  // namespace

int fuzz_targets(const CampaignOptions& options) {
    struct sigaction action {};
    action.sa_handler = [](int) { stop_asked = 1; };
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    return run_campaign(options, [] { return stop_asked != 0; });
}

}  // namespace canproof::host
