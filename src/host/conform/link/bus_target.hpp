// SPDX-License-Identifier: Apache-2.0
// Connects the tester with a slave on a real bus, in real time.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "host/conform/link/target.hpp"
#include "host/conform/link/tester_node.hpp"
#include "host/sim/run/event_loop.hpp"

namespace canproof::host::conform {

class BusTarget final : public Target {
  public:
    /// Makes the target. `name` is the name of the bus, for example `socketcan:can0`.
    BusTarget(std::unique_ptr<Bus> bus, std::string name);

    Instant now() const override;
    void send(const Frame& frame) override;
    std::size_t waiting() const override { return tester_.waiting(); }
    void advance(Instant until) override;
    void go_on() override { loop_.forget_interruption(); }
    /// Lets the user switch the slave's power from now on: `say` prints what to do, and a line on `descriptor` confirms
    /// it.
    void switch_by_hand(int descriptor, std::function<void(const std::string&)> say);
    PowerSwitch power_switch() const override { return say_ ? PowerSwitch::hand : PowerSwitch::nobody; }
    void power(bool on) override;
    std::uint32_t bit_rate() const override { return report().bit_rate; }
    const std::string& name() const override { return name_; }
    BusReport report() const override { return bus_->report(now()); }

  private:
    void turn(Instant at);
    void wait(Instant until, std::vector<Watch> watches);
    bool line_came();

    EventLoop loop_;
    std::unique_ptr<Bus> bus_;
    std::string name_;
    TesterNode tester_;
    std::chrono::steady_clock::time_point start_;
    bool frame_seen_{false};
    int hand_{-1};
    std::function<void(const std::string&)> say_;
};

}  // namespace canproof::host::conform
