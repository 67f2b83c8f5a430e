// SPDX-License-Identifier: Apache-2.0
// A test fixture with two nodes on an interface of a fake kernel.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/sim/bus/socketcan_bus.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"
#include "tests/host/sim/bus/fake_can_system.hpp"

namespace canproof::host::test {

/// Two nodes on vcan0. The clock of the run starts at 1 s when the real time is 5 s, so their offset is 4 s.
class SocketCan : public testing::Test {
  protected:
    /// Descriptors that the fake kernel gives to the sockets of the bus, of node `a` and of node `b`.
    static constexpr int monitor = 100;
    static constexpr int first = 101;
    static constexpr int second = 102;

    void start(InterfaceControl control = InterfaceControl::none) {
        bus = std::make_unique<SocketCanBus>("vcan0", system, control, Instant{1000000});
        bus->listen([this](const BusFrame& frame) {
            log.push_back(fmt::format("{} {} {}", frame.time.us, frame.sender == nullptr ? "-" : frame.sender->name(),
                                      format_frame(frame.frame)));
        });
        bus->on_notice([this](const std::string& text) { notices.push_back(text); });
        bus->attach(a);
        bus->attach(b);
        now = Instant{1000000};
    }
    /// Lets `us` pass on both clocks, then reads and acts.
    void step(std::uint64_t us) {
        now.us += us;
        system.realtime_us += us;
        bus->poll(now);
        bus->advance(now);
    }

    /// Starts the bus. 1 ms later, the monitor has read frames of 100 us, 300 us and 500 us after the start.
    void start_with_three_frames() {
        start();
        now.us += 1000;
        system.realtime_us += 1000;
        for (const std::uint64_t us : {5000100U, 5000300U, 5000500U}) {
            system.arrive(monitor, "080#", us);
        }
        bus->poll(now);
    }

    FakeCanSystem system;
    PlainNode a{"a"};
    PlainNode b{"b"};
    std::unique_ptr<SocketCanBus> bus;
    Instant now{};
    std::vector<std::string> log;
    std::vector<std::string> notices;
};

}  // namespace canproof::host::test
