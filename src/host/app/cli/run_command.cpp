// SPDX-License-Identifier: Apache-2.0
// The `run` command: devices in real time on a bus. On a terminal it shows a live table; otherwise, and with --plain,
// it shows every frame as a candump line. It sends lines `ID#DATA` from standard input on the bus.
#include "host/app/cli/run_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <deque>
#include <iostream>

#include "firmware/base/time.hpp"
#include "host/app/cli/prepared_run.hpp"
#include "host/base/input_error.hpp"
#include "host/base/standard_streams.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/run/event_loop.hpp"
#include "host/sim/run/line_input.hpp"
#include "host/sim/run/live_table.hpp"
#include "host/sim/run/pace.hpp"

namespace canproof::host {

namespace {

constexpr Duration table_period = milliseconds(200);
constexpr Duration longest_wait = milliseconds(1000);
constexpr std::size_t notices_kept = 20;

/// Returns whether the file of the descriptor has the type `kind`, which is S_IFIFO (pipe) or S_IFDIR (folder).
bool is(mode_t kind, int descriptor) {
    struct stat found {};
    return fstat(descriptor, &found) == 0 && (found.st_mode & S_IFMT) == kind;
}

class Run {
  public:
    explicit Run(const RunOptions& options)
        : is_table_{isatty(STDOUT_FILENO) != 0 && !options.plain},
          prepared_{options, is_table_ ? nullptr : &std::cout, nullptr,
                    [this](const std::string& text) { take_notice(text); }},
          session_{prepared_.session()} {
        if (options.seconds) {
            end_ = Instant{static_cast<std::uint64_t>(std::llround(*options.seconds * 1.0e6))};
        }
    }

    void run() {
        start_ = std::chrono::steady_clock::now();
        next_table_ = is_table_ ? Instant{} : never;
        prepared_.open_outputs();
        session_.bus().use_clock([this] { return now(); });
        session_.power_on();
        name_devices();
        while (!loop_.is_interrupted() && !output_ended_ && session_.now() < end_) {
            pace_.advance(session_, earliest(now(), end_));
            prepared_.tell_node_ids();
            put_lines();
            flush();
            show_table(false);
            wait();
        }
        tell_losses();
        show_table(true);
        prepared_.finish();
        if (output_ended_ && std::cout) {
            throw InputError{
                "standard output cannot be written, because its reader has ended; let the reader run longer, or write "
                "to a file"};
        }
    }

  private:
    Instant now() const {
        const auto passed = std::chrono::steady_clock::now() - start_;
        return Instant{
            static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(passed).count())};
    }

    /// Prints the node-IDs of the devices, unless the run shows the live table, which contains them.
    void name_devices() const {
        if (!is_table_) {
            tell(fmt::format("{}", fmt::join(node_id_lines(session_.nodes()), "\n")));
        }
    }

    void take_notice(const std::string& text) {
        if (!is_table_) {
            tell(text);
        }
        notices_.push_back(text);
        if (notices_.size() > notices_kept) {
            notices_.erase(notices_.begin());
        }
    }

    void tell_losses() {
        const BusReport report = session_.bus().report(session_.now());
        if (!pace_.summary().empty()) {
            take_notice(pace_.summary());
        }
        if (report.lost != 0 || report.missed != 0) {
            take_notice(fmt::format("in total {} frames were lost for the log, and {} for the devices", report.lost,
                                    report.missed));
        }
    }

    void put_lines() {
        while (!lines_.empty()) {
            try {
                if (!session_.put(parse_frame(lines_.front(), "standard input"))) {
                    return;  // the bus is busy: the line is sent later, and the program reads no further input
                }
            } catch (const InputError& error) {
                take_notice(error.what());
                if (lines_.front().rfind('(', 0) == 0) {
                    take_notice(
                        "a line of a log has a time and an interface; write the frame alone: 603#4000100000000000");
                }
            }
            lines_.pop_front();
        }
    }

    void wait() {
        std::vector<Watch> watches = session_.bus().watches();
        if (is_piped_) {
            watches.push_back({STDOUT_FILENO, false, false});
        }
        const bool reads_lines = input_.is_open() && lines_.empty();
        if (reads_lines) {
            watches.push_back({input_.descriptor(), true, false});
        }
        const Instant due = earliest(earliest(session_.next_deadline(), end_), next_table_);
        loop_.wait(watches, due == never ? longest_wait : elapsed(now(), due));
        // If standard output is a pipe, its descriptor becomes ready in this wait only when the reader has closed the
        // pipe.
        output_ended_ = output_ended_ || (is_piped_ && loop_.is_ready(STDOUT_FILENO));
        if (reads_lines && loop_.is_ready(input_.descriptor())) {
            for (std::string& line : input_.read_lines()) {
                lines_.push_back(std::move(line));
            }
        }
    }

    void flush() {
        output_ended_ = output_ended_ || !std::cout.flush();
        prepared_.flush();
    }

    void show_table(bool last) {
        if (!is_table_ || (!last && now() < next_table_)) {
            return;
        }
        next_table_ = now() + table_period;
        winsize size{};
        const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0;
        const auto lines =
            table_lines(session_, notices_, known ? TableSize{size.ws_col, size.ws_row} : TableSize{}, pace_.lag());
        // \033[H moves the cursor to the top left, \033[K clears the rest of a line, and \033[J clears the screen below
        std::string text = "\033[H";
        for (const std::string& line : lines) {
            text += line + "\033[K\n";
        }
        std::cout << text << "\033[J" << std::flush;
    }

    bool is_table_;
    bool is_piped_{is(S_IFIFO, STDOUT_FILENO)};
    bool output_ended_{false};
    std::vector<std::string> notices_;
    PreparedRun prepared_;
    RunSession& session_;
    Pace pace_{[this] { return now(); }, [this](const std::string& text) { take_notice(text); }};
    std::deque<std::string> lines_;
    Instant end_{never};
    Instant next_table_{never};  ///< time of the next update of the live table; never: the run shows no table
    EventLoop loop_;
    LineInput input_{STDIN_FILENO};
    std::chrono::steady_clock::time_point start_;
};

}  // namespace

int run_devices(const RunOptions& options) {
    if (is(S_IFDIR, STDIN_FILENO)) {
        throw InputError{
            "standard input is a folder; redirect it from a file with lines such as 603#4000100000000000, or from "
            "/dev/null"};
    }
    Run{options}.run();
    return 0;
}

}  // namespace canproof::host
