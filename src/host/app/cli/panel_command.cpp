// SPDX-License-Identifier: Apache-2.0
// The `panel` command: devices in real time on a bus, and a local page that shows and stimulates them.
#include "host/app/cli/panel_command.hpp"

#include <fmt/format.h>

#include <chrono>
#include <iostream>

#include "host/app/cli/prepared_run.hpp"
#include "host/app/panel/http_front.hpp"
#include "host/app/panel/panel.hpp"
#include "host/base/standard_streams.hpp"
#include "host/selection/built_in.hpp"
#include "host/sim/run/event_loop.hpp"

namespace canproof::host {

namespace {

/// Longest wait of the loop, so that the page shows the passing time even when nothing happens.
constexpr Duration longest_wait = milliseconds(50);

class PanelRun {
  public:
    explicit PanelRun(const PanelOptions& options)
        : panel_{built_in_register(), [this] { return now(); }},
          front_{[this](const PanelRequest& request) { return panel_.answer(request); }, options.port},
          prepared_{options.run, nullptr, &panel_.observer(),
                    [this](const std::string& text) { panel_.notice(text); }} {
        panel_.take(prepared_.session(), prepared_.parts());
    }

    void run() {
        prepared_.open_outputs();
        panel_.power_on();
        fmt::print("panel at {}  (Ctrl-C ends)\n", front_.address());
        finish_standard_output();
        while (!loop_.is_interrupted()) {
            panel_.advance_to(now());
            prepared_.tell_node_ids();
            prepared_.flush();
            front_.turn(now());
            wait();
        }
        prepared_.finish();
        if (const std::string summary = panel_.summary(); !summary.empty()) {
            tell(summary);
        }
    }

  private:
    Instant now() const {
        const auto passed = std::chrono::steady_clock::now() - start_;
        return Instant{
            static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(passed).count())};
    }

    void wait() {
        std::vector<Watch> watches = panel_.watches();
        const std::vector<Watch> clients = front_.watches();
        watches.insert(watches.end(), clients.begin(), clients.end());
        const Duration due = elapsed(now(), earliest(panel_.next_deadline(), front_.next_deadline()));
        loop_.wait(watches, due.us < longest_wait.us ? due : longest_wait);
    }

    EventLoop loop_;
    std::chrono::steady_clock::time_point start_{std::chrono::steady_clock::now()};
    Panel panel_;
    // must be constructed before prepared_, so that a port already in use is reported before any file is opened
    HttpFront front_;
    PreparedRun prepared_;
};

}  // namespace

int run_panel(const PanelOptions& options) {
    PanelRun{options}.run();
    return 0;
}

}  // namespace canproof::host
