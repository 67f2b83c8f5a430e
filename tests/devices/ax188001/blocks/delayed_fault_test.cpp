// SPDX-License-Identifier: Apache-2.0
// Tests faults that have a delay and two thresholds (AX188001 manual, 1.1, 1.4, 3.4.16, 3.4.19, 3.4.21).
#include "devices/ax188001/firmware/delayed_fault.hpp"

#include <gtest/gtest.h>

#include "devices/ax188001/firmware/limit_condition.hpp"
#include "generated/ax188001/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax188001;

constexpr FaultCondition there{true, false};
constexpr FaultCondition between{false, false};
constexpr FaultCondition gone{false, true};
constexpr Duration second = milliseconds(1000);

constexpr Instant at(std::uint64_t ms) {
    return Instant{ms * 1000};
}

}  // namespace

TEST(DelayedFault, FaultIsReportedWhenItHasLastedForItsDelay) {
    verifies<req::TCS_LIM_003>();
    DelayedFault fault;
    fault.judge(there, second, at(100));
    EXPECT_FALSE(fault.told());
    EXPECT_EQ(fault.due(second), at(1100));
    fault.advance(second, at(1099));
    EXPECT_FALSE(fault.told());
    fault.advance(second, at(1100));
    EXPECT_TRUE(fault.told());
    EXPECT_EQ(fault.due(second), never);
}

TEST(DelayedFault, DelayRunsFromTheFirstMeasurementThatShowsTheFault) {
    verifies<req::TCS_LIM_003, req::TCS_LIM_012>();
    DelayedFault fault;
    fault.judge(there, second, at(100));
    fault.judge(there, second, at(600));
    EXPECT_EQ(fault.due(second), at(1100));
    fault.judge(between, second, at(700));  // between the thresholds, a fault that is not reported yet ends
    EXPECT_EQ(fault.due(second), never);
    fault.judge(there, second, at(800));
    EXPECT_EQ(fault.due(second), at(1800));
}

TEST(DelayedFault, FaultWithoutDelayIsReportedAtOnce) {
    verifies<req::TCS_LIM_015>();
    DelayedFault fault;
    fault.judge(there, Duration{}, at(5));
    EXPECT_TRUE(fault.told());
}

TEST(DelayedFault, FaultClearsAtOnceButNotBetweenTheThresholds) {
    verifies<req::TCS_LIM_004>();
    DelayedFault fault;
    fault.judge(there, Duration{}, at(0));
    fault.judge(between, second, at(1));
    EXPECT_TRUE(fault.told());
    fault.judge(gone, second, at(2));
    EXPECT_FALSE(fault.told());
}

TEST(DelayedFault, NewDelayRunsFromTheOriginalStartOfTheFault) {
    verifies<req::TCS_LIM_014>();
    DelayedFault fault;
    fault.judge(there, second, at(100));
    EXPECT_EQ(fault.due(milliseconds(300)), at(400));
    fault.advance(milliseconds(300), at(500));
    EXPECT_TRUE(fault.told());
}

TEST(DelayedFault, DroppingRemovesAPendingFaultAndClearingEndsAReportedFault) {
    verifies<req::TCS_LIM_006, req::TCS_LIM_018>();
    DelayedFault fault;
    fault.judge(there, second, at(0));
    fault.drop();
    EXPECT_EQ(fault.due(second), never);
    fault.judge(there, Duration{}, at(10));
    fault.drop();
    EXPECT_TRUE(fault.told());
    fault.clear();
    EXPECT_FALSE(fault.told());
}

TEST(LimitCondition, LimitFaultBeginsBeyondItsSetThresholdAndEndsAtItsClearThreshold) {
    verifies<req::TCS_LIM_001, req::TCS_LIM_002, req::TCS_FD_002, req::TCS_FD_008, req::TCS_FD_009, req::TCS_FD_003,
             req::TCS_FD_010, req::TCS_FD_011, req::TCS_FD_012, req::TCS_LIM_016, req::TCS_LIM_017>();
    EXPECT_FALSE(high_limit(125.0, 125.0, 124.0).begins);
    EXPECT_TRUE(high_limit(125.001, 125.0, 124.0).begins);
    EXPECT_FALSE(high_limit(124.001, 125.0, 124.0).ends);
    EXPECT_TRUE(high_limit(124.0, 125.0, 124.0).ends);
    EXPECT_FALSE(low_limit(-20.0, -20.0, -19.0).begins);
    EXPECT_TRUE(low_limit(-20.001, -20.0, -19.0).begins);
    EXPECT_FALSE(low_limit(-19.001, -20.0, -19.0).ends);
    EXPECT_TRUE(low_limit(-19.0, -20.0, -19.0).ends);
}

}  // namespace canproof::test
