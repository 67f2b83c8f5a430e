// panel: devices in real time on a bus, and one local page that shows them and acts on them.
#include <fmt/format.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <chrono>
#include <iostream>

#include "host/cli/built_in.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/prepared_run.hpp"
#include "host/cli/standard_streams.hpp"
#include "host/panel/panel_server.hpp"
#include "host/run/event_loop.hpp"

namespace canproof::host {

namespace {

/// The page sees time pass even where nothing happens.
constexpr Duration longest_wait = milliseconds(50);

/// Ends the loop's wait from another thread.
class Bell {
  public:
    Bell() : descriptor_{eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)} {}
    ~Bell() { close(descriptor_); }
    Bell(const Bell&) = delete;
    Bell& operator=(const Bell&) = delete;

    int descriptor() const { return descriptor_; }
    void ring() const { static_cast<void>(eventfd_write(descriptor_, 1U)); }
    void silence() const {
        eventfd_t count = 0;
        static_cast<void>(eventfd_read(descriptor_, &count));
    }

  private:
    int descriptor_;
};

class PanelRun {
  public:
    explicit PanelRun(const PanelOptions& options)
        : panel_{built_in_register(), [this] { return now(); }, [this] { bell_.ring(); }},
          prepared_{options.run, nullptr, &panel_.observer(),
                    [this](const std::string& text) { panel_.notice(text); }} {
        panel_.take(prepared_.session(), prepared_.parts());
        port_ = options.port;
    }

    void run() {
        const PanelServer server{panel_, port_};
        prepared_.open_outputs();
        panel_.power_on();
        fmt::print("panel at {}  (Ctrl-C ends)\n", server.address());
        finish_standard_output();
        while (!loop_.is_interrupted()) {
            panel_.advance_to(now());
            panel_.alone([this] {
                prepared_.tell_node_ids();
                prepared_.flush();
            });
            wait();
        }
        panel_.alone([this] { prepared_.finish(); });
        if (const std::string told = panel_.summary(); !told.empty()) {
            fmt::print(stderr, "{}\n", told);
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
        watches.push_back({bell_.descriptor(), true, false});
        const Duration due = elapsed(now(), panel_.next_deadline());
        loop_.wait(watches, due.us < longest_wait.us ? due : longest_wait);
        bell_.silence();
    }

    EventLoop loop_;  // before the server's threads, which inherit its signal mask
    Bell bell_;
    std::chrono::steady_clock::time_point start_{std::chrono::steady_clock::now()};
    Panel panel_;
    PreparedRun prepared_;
    std::uint16_t port_{0};
};

}  // namespace

int run_panel(const PanelOptions& options) {
    PanelRun{options}.run();
    return 0;
}

}  // namespace canproof::host
