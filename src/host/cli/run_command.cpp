// run: devices in real time on a bus. On a terminal a live table, elsewhere every frame as a candump line; lines
// `ID#DATA` on standard input go onto the bus.
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>

#include "host/bus/candump.hpp"
#include "host/cli/chosen_devices.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/files.hpp"
#include "host/cli/make_bus.hpp"
#include "host/run/event_loop.hpp"
#include "host/run/line_input.hpp"
#include "host/run/live_table.hpp"
#include "host/run/run_session.hpp"

namespace canproof::host {

namespace {

constexpr Duration table_period = milliseconds(200);
constexpr Duration longest_wait = milliseconds(1000);
constexpr std::size_t notices_kept = 20;

std::vector<ChosenDevice> chosen_devices(const RunOptions& options) {
    std::vector<ChosenDevice> all;
    for (const auto& text : options.devices) {
        all.push_back(choose_device(text));
    }
    for (const auto& text : options.eds) {
        all.push_back(choose_eds(text));
    }
    if (all.empty()) {
        all = choose_catalogue();
    }
    std::set<std::string> names;
    for (const ChosenDevice& one : all) {
        if (!names.insert(one.name).second) {
            throw InputError{fmt::format("{} is named twice; write NAME@NODE with different node-IDs", one.name)};
        }
    }
    return all;
}

std::ofstream open_output(const std::string& path) {
    std::ofstream out;
    if (!path.empty()) {
        out.open(path);
        if (!out) {
            throw InputError{fmt::format("cannot write {}; name a file in a folder that exists", path)};
        }
    }
    return out;
}

/// `device.signal` must name a device that runs; the rest is checked as without it.
void check_targets(const std::vector<Stimulus>& stimuli, const std::vector<ChosenDevice>& devices) {
    std::vector<const Part*> parts;
    for (const ChosenDevice& one : devices) {
        if (one.part != nullptr) {
            parts.push_back(one.part);
        }
    }
    for (Stimulus one : stimuli) {
        const auto point = one.signal.rfind('.');
        if (point == std::string::npos) {
            check_stimuli({one}, parts);
            continue;
        }
        const std::string name = one.signal.substr(0, point);
        const auto found =
            std::find_if(devices.begin(), devices.end(), [&](const auto& device) { return device.name == name; });
        if (found == devices.end() || found->part == nullptr) {
            throw InputError{fmt::format("{}: no device {} with signals runs here", one.where, name)};
        }
        one.signal = one.signal.substr(point + 1);
        check_stimuli({one}, {found->part});
    }
}

class Run {
  public:
    explicit Run(const RunOptions& options)
        : is_table_{isatty(STDOUT_FILENO) != 0 && !options.plain},
          nvm_folder_{options.nvm},
          log_{open_output(options.log)},
          outputs_{open_output(options.outputs)} {
        std::vector<ChosenDevice> devices = chosen_devices(options);
        std::vector<Stimulus> stimuli = read_stimulus_file(options.stimulus, devices);
        std::vector<std::unique_ptr<DeviceNode>> nodes;
        std::uint32_t bit_rate = 0;
        for (ChosenDevice& one : devices) {
            load_own_memory(one);
            bit_rate = bit_rate == 0 ? one.bit_rate : bit_rate;
            nodes.push_back(std::make_unique<DeviceNode>(one.name, std::move(one.device)));
        }
        std::unique_ptr<Bus> bus = make_bus(options, bit_rate);
        bus->on_notice([this](const std::string& text) { take_notice(text); });
        SessionOutputs outputs;
        outputs.frames = is_table_ ? nullptr : &std::cout;
        outputs.log = options.log.empty() ? nullptr : &log_;
        outputs.outputs = options.outputs.empty() ? nullptr : &outputs_;
        session_ = std::make_unique<RunSession>(std::move(bus), std::move(nodes), std::move(stimuli), outputs);
        if (options.seconds) {
            end_ = Instant{static_cast<std::uint64_t>(std::llround(*options.seconds * 1.0e6))};
        }
    }

    void run() {
        start_ = std::chrono::steady_clock::now();
        next_table_ = is_table_ ? Instant{} : never;
        session_->power_on();
        while (!loop_.is_interrupted() && session_->now() < end_) {
            session_->advance_to(earliest(now(), end_));
            put_lines();
            flush();
            show_table(false);
            wait();
        }
        show_table(true);
        tell_losses();
        save_memories();
        flush();
        for (const std::ofstream* file : {&log_, &outputs_}) {
            if (file->is_open() && !file->good()) {
                throw InputError{"the log or the outputs could not be written to their end; is the disk full?"};
            }
        }
    }

  private:
    Instant now() const {
        const auto passed = std::chrono::steady_clock::now() - start_;
        return Instant{
            static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(passed).count())};
    }

    std::string memory_file(const std::string& name) const {
        return (std::filesystem::path{nvm_folder_} / (name + ".bin")).string();
    }

    void load_own_memory(ChosenDevice& one) const {
        if (!nvm_folder_.empty()) {
            std::filesystem::create_directories(nvm_folder_);
            load_memory(one.device->memory(), memory_file(one.name));
        }
    }

    void save_memories() {
        for (const auto& node : session_->nodes()) {
            if (!nvm_folder_.empty()) {
                save_memory(node->device().memory(), memory_file(node->name()));
            }
        }
    }

    static std::vector<Stimulus> read_stimulus_file(const std::string& path, const std::vector<ChosenDevice>& devices) {
        if (path.empty()) {
            return {};
        }
        auto in = open_input(path);
        std::vector<Stimulus> stimuli = read_stimuli(in, path);
        check_targets(stimuli, devices);
        return stimuli;
    }

    void take_notice(const std::string& text) {
        if (!is_table_) {
            fmt::print(stderr, "{}\n", text);
        }
        notices_.push_back(text);
        if (notices_.size() > notices_kept) {
            notices_.erase(notices_.begin());
        }
    }

    void tell_losses() {
        const BusReport report = session_->bus().report(session_->now());
        if (report.lost != 0 || report.missed != 0) {
            take_notice(fmt::format("in all {} frames lost to the log, {} to the devices", report.lost, report.missed));
        }
    }

    void put_lines() {
        while (!lines_.empty()) {
            try {
                if (!session_->put(parse_frame(lines_.front(), "standard input"))) {
                    return;  // the bus is busy: the line waits, and with it standard input
                }
            } catch (const InputError& error) {
                take_notice(error.what());
            }
            lines_.pop_front();
        }
    }

    void wait() {
        std::vector<Watch> watches = session_->bus().watches();
        const bool reads_lines = input_.is_open() && lines_.empty();
        if (reads_lines) {
            watches.push_back({input_.descriptor(), true, false});
        }
        const Instant due = earliest(earliest(session_->next_deadline(), end_), next_table_);
        loop_.wait(watches, due == never ? longest_wait : elapsed(now(), due));
        if (reads_lines && loop_.is_ready(input_.descriptor())) {
            for (std::string& line : input_.read_lines()) {
                lines_.push_back(std::move(line));
            }
        }
    }

    void flush() {
        std::cout.flush();
        for (std::ofstream* file : {&log_, &outputs_}) {
            if (file->is_open()) {
                file->flush();
            }
        }
    }

    void show_table(bool last) {
        if (!is_table_ || (!last && now() < next_table_)) {
            return;
        }
        next_table_ = now() + table_period;
        winsize size{};
        const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0;
        const auto lines = table_lines(*session_, notices_, known ? TableSize{size.ws_col, size.ws_row} : TableSize{});
        std::string text = "\033[H";  // home; each line is cleared behind what it says, the rest of the screen below
        for (const std::string& line : lines) {
            text += line + "\033[K\n";
        }
        std::cout << text << "\033[J" << std::flush;
    }

    bool is_table_;
    std::string nvm_folder_;
    std::ofstream log_;
    std::ofstream outputs_;
    std::unique_ptr<RunSession> session_;
    std::vector<std::string> notices_;
    std::deque<std::string> lines_;
    Instant end_{never};
    Instant next_table_{never};  ///< never: no table
    EventLoop loop_;
    LineInput input_{STDIN_FILENO};
    std::chrono::steady_clock::time_point start_;
};

}  // namespace

int run_devices(const RunOptions& options) {
    Run{options}.run();
    return 0;
}

}  // namespace canproof::host
