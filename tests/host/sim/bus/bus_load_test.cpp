// SPDX-License-Identifier: Apache-2.0
// The load of a bus over the last second: parts of busy periods, and what is forgotten.
#include "host/sim/bus/bus_load.hpp"

#include <gtest/gtest.h>

namespace canproof::host {

namespace {

constexpr std::uint64_t ms = 1000000;
constexpr std::uint64_t second = 1000 * ms;

double load_at(const BusLoad& load, std::uint64_t now) {
    return load.at(now, now);
}

}  // namespace

TEST(LoadOfABus, OnlyThePartWithinTheLastSecondCounts) {
    BusLoad load;
    load.add(2 * second, 2 * second + 400 * ms);
    EXPECT_DOUBLE_EQ(load_at(load, 2 * second), 0.0);  // it begins now
    EXPECT_DOUBLE_EQ(load_at(load, 2 * second + 100 * ms), 0.1);
    EXPECT_DOUBLE_EQ(load_at(load, 3 * second), 0.4);
    EXPECT_DOUBLE_EQ(load_at(load, 3 * second + 300 * ms), 0.1);
    EXPECT_DOUBLE_EQ(load_at(load, 3 * second + 400 * ms), 0.0);
    EXPECT_DOUBLE_EQ(load_at(load, second), 0.0);  // it has not begun yet
}

TEST(LoadOfABus, TimeBeforeTheStartDoesNotCount) {
    BusLoad load;
    EXPECT_DOUBLE_EQ(load_at(load, 0), 0.0);
    load.add(0, 100 * ms);
    EXPECT_DOUBLE_EQ(load_at(load, 0), 0.0);
    EXPECT_DOUBLE_EQ(load_at(load, 50 * ms), 1.0);
    EXPECT_DOUBLE_EQ(load_at(load, 500 * ms), 0.2);
}

TEST(LoadOfABus, PresentTransmissionCountsFromItsStart) {
    BusLoad load;
    load.add(2 * second, 2 * second + 100 * ms);
    EXPECT_DOUBLE_EQ(load.at(2 * second + 500 * ms, 2 * second + 300 * ms), 0.3);  // 100 ms and 200 ms
    EXPECT_DOUBLE_EQ(load.at(5 * second, 2 * second + 300 * ms), 1.0);
    EXPECT_DOUBLE_EQ(load.at(2 * second + 200 * ms, 2 * second + 300 * ms), 0.1);  // it has not begun yet
}

TEST(LoadOfABus, OverlappingPeriodsCountTwice) {
    BusLoad load;
    load.add(2 * second, 2 * second + 200 * ms);
    load.add(2 * second + 100 * ms, 2 * second + 200 * ms);
    EXPECT_DOUBLE_EQ(load_at(load, 3 * second), 0.3);
}

TEST(LoadOfABus, PeriodsOlderThanASecondAreForgotten) {
    BusLoad load;
    load.add(0, 100 * ms);
    load.add(200 * ms, 300 * ms);
    load.add(second + 100 * ms, second + 150 * ms);  // exactly a second after the end of the first period
    EXPECT_EQ(load.kept(), 3U);
    load.add(second + 100 * ms + 1, second + 150 * ms);
    EXPECT_EQ(load.kept(), 3U);
    load.add(5 * second, 6 * second);
    EXPECT_EQ(load.kept(), 1U);
}

}  // namespace canproof::host
