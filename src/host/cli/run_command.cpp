// run: devices in real time on the in-process bus. Frames are printed as candump does; lines `ID#DATA` on standard
// input go onto the bus.
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <iostream>

#include "host/bus/candump.hpp"
#include "host/cli/commands.hpp"
#include "host/devices/simulated_device.hpp"

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

class InProcessRun {
  public:
    explicit InProcessRun(const RunOptions& options) : start_{std::chrono::steady_clock::now()} {
        for (const auto& name : options.devices) {
            devices_.push_back(make_named(name));
        }
        if (options.seconds) {
            end_ = Instant{static_cast<std::uint64_t>(*options.seconds * 1.0e6)};
        }
    }

    void run() {
        for (auto& device : devices_) {
            device->power_on(now());
        }
        deliver();
        while (interrupted == 0 && now() < end_) {
            wait();
            for (auto& device : devices_) {
                device->advance(now());
            }
            deliver();
        }
    }

  private:
    Instant now() const {
        const auto passed = std::chrono::steady_clock::now() - start_;
        return Instant{
            static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(passed).count())};
    }

    void wait() {
        Instant due = end_;
        for (const auto& device : devices_) {
            due = earliest(due, device->next_deadline());
        }
        const auto milliseconds_left = due == never ? 1000 : elapsed(now(), due).us / 1000 + 1;
        pollfd input{STDIN_FILENO, POLLIN, 0};
        const int ready =
            poll(&input, input_open_ ? 1 : 0, static_cast<int>(std::min<std::uint64_t>(milliseconds_left, 1000)));
        if (ready > 0) {
            read_line();
        }
    }

    void read_line() {
        std::string line;
        if (!std::getline(std::cin, line)) {
            input_open_ = false;
            return;
        }
        if (line.empty()) {
            return;
        }
        try {
            put_on_bus(parse_frame(line, "standard input"), nullptr);
        } catch (const InputError& error) {
            fmt::print(stderr, "{}\n", error.what());
        }
    }

    void put_on_bus(const Frame& frame, const SimulatedDevice* sender) {
        fmt::print("{}\n", format_candump_line({now(), "inproc", frame}));
        std::fflush(stdout);
        for (auto& device : devices_) {
            if (device.get() != sender) {
                device->receive(frame, now());
            }
        }
    }

    void deliver() {
        // A frame may cause others; each pass sends one frame a device, so that none starves.
        for (bool any = true; any;) {
            any = false;
            for (auto& device : devices_) {
                if (!device->queue().empty()) {
                    put_on_bus(device->queue().pop(), device.get());
                    any = true;
                }
            }
        }
    }

    std::chrono::steady_clock::time_point start_;
    std::vector<std::unique_ptr<SimulatedDevice>> devices_;
    Instant end_{never};
    bool input_open_{true};
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
