// SPDX-License-Identifier: Apache-2.0
// Tests that a device which does not do its due work ends a session with a message and does not block it.
#include "host/sim/devices/advance_device.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/replay/replay.hpp"
#include "host/sim/run/run_session.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;

/// Has work due at 1.5 s; `does` selects whether the work gets done.
class SlowDevice final : public SimulatedDevice {
  public:
    explicit SlowDevice(bool does) : SimulatedDevice{16}, does_{does} {}

    void set_node_id(NodeId) override {}
    void power_on(Instant) override { due_ = Instant{1500000}; }
    void receive(const Frame&, Instant) override {}
    void advance(Instant now) override { due_ = does_ && due_ <= now ? now + milliseconds(1000) : due_; }
    Instant next_deadline() const override { return due_; }
    bool set_input(const std::string&, double, Instant) override { return true; }
    std::vector<double> inputs() const override { return {}; }
    const std::vector<std::string>& input_names() const override { return no_names_; }
    std::vector<double> outputs() const override { return {}; }
    const std::vector<std::string>& output_names() const override { return no_names_; }
    std::uint8_t node_id() const override { return 5; }
    NmtState state() const override { return NmtState::operational; }
    std::uint32_t bit_rate() const override { return 0; }

  private:
    bool does_;
    Instant due_{never};
    std::vector<std::string> no_names_;
};

/// Returns the error message of a session of two seconds with a SlowDevice, or nothing when the session ends normally.
std::string said_of_run(bool does) {
    std::vector<std::unique_ptr<DeviceNode>> nodes;
    nodes.push_back(std::make_unique<DeviceNode>("valve@5", std::make_unique<SlowDevice>(does)));
    RunSession session{std::make_unique<ArbitratedBus>("inproc", 125000, BusFaultRates{}), std::move(nodes), {}, {}};
    session.power_on();
    try {
        session.advance_to(Instant{2000000});
    } catch (const StuckDevice& error) {
        return error.what();
    }
    EXPECT_EQ(session.next_deadline().us, 2500000U);  // 1.5 s + 1 s
    return "";
}

std::string said_of_replay(bool does) {
    SlowDevice device{does};
    ReplayInput input;
    input.until = Instant{2000000};
    std::ostringstream frames;
    try {
        replay(device, input, frames, nullptr);
    } catch (const StuckDevice& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(StuckDevice, RunEndsAndReportsNameAndTimeOfAStuckDevice) {
    const std::string said = said_of_run(false);
    EXPECT_THAT(said,
                HasSubstr("valve@5 does not advance at 1.500000 s: after advance(), its next_deadline() returns"));
    EXPECT_THAT(said, HasSubstr("next_deadline() returns 1.500000 s"));
    EXPECT_EQ(said_of_run(true), "");
}

TEST(StuckDevice, StuckDeviceEndsAReplay) {
    EXPECT_THAT(said_of_replay(false),
                HasSubstr("the device does not advance at 1.500000 s: after advance(), its next_deadline() returns"));
    EXPECT_EQ(said_of_replay(true), "");
}

}  // namespace canproof::host::test
