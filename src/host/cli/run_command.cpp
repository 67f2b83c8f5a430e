// run: devices in real time on the in-process bus. Frames are printed as candump does; lines `ID#DATA` on standard
// input go onto the bus.
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "host/bus/candump.hpp"
#include "host/cli/built_in.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/files.hpp"
#include "host/devices/simulated_device.hpp"
#include "host/replay/stimulus.hpp"

namespace canproof::host {

namespace {

volatile std::sig_atomic_t interrupted = 0;

std::unique_ptr<SimulatedDevice> make_named(const std::string& text) {
    const auto at = text.find('@');
    auto device = make_device(text.substr(0, at));
    if (device == nullptr) {
        throw InputError{fmt::format("{} cannot be run; `canproof devices` says which can", text.substr(0, at))};
    }
    if (at != std::string::npos) {
        const std::string node = text.substr(at + 1);
        if (node.empty() || node.size() > 3 || node.find_first_not_of("0123456789") != std::string::npos ||
            std::stoi(node) > 255) {
            throw InputError{fmt::format("`{}` is no node-ID; write NAME@1 … NAME@127", node)};
        }
        device->set_node_id(std::stoi(node));
    }
    return device;
}

/// Lines of standard input as they come, without ever waiting for the rest of one.
class LineInput {
  public:
    bool is_open() const { return open_; }

    /// Whole lines that have arrived; call when poll() says that there is input.
    std::vector<std::string> read_lines() {
        std::array<char, 4096> piece{};
        const ssize_t count = read(STDIN_FILENO, piece.data(), piece.size());
        if (count <= 0) {
            open_ = false;
            return {};
        }
        pending_.append(piece.data(), static_cast<std::size_t>(count));
        std::vector<std::string> lines;
        for (auto end = pending_.find('\n'); end != std::string::npos; end = pending_.find('\n')) {
            lines.push_back(pending_.substr(0, end));
            pending_.erase(0, end + 1);
        }
        if (pending_.size() > longest_line) {
            pending_.clear();
        }
        return lines;
    }

  private:
    static constexpr std::size_t longest_line = 4096;
    std::string pending_;
    bool open_{true};
};

class InProcessRun {
  public:
    explicit InProcessRun(const RunOptions& options)
        : start_{std::chrono::steady_clock::now()}, nvm_folder_{options.nvm} {
        for (const auto& name : options.devices) {
            devices_.push_back({name, make_named(name), {}});
        }
        if (options.seconds) {
            end_ = Instant{static_cast<std::uint64_t>(*options.seconds * 1.0e6)};
        }
        if (!options.stimulus.empty()) {
            auto in = open_input(options.stimulus);
            stimuli_ = read_stimuli(in, options.stimulus);
            std::vector<const Part*> parts;
            for (const auto& name : options.devices) {
                parts.push_back(&device_named(name.substr(0, name.find('@'))));
            }
            check_stimuli(stimuli_, parts);
        }
        if (!options.outputs.empty()) {
            outputs_.open(options.outputs);
            if (!outputs_) {
                throw InputError{fmt::format("cannot write {}", options.outputs)};
            }
            outputs_ << "seconds,signal,value\n";
        }
        load_memories();
    }

    void run() {
        stimulate();
        for (auto& one : devices_) {
            one.device->power_on(now());
        }
        deliver();
        while (interrupted == 0 && now() < end_) {
            wait();
            stimulate();
            for (auto& one : devices_) {
                one.device->advance(now());
            }
            deliver();
        }
        for (auto& one : devices_) {
            if (!nvm_folder_.empty()) {
                save_memory(one.device->memory(), memory_file(one.name));
            }
        }
    }

  private:
    struct Running {
        std::string name;
        std::unique_ptr<SimulatedDevice> device;
        std::vector<double> last_outputs;
    };

    Instant now() const {
        const auto passed = std::chrono::steady_clock::now() - start_;
        return Instant{
            static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(passed).count())};
    }

    std::string memory_file(const std::string& name) const {
        return (std::filesystem::path{nvm_folder_} / (name + ".bin")).string();
    }

    void load_memories() {
        if (nvm_folder_.empty()) {
            return;
        }
        std::filesystem::create_directories(nvm_folder_);
        for (auto& one : devices_) {
            load_memory(one.device->memory(), memory_file(one.name));
        }
    }

    void wait() {
        Instant due = end_;
        for (const auto& one : devices_) {
            due = earliest(due, one.device->next_deadline());
        }
        if (next_stimulus_ < stimuli_.size()) {
            due = earliest(due, stimuli_[next_stimulus_].time);
        }
        const std::uint64_t longest_ms = 1000;
        const std::uint64_t left_ms = due == never ? longest_ms : (elapsed(now(), due).us + 999) / 1000;
        pollfd input{STDIN_FILENO, POLLIN, 0};
        if (poll(&input, input_.is_open() ? 1 : 0, static_cast<int>(std::min(left_ms, longest_ms))) > 0) {
            for (const auto& line : input_.read_lines()) {
                put_line_on_bus(line);
            }
        }
    }

    void put_line_on_bus(const std::string& line) {
        if (line.empty()) {
            return;
        }
        try {
            put_on_bus(parse_frame(line, "standard input"), nullptr);
        } catch (const InputError& error) {
            fmt::print(stderr, "{}\n", error.what());
        }
    }

    /// Stimuli act on every device that has the signal.
    void stimulate() {
        for (; next_stimulus_ < stimuli_.size() && stimuli_[next_stimulus_].time <= now(); ++next_stimulus_) {
            const Stimulus& stimulus = stimuli_[next_stimulus_];
            for (auto& one : devices_) {
                one.device->set_input(stimulus.signal, stimulus.value, now());  // false where a device lacks it
            }
        }
    }

    void put_on_bus(const Frame& frame, const SimulatedDevice* sender) {
        fmt::print("{}\n", format_candump_line({now(), "inproc", frame}));
        std::fflush(stdout);
        for (auto& one : devices_) {
            if (one.device.get() != sender) {
                one.device->receive(frame, now());
            }
        }
    }

    void deliver() {
        // A frame may cause others; each pass sends one frame a device, so that none starves.
        for (bool any = true; any;) {
            any = false;
            for (auto& one : devices_) {
                if (!one.device->queue().empty()) {
                    put_on_bus(one.device->queue().pop(), one.device.get());
                    any = true;
                }
            }
        }
        write_outputs();
    }

    /// With several devices a signal is named `device.signal`.
    void write_outputs() {
        for (auto& one : devices_) {
            const auto values = one.device->outputs();
            for (std::size_t i = 0; outputs_.is_open() && i < values.size(); ++i) {
                if (one.last_outputs.empty() || one.last_outputs[i] != values[i]) {
                    const std::string prefix = devices_.size() > 1 ? one.name + "." : "";
                    outputs_ << fmt::format("{},{}{},{:.6g}\n", format_seconds(now()), prefix,
                                            one.device->output_names()[i], values[i]);
                }
            }
            one.last_outputs = values;
        }
        outputs_.flush();
    }

    std::chrono::steady_clock::time_point start_;
    std::string nvm_folder_;
    std::vector<Running> devices_;
    std::vector<Stimulus> stimuli_;
    std::size_t next_stimulus_{0};
    std::ofstream outputs_;
    Instant end_{never};
    LineInput input_;
};

}  // namespace

int run_devices(const RunOptions& options) {
    if (options.bus != "inproc") {
        throw InputError{
            fmt::format("bus `{}` is not offered; this version has the in-process bus (--bus inproc)", options.bus)};
    }
    std::signal(SIGINT, [](int) { interrupted = 1; });
    std::signal(SIGTERM, [](int) { interrupted = 1; });
    InProcessRun{options}.run();
    return 0;
}

}  // namespace canproof::host
