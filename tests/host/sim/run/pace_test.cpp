// SPDX-License-Identifier: Apache-2.0
// Tests a run that keeps up with the clock, and one that does not. The clock is a number that the test advances.
#include "host/sim/run/pace.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/selection/chosen_devices.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/run/live_table.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

/// One device that sends a heartbeat every millisecond.
class PaceOfARun : public testing::Test {
  protected:
    PaceOfARun() {
        std::vector<std::unique_ptr<DeviceNode>> nodes;
        nodes.push_back(std::make_unique<DeviceNode>("cbx-ao412@3", choose_device("cbx-ao412@3").device));
        session = std::make_unique<RunSession>(std::make_unique<ArbitratedBus>("inproc", 1000000, BusFaultRates{}),
                                               std::move(nodes), std::vector<Stimulus>{}, SessionOutputs{});
        session->power_on();
        session->advance_to(Instant{10000});
        session->put(parse_frame("603#2B17100001000000", "test"));  // 1017h producer heartbeat time: 1 ms
        clock = Instant{10000};
    }
    void turn() { pace.advance(*session, clock); }

    Instant clock{};
    Duration cost{};  ///< time that passes at each reading of the clock, and so at each step
    std::vector<std::string> notices;
    Pace pace{[this] {
                  clock = clock + cost;
                  return clock;
              },
              [this](const std::string& text) { notices.push_back(text); }};
    std::unique_ptr<RunSession> session;
};

}  // namespace

TEST_F(PaceOfARun, RunThatKeepsUpReachesTheClockTimeInOneTurnOfItsLoop) {
    clock = Instant{5000000};
    turn();
    EXPECT_EQ(session->now(), Instant{5000000});
    EXPECT_EQ(pace.lag().us, 0U);
    EXPECT_THAT(notices, IsEmpty());
    EXPECT_EQ(pace.summary(), "");
}

TEST_F(PaceOfARun, TurnOfTheRunLoopEndsAfter50MsEvenIfWorkIsLeft) {
    clock = Instant{5000000};
    cost = milliseconds(5);  // far more than the millisecond that a step advances
    turn();
    // The first reading, ten steps of 5 ms, and the last reading: 60 ms.
    EXPECT_EQ(clock, Instant{5060000});
    EXPECT_LT(session->now(), Instant{100000});
    EXPECT_EQ(pace.lag().us, clock.us - session->now().us);
}

TEST_F(PaceOfARun, LagBehindTheClockAndItsEndAreEachReportedOnce) {
    clock = Instant{610000};
    cost = milliseconds(5);
    turn();
    EXPECT_THAT(notices, ElementsAre(HasSubstr("0.7 s behind the bus")));
    for (int i = 0; i < 20; ++i) {
        turn();
    }
    EXPECT_THAT(notices, SizeIs(1));
    cost = Duration{};
    turn();
    ASSERT_THAT(notices, SizeIs(2));
    EXPECT_EQ(notices[1], "the simulation has caught up with the bus");
    turn();
    EXPECT_THAT(notices, SizeIs(2));
    EXPECT_THAT(pace.summary(), HasSubstr("s behind the bus"));
}

TEST_F(PaceOfARun, ShortLagIsShownInTheTableAndNotReported) {
    clock = Instant{300000};
    cost = milliseconds(5);
    turn();
    EXPECT_GT(pace.lag().us, 0U);
    EXPECT_THAT(notices, IsEmpty());
    EXPECT_EQ(pace.summary(), "");
    EXPECT_THAT(table_lines(*session, {}, {200, 24}, pace.lag())[0], HasSubstr("0.3 s BEHIND"));
    EXPECT_THAT(table_lines(*session, {}, {200, 24})[0], Not(HasSubstr("BEHIND")));
}

}  // namespace canproof::host::test
