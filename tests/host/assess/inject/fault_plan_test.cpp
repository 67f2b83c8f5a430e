// SPDX-License-Identifier: Apache-2.0
// Tests the choice of faults for an injection campaign: reproducible, and evenly spread over calls, bytes and bits.
#include "host/assess/inject/fault_plan.hpp"

#include <gtest/gtest.h>

#include <map>

namespace canproof::host::test {

namespace {

const std::vector<RegionSize> regions{{"device", 6}, {"queue", 2}};

using Fields = std::vector<std::vector<std::size_t>>;
Fields fields_of(const std::vector<InjectedFault>& faults) {
    Fields all;
    for (const InjectedFault& one : faults) {
        all.push_back({one.call, one.region, one.byte, one.bit});
    }
    return all;
}

}  // namespace

TEST(FaultPlan, SameSeedGivesTheSameFaults) {
    EXPECT_EQ(fields_of(plan_faults(7, 50, 10, regions)), fields_of(plan_faults(7, 50, 10, regions)));
    EXPECT_NE(fields_of(plan_faults(7, 50, 10, regions)), fields_of(plan_faults(8, 50, 10, regions)));
}

TEST(FaultPlan, EachCallByteAndBitIsDrawnAboutEquallyOftenForAFault) {
    // 6400 faults give on average 640 per call, 800 per byte and 800 per bit. The standard deviation of each number is
    // at most 27.
    std::map<std::size_t, int> calls;
    std::map<std::pair<std::size_t, std::size_t>, int> bytes;
    std::map<unsigned, int> bits;
    for (const InjectedFault& one : plan_faults(1, 6400, 10, regions)) {
        ASSERT_LT(one.byte, regions[one.region].bytes);
        ++calls[one.call];
        ++bytes[{one.region, one.byte}];
        ++bits[one.bit];
    }
    EXPECT_EQ(calls.size(), 10U);
    EXPECT_EQ(bytes.size(), 8U);
    EXPECT_EQ(bits.size(), 8U);
    for (const auto& [call, count] : calls) {
        EXPECT_NEAR(count, 640, 135) << call;
    }
    for (const auto& [place, count] : bytes) {
        EXPECT_NEAR(count, 800, 135) << place.first << ' ' << place.second;
    }
    for (const auto& [bit, count] : bits) {
        EXPECT_NEAR(count, 800, 135) << bit;
    }
}

TEST(FaultPlan, InjectedFaultsAreSortedByTheCallBeforeWhichTheyOccur) {
    std::size_t last = 0;
    for (const InjectedFault& one : plan_faults(3, 100, 20, regions)) {
        EXPECT_LE(last, one.call);
        last = one.call;
    }
}

TEST(FaultPlan, PlanForNoCallsOrNoBytesIsEmpty) {
    EXPECT_TRUE(plan_faults(1, 10, 0, regions).empty());
    EXPECT_TRUE(plan_faults(1, 10, 10, {}).empty());
    EXPECT_TRUE(plan_faults(1, 10, 10, {{"device", 0}}).empty());
}

}  // namespace canproof::host::test
