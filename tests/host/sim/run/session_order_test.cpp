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

/// A bus that records the calls of the session, and the outputs of its first node at each. It takes a frame only while
/// `takes` is true, and knows all arrivals only up to `known`.
class RecordingBus final : public Bus {
  public:
    explicit RecordingBus(std::vector<std::string>& told) : told_{told} {}

    void attach(BusNode& node) override {
        const auto& device = static_cast<const DeviceNode&>(node).device();
        told_.push_back(node.name() + (device.next_deadline() == never ? " attached off" : " attached on"));
        nodes.push_back(&node);
    }
    bool put(const Frame& frame, Instant) override {
        told_.push_back("put " + format_frame(frame));
        return takes;
    }
    std::vector<Watch> watches() const override { return {}; }
    Instant poll(Instant now) override { return earliest(now, known); }
    void advance(Instant now) override {
        const auto& first = static_cast<const DeviceNode&>(*nodes.front()).device();
        told_.push_back(fmt::format("bus {} one={}", format_seconds(now), first.outputs()[0]));
    }
    void pass(Instant now, const std::string& frame, const BusNode* sender) const {
        tell(BusFrame{now, parse_frame(frame, "test"), sender});
    }
    Instant next_deadline() const override { return never; }
    BusReport report(Instant) const override { return {}; }
    const std::string& interface() const override { return name_; }

    bool takes{true};
    Instant known{never};
    std::vector<const BusNode*> nodes;

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
    void start(std::vector<Stimulus> stimuli, const std::string& second_name = "slow") {
        auto made = std::make_unique<RecordingBus>(told);
        bus = made.get();
        std::vector<std::unique_ptr<DeviceNode>> nodes;
        for (const auto& [name, period] : {std::pair{std::string{"fast"}, 10U}, std::pair{second_name, 25U}}) {
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

TEST_F(SessionOrder, NodeIsAttachedToTheBusAfterPowerOn_AndTheFirstStepWritesOutputs) {
    start({});
    EXPECT_THAT(told,
                ElementsAre("fast attached on", "slow attached on", "bus 0.000000 one=0", "step 0.000000 written"));
}

TEST_F(SessionOrder, DueDeviceWorkPrecedesStimuli_AndTheObserverIsCalledLast) {
    start({{"test", Instant{10000}, "fast.one", 1.0}});
    told.clear();
    session->advance_to(Instant{10000});
    EXPECT_THAT(devices[0]->told, ElementsAre("0.000000 on", "0.010000 due", "0.010000 one=1"));
    EXPECT_THAT(told, ElementsAre("bus 0.010000 one=1", "step 0.010000 written"));
}

TEST_F(SessionOrder, FrameThatTheBusRefusesIsReported) {
    start({});
    told.clear();
    EXPECT_TRUE(session->put(parse_frame("080#", "test")));
    bus->takes = false;
    EXPECT_FALSE(session->put(parse_frame("081#", "test")));
    EXPECT_THAT(told, ElementsAre("put 080#", "bus 0.000000 one=0", "step 0.000000 written", "put 081#",
                                  "bus 0.000000 one=0", "step 0.000000 written"));
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

TEST_F(SessionOrder, RunDoesNotAdvanceBeyondTheTimeUpToWhichArrivalsAreKnown) {
    start({});
    bus->known = Instant{12000};
    session->advance_to(Instant{30000});
    EXPECT_EQ(session->now(), Instant{12000});
    EXPECT_THAT(devices[0]->told, ElementsAre("0.000000 on", "0.010000 due"));
}

TEST_F(SessionOrder, TrafficOfANodeCountsItsSentFramesAndKeepsTheLastFrame) {
    start({});
    bus->pass(Instant{1000}, "705#00", bus->nodes[0]);
    bus->pass(Instant{2000}, "705#7F", bus->nodes[0]);
    bus->pass(Instant{3000}, "080#", nullptr);
    const std::vector<NodeTraffic>& traffic = session->traffic();
    EXPECT_EQ(traffic[0].frames, 2U);
    ASSERT_TRUE(traffic[0].last);
    EXPECT_EQ(format_candump_line(*traffic[0].last), "(0.002000) recorded 705#7F");
    EXPECT_EQ(traffic[1].frames, 0U);
    EXPECT_FALSE(traffic[1].last);
}

TEST_F(SessionOrder, OutputsThatChangeAtOneTimeAreWrittenInTheOrderOfTheNodes) {
    start({{"test", Instant{1000}, "slow.two", 3.0}, {"test", Instant{1000}, "fast.two", 4.0}});
    outputs.str("");
    session->advance_to(Instant{1000});
    EXPECT_EQ(outputs.str(), "0.001000,fast.two,4\n0.001000,slow.two,3\n");
}

TEST_F(SessionOrder, LateStimulusIsAppliedNext_AndEachStimulusOnlyOnce) {
    start({{"test", Instant{1000}, "fast.one", 1.0}, {"test", Instant{5000}, "fast.one", 2.0}});
    session->advance_to(Instant{3000});
    session->schedule({"test", Instant{500}, "fast.two", 7.0});
    EXPECT_EQ(session->next_deadline(), Instant{500});
    session->advance_to(Instant{6000});
    EXPECT_THAT(devices[0]->told, ElementsAre("0.000000 on", "0.001000 one=1", "0.003000 two=7", "0.005000 one=2"));
}

TEST_F(SessionOrder, StimulusActsOnEachNodeWhoseNameItGives) {
    start({{"test", Instant{1000}, "fast.one", 1.0}}, "fast");
    session->advance_to(Instant{1000});
    EXPECT_THAT(devices[0]->told, ElementsAre("0.000000 on", "0.001000 one=1"));
    EXPECT_THAT(devices[1]->told, ElementsAre("0.000000 on", "0.001000 one=1"));
}

TEST_F(SessionOrder, AdvanceStoppedByItsCallerStillHandlesTheNextDueTime) {
    start({});
    session->advance_to(Instant{30000}, [] { return false; });
    EXPECT_EQ(session->now(), Instant{10000});
    session->advance_to(Instant{30000}, [] { return false; });
    EXPECT_EQ(session->now(), Instant{20000});
    EXPECT_THAT(devices[0]->told, ElementsAre("0.000000 on", "0.010000 due", "0.020000 due"));
}

TEST_F(SessionOrder, DueWorkOfAChangedNodePrecedesStimuliOfTheSameTime) {
    start({{"test", Instant{10000}, "fast.one", 1.0}});
    session->advance_to(Instant{5000});
    session->nodes()[0]->device();  // asks for the device in order to change it
    session->advance_to(Instant{10000});
    EXPECT_THAT(devices[0]->told, ElementsAre("0.000000 on", "0.010000 due", "0.010000 one=1"));
}

}  // namespace canproof::host::test
