// SPDX-License-Identifier: Apache-2.0
// The calls that a session makes of its bus, its devices and its observer, and their order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "host/sim/run/run_session.hpp"
#include "tests/host/sim/replay/recording_device.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;

/// A bus without frames that records the calls of the session. It takes a frame only while `takes` is true.
class RecordingBus final : public Bus {
  public:
    explicit RecordingBus(std::vector<std::string>& told) : told_{told} {}

    void attach(BusNode& node) override {
        const auto& device = static_cast<const DeviceNode&>(node).device();
        told_.push_back(node.name() + (device.next_deadline() == never ? " attached off" : " attached on"));
    }
    bool put(const Frame& frame, Instant) override {
        told_.push_back("put " + format_frame(frame));
        return takes;
    }
    std::vector<Watch> watches() const override { return {}; }
    Instant poll(Instant now) override { return now; }
    void advance(Instant now) override { told_.push_back("bus " + format_seconds(now)); }
    Instant next_deadline() const override { return never; }
    BusReport report(Instant) const override { return {}; }
    const std::string& interface() const override { return name_; }

    bool takes{true};

  private:
    std::vector<std::string>& told_;
    std::string name_{"recorded"};
};

/// Records each step, and whether the outputs of this time are written already.
class StepRecorder final : public SessionObserver {
  public:
    StepRecorder(std::vector<std::string>& told, const std::ostringstream& outputs) : told_{told}, outputs_{outputs} {}

    void on_frame(const BusFrame&) override {}
    void on_step(Instant at) override {
        const bool written = outputs_.str().find("\n" + format_seconds(at) + ",") != std::string::npos;
        told_.push_back("step " + format_seconds(at) + (written ? " written" : ""));
    }

  private:
    std::vector<std::string>& told_;
    const std::ostringstream& outputs_;
};

/// A session with recording devices that have work every 10 ms and every 25 ms.
class SessionOrder : public testing::Test {
  protected:
    void start(std::vector<Stimulus> stimuli) {
        auto made = std::make_unique<RecordingBus>(told);
        bus = made.get();
        std::vector<std::unique_ptr<DeviceNode>> nodes;
        for (const auto& [name, period] : {std::pair{"fast", 10U}, std::pair{"slow", 25U}}) {
            auto device = std::make_unique<RecordingDevice>(milliseconds(period));
            devices.push_back(device.get());
            nodes.push_back(std::make_unique<DeviceNode>(name, std::move(device)));
        }
        SessionOutputs to;
        to.outputs = &outputs;
        to.observer = &recorder;
        session = std::make_unique<RunSession>(std::move(made), std::move(nodes), std::move(stimuli), to);
        session->power_on();
    }

    std::vector<std::string> told;
    std::ostringstream outputs;
    StepRecorder recorder{told, outputs};
    RecordingBus* bus{nullptr};
    std::vector<RecordingDevice*> devices;
    std::unique_ptr<RunSession> session;
};

}  // namespace

TEST_F(SessionOrder, NodesAreAttachedAfterTheirPowerOn_AndTheFirstStepShowsTheOutputs) {
    start({});
    EXPECT_THAT(told, ElementsAre("fast attached on", "slow attached on", "bus 0.000000", "step 0.000000 written"));
}

TEST_F(SessionOrder, DueWorkPrecedesStimuli_AndTheObserverComesLast) {
    start({{"test", Instant{10000}, "fast.one", 1.0}});
    told.clear();
    session->advance_to(Instant{10000});
    EXPECT_THAT(devices[0]->told, ElementsAre("0.000000 on", "0.010000 due", "0.010000 one=1"));
    EXPECT_THAT(told, ElementsAre("bus 0.010000", "step 0.010000 written"));
}

TEST_F(SessionOrder, FrameThatTheBusRefusesIsReported) {
    start({});
    told.clear();
    EXPECT_TRUE(session->put(parse_frame("080#", "test")));
    bus->takes = false;
    EXPECT_FALSE(session->put(parse_frame("081#", "test")));
    EXPECT_THAT(told, ElementsAre("put 080#", "bus 0.000000", "step 0.000000 written", "put 081#", "bus 0.000000",
                                  "step 0.000000 written"));
}

TEST_F(SessionOrder, ChangedNodeDoesNotHideTheDeadlineOfAnother) {
    start({});
    EXPECT_EQ(session->next_deadline(), Instant{10000});
    session->nodes()[1]->device();  // asks for the slow device in order to change it
    EXPECT_EQ(session->next_deadline(), Instant{10000});
    session->nodes()[0]->device();
    EXPECT_EQ(session->next_deadline(), Instant{10000});
    session->advance_to(Instant{30000});
    EXPECT_EQ(session->now(), Instant{30000});
    EXPECT_EQ(session->next_deadline(), Instant{40000});
    EXPECT_THAT(devices[1]->told, ElementsAre("0.000000 on", "0.025000 due"));
}

}  // namespace canproof::host::test
