// Two nodes on an interface that a false kernel plays.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/sim/bus/socketcan_bus.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"
#include "tests/host/sim/bus/fake_can_system.hpp"

namespace canproof::host::test {

/// Two nodes on vcan0. The run's clock begins at 1 s when real time is 5 s: 4 s apart.
class SocketCan : public testing::Test {
  protected:
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

    FakeCanSystem system;
    PlainNode a{"a"};
    PlainNode b{"b"};
    std::unique_ptr<SocketCanBus> bus;
    Instant now{};
    std::vector<std::string> log;
    std::vector<std::string> notices;
};

}  // namespace canproof::host::test
