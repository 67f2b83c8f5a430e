// SPDX-License-Identifier: Apache-2.0
// Tests the lookup tables of the AX130751 (manual, 1.5).
#include "devices/ax130751/firmware/lookup_table.hpp"

#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/blocks/at.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax130751;

constexpr auto ramp = PointResponse::ramp;
constexpr auto jump = PointResponse::jump;
constexpr auto ignore = PointResponse::ignore;

/// Returns the default points: X and Y are 0, 10 … 100 (sections 3.4.44, 3.4.45).
LookupPoints defaults(PointResponse response) {
    LookupPoints points;
    for (std::size_t i = 0; i < lookup_points; ++i) {
        points.x[i] = 10.0 * static_cast<double>(i);
        points.y[i] = 10.0 * static_cast<double>(i);
        points.response[i] = response;
    }
    return points;
}

/// Returns a profile with intervals in ms: to 100 in 20 ms, constant for 30 ms, jump to 40 for 50 ms; the other points
/// are ignored.
LookupPoints short_profile() {
    LookupPoints profile;
    profile.x = {0.0, 20e3, 30e3, 50e3};
    profile.y = {0.0, 100.0, 100.0, 40.0};
    profile.response = {ignore, ramp, ramp, jump, ignore};
    return profile;
}

double after(std::uint64_t ms, const LookupPoints& profile, bool repeat = false) {
    return lookup_in_time(milliseconds(ms), profile_of(profile), repeat);
}

const BlockSignal input_on{1.0, 0.0, 1.0, SignalState::valid};
const BlockSignal input_off{0.0, 0.0, 1.0, SignalState::valid};

}  // namespace

TEST(LookupTable, RampsFollowFigure6) {
    verifies<req::AOR_LT_001, req::AOR_LT_002, req::AOR_LT_036, req::AOR_LT_037>();
    const auto points = defaults(ramp);
    EXPECT_DOUBLE_EQ(lookup(-5.0, points), 0.0);
    EXPECT_DOUBLE_EQ(lookup(0.0, points), 0.0);
    EXPECT_DOUBLE_EQ(lookup(3.0, points), 3.0);
    EXPECT_DOUBLE_EQ(lookup(10.0, points), 10.0);
    EXPECT_DOUBLE_EQ(lookup(97.5, points), 97.5);
    EXPECT_DOUBLE_EQ(lookup(100.0, points), 100.0);
    EXPECT_DOUBLE_EQ(lookup(500.0, points), 100.0);
}

TEST(LookupTable, LengthOfAProfileIsExactForShortAndLongTimes) {
    verifies<req::AOR_LT_022>();
    LookupPoints profile = defaults(ignore);
    profile.x[0] = 0.0;
    EXPECT_EQ(profile_length(profile).us, 0U);
    profile.x[0] = -0.0;
    EXPECT_EQ(profile_length(profile).us, 0U);
    profile.response[1] = ramp;
    // 10 x 24 h are 864,000,000,000 µs.
    for (const std::uint64_t us :
         {1ULL, 2ULL, 999ULL, 1000ULL, 1023ULL, 1024ULL, 864000000000ULL, (1ULL << 53U) - 1U}) {
        profile.x[1] = static_cast<double>(us);
        EXPECT_EQ(profile_length(profile).us, us);
    }
}

TEST(LookupTable, PointsBelowZeroAreInTheOrderOfTheirX) {
    verifies<req::AOR_LT_002>();
    LookupPoints points;
    points.x = {-40.0, -20.0, -10.0, 30.0};
    points.y = {0.0, 10.0, 40.0, 80.0};
    points.response = {ignore, ramp, ramp, ramp, ignore};
    EXPECT_DOUBLE_EQ(lookup(-30.0, points), 5.0);
    EXPECT_DOUBLE_EQ(lookup(-20.0, points), 10.0);
    EXPECT_DOUBLE_EQ(lookup(-15.0, points), 25.0);
    EXPECT_DOUBLE_EQ(lookup(-10.0, points), 40.0);
    EXPECT_DOUBLE_EQ(lookup(0.0, points), 50.0) << "a quarter of the way from (-10, 40) to (30, 80)";
}

TEST(LookupTable, OutputAtAPointIsExactlyTheYOfThePoint) {
    verifies<req::AOR_LT_002>();
    auto points = defaults(ramp);
    points.x[1] = 3.0;
    points.y[1] = 0.1;
    EXPECT_NE(3.0 * 0.1 / 3.0, 0.1);  // so a line from (0, 0) to (3, 0.1), computed at X = 3, does not give exactly 0.1
    EXPECT_EQ(lookup(3.0, points), 0.1);
}

TEST(LookupTable, StepsFollowFigure6) {
    verifies<req::AOR_LT_003, req::AOR_LT_019>();
    const auto points = defaults(jump);
    EXPECT_DOUBLE_EQ(lookup(0.0, points), 0.0);
    EXPECT_DOUBLE_EQ(lookup(0.1, points), 10.0);
    EXPECT_DOUBLE_EQ(lookup(10.0, points), 10.0) << "at X2 point 2 still holds";
    EXPECT_DOUBLE_EQ(lookup(10.1, points), 20.0);
    EXPECT_DOUBLE_EQ(lookup(99.0, points), 100.0);
    EXPECT_DOUBLE_EQ(lookup(101.0, points), 100.0);
}

TEST(LookupTable, PointsAreUnusedFromTheFirstIgnoredPointOn) {
    verifies<req::AOR_LT_004>();
    auto points = defaults(ramp);
    points.response[5] = ignore;  // point 6, at X = 50; points 7 to 11 still have the response ramp
    EXPECT_DOUBLE_EQ(lookup(35.0, points), 35.0);
    EXPECT_DOUBLE_EQ(lookup(40.0, points), 40.0);
    EXPECT_DOUBLE_EQ(lookup(41.0, points), 40.0);
    EXPECT_DOUBLE_EQ(lookup(100.0, points), 40.0);
    points.response[1] = ignore;
    EXPECT_DOUBLE_EQ(lookup(50.0, points), 0.0);
}

TEST(LookupTable, PointsOfEqualXGiveAJump) {
    verifies<req::AOR_LT_005, req::AOR_LT_020>();
    auto points = defaults(ramp);
    points.x[3] = 20.0;  // points 3 and 4 are both at X = 20
    points.y[2] = 5.0;
    points.y[3] = 80.0;
    EXPECT_DOUBLE_EQ(lookup(20.0, points), 5.0) << "the first of them holds at X itself";
    EXPECT_DOUBLE_EQ(lookup(30.0, points), 60.0) << "half way from (20, 80) to (40, 40)";
    EXPECT_DOUBLE_EQ(lookup(40.0, points), 40.0);
}

TEST(LookupTable, JoystickDeadbandFollowsFigure7) {
    verifies<req::AOR_LT_002, req::AOR_LT_003, req::AOR_LT_019, req::AOR_LT_004>();
    // The falling side of the joystick: 100 % at 0 V, 40 % at 1 V, 10 % at 2 V, and 0 % above 2 V.
    LookupPoints points;
    points.x = {0.0, 1.0, 2.0, 2.0, 5.0};
    points.y = {100.0, 40.0, 10.0, 0.0, 0.0};
    points.response = {ignore, ramp, ramp, jump, ramp, ignore};
    EXPECT_DOUBLE_EQ(lookup(0.5, points), 70.0);
    EXPECT_DOUBLE_EQ(lookup(1.5, points), 25.0);
    EXPECT_DOUBLE_EQ(lookup(2.0, points), 10.0);
    EXPECT_DOUBLE_EQ(lookup(2.01, points), 0.0);
    EXPECT_DOUBLE_EQ(lookup(4.0, points), 0.0);
}

TEST(LookupTable, OutputLimitsAreTheLowestAndTheHighestYOfAllPoints) {
    verifies<req::AOR_LT_006, req::AOR_LT_007>();
    auto points = defaults(ramp);
    points.response[2] = ignore;
    points.y[9] = -40.0;
    EXPECT_DOUBLE_EQ(lookup_limits(points).least, -40.0);
    EXPECT_DOUBLE_EQ(lookup_limits(points).greatest, 100.0);
}

TEST(LookupTable, TimeIntervalOfEachPointBeginsAtTheEndOfThePreviousOne) {
    verifies<req::AOR_LT_011, req::AOR_LT_012>();
    const auto profile = short_profile();
    EXPECT_DOUBLE_EQ(after(0, profile), 0.0);
    EXPECT_DOUBLE_EQ(after(5, profile), 25.0);
    EXPECT_DOUBLE_EQ(after(20, profile), 100.0);
    EXPECT_DOUBLE_EQ(after(50, profile), 100.0) << "at the end of a stretch its own point holds";
    EXPECT_DOUBLE_EQ(after(51, profile), 40.0);
    EXPECT_DOUBLE_EQ(after(100, profile), 40.0);
    EXPECT_DOUBLE_EQ(after(100'000, profile), 40.0) << "stays at the end";
    EXPECT_EQ(profile_length(profile_of(profile)).us, 100'000U);
}

TEST(LookupTable, TimeProfileStartsAtPoint1EvenWhenItsXIsNot0) {
    verifies<req::AOR_LT_023>();
    auto profile = short_profile();
    profile.x[0] = 7e3;
    EXPECT_DOUBLE_EQ(after(5, profile), 25.0);
    EXPECT_DOUBLE_EQ(after(20, profile), 100.0);
    EXPECT_EQ(profile_length(profile_of(profile)).us, 100'000U);
}

TEST(LookupTable, RepeatedTimeProfileContinuesFromItsLastPoint) {
    verifies<req::AOR_LT_013>();
    const auto profile = short_profile();  // its intervals are 100 ms together
    EXPECT_DOUBLE_EQ(after(0, profile, true), 0.0) << "at its start alone";
    EXPECT_DOUBLE_EQ(after(100, profile, true), 40.0);
    EXPECT_DOUBLE_EQ(after(101, profile, true), 5.0);
    EXPECT_DOUBLE_EQ(after(120, profile, true), 100.0);
    EXPECT_DOUBLE_EQ(after(200, profile, true), 40.0);
    EXPECT_DOUBLE_EQ(after(1'000'010, profile, true), 50.0);
}

TEST(LookupTable, TimeProfileOfTenDaysIsExactToTheMicrosecond) {
    verifies<req::AOR_LT_022>();
    auto profile = defaults(ramp);
    profile.x.fill(86'400'000e3);
    profile.x[0] = 0.0;
    const std::uint64_t day = 86'400'000;
    EXPECT_EQ(profile_length(profile_of(profile)).us, 864'000'000'000U);
    EXPECT_DOUBLE_EQ(after(day / 2, profile), 5.0);
    EXPECT_DOUBLE_EQ(after((9 * day) + (day / 4), profile), 92.5);
    EXPECT_DOUBLE_EQ(after(10 * day, profile), 100.0);
    EXPECT_DOUBLE_EQ(after((1000 * day) + (day / 10), profile, true), 1.0);
    // A microsecond before the end of the last interval, Y is 100 - 10 / 8.64e10.
    EXPECT_LT(lookup_in_time(microseconds(863'999'999'999U), profile_of(profile), false), 100.0);
}

TEST(LookupTable, Point1AppliesWhenAllOtherPointsAreIgnored) {
    verifies<req::AOR_LT_013>();
    EXPECT_DOUBLE_EQ(after(77, defaults(ignore), true), 0.0);
    EXPECT_EQ(profile_length(profile_of(defaults(ignore))).us, 0U);
}

TEST(LookupTable, TableWithoutSourceIsZeroAndNotAvailable) {
    verifies<req::AOR_LT_015>();
    LookupTable table;
    const LookupConfig config{LookupAxis::data, false, defaults(ramp)};
    EXPECT_DOUBLE_EQ(table.advance({60.0, 0.0, 100.0, SignalState::valid}, config, at(0)).value, 60.0);
    const auto output = table.advance({60.0, 0.0, 100.0, SignalState::not_available}, config, at(1));
    EXPECT_DOUBLE_EQ(output.value, 0.0);
    EXPECT_EQ(output.state, SignalState::not_available);
}

TEST(LookupTable, InputErrorIsPassedOnWithTheLastOutputValue) {
    verifies<req::AOR_LT_016, req::AOR_LT_025>();
    LookupTable table;
    const LookupConfig config{LookupAxis::data, false, defaults(ramp)};
    table.advance({60.0, 0.0, 100.0, SignalState::valid}, config, at(0));
    const auto output = table.advance({20.0, 0.0, 100.0, SignalState::error}, config, at(1));
    EXPECT_DOUBLE_EQ(output.value, 60.0);
    EXPECT_EQ(output.state, SignalState::error);
}

TEST(LookupTable, InputOnStartsTheTimeProfileAndInputOffStopsIt) {
    verifies<req::AOR_LT_010, req::AOR_LT_012, req::AOR_LT_029>();
    LookupTable table;
    const LookupConfig config{LookupAxis::time, false, profile_of(short_profile())};
    EXPECT_DOUBLE_EQ(table.advance(input_off, config, at(0)).value, 0.0);
    EXPECT_FALSE(table.is_running());
    EXPECT_DOUBLE_EQ(table.advance(input_on, config, at(1000)).value, 0.0);
    EXPECT_TRUE(table.is_running());
    EXPECT_DOUBLE_EQ(table.advance(input_on, config, at(1010)).value, 50.0);
    EXPECT_DOUBLE_EQ(table.advance(input_off, config, at(1011)).value, 0.0);
    EXPECT_DOUBLE_EQ(table.advance(input_on, config, at(1012)).value, 0.0) << "from the first point";
    EXPECT_DOUBLE_EQ(table.advance(input_on, config, at(1022)).value, 50.0);
    EXPECT_DOUBLE_EQ(table.advance(input_on, config, at(1111)).value, 40.0);
    EXPECT_TRUE(table.is_running()) << "1 ms before its end";
    EXPECT_DOUBLE_EQ(table.advance(input_on, config, at(1112)).value, 40.0);
    EXPECT_FALSE(table.is_running()) << "at its end";
    EXPECT_DOUBLE_EQ(table.advance(input_on, config, at(9000)).value, 40.0);
    EXPECT_FALSE(table.is_running());
}

TEST(LookupTable, RepeatedTimeProfileRunsUntilTheInputIsOff) {
    verifies<req::AOR_LT_013>();
    LookupTable table;
    const LookupConfig config{LookupAxis::time, true, profile_of(short_profile())};
    table.advance(input_on, config, at(0));
    EXPECT_DOUBLE_EQ(table.advance(input_on, config, at(510)).value, 50.0);
    EXPECT_TRUE(table.is_running());
    EXPECT_DOUBLE_EQ(table.advance(input_off, config, at(511)).value, 0.0);
    EXPECT_FALSE(table.is_running());
}

TEST(LookupTable, TimeProfileRestartsWhenTheTimeResponseIsSelectedAgain) {
    verifies<req::AOR_LT_010>();
    LookupTable table;
    const LookupConfig timed{LookupAxis::time, false, profile_of(short_profile())};
    table.advance(input_on, timed, at(0));
    EXPECT_DOUBLE_EQ(table.advance(input_on, timed, at(10)).value, 50.0);
    table.advance(input_on, {LookupAxis::data, false, defaults(ramp)}, at(11));
    EXPECT_FALSE(table.is_running());
    EXPECT_DOUBLE_EQ(table.advance(input_on, timed, at(12)).value, 0.0);
    EXPECT_DOUBLE_EQ(table.advance(input_on, timed, at(22)).value, 50.0);
}

TEST(LookupTable, InputErrorEndsARunningTimeProfile) {
    verifies<req::AOR_LT_016, req::AOR_LT_026, req::AOR_LT_030>();
    LookupTable table;
    const LookupConfig config{LookupAxis::time, false, profile_of(short_profile())};
    table.advance(input_on, config, at(0));
    BlockSignal failed = input_on;
    failed.state = SignalState::error;
    const auto output = table.advance(failed, config, at(10));
    EXPECT_DOUBLE_EQ(output.value, 0.0);
    EXPECT_EQ(output.state, SignalState::error);
    EXPECT_DOUBLE_EQ(table.advance(input_on, config, at(20)).value, 0.0);
    EXPECT_DOUBLE_EQ(table.advance(input_on, config, at(30)).value, 50.0);
}

TEST(LookupTable, TimeProfileDoesNotBeginWhenAnInputErrorEndsWithTheInputOff) {
    verifies<req::AOR_LT_029, req::AOR_LT_030>();
    LookupTable table;
    const LookupConfig config{LookupAxis::time, false, profile_of(short_profile())};
    table.advance(input_on, config, at(0));
    BlockSignal failed = input_on;
    failed.state = SignalState::error;
    table.advance(failed, config, at(10));
    table.advance(input_off, config, at(20));
    EXPECT_FALSE(table.is_running());
    EXPECT_DOUBLE_EQ(table.advance(input_off, config, at(30)).value, 0.0);
    EXPECT_DOUBLE_EQ(table.advance(input_on, config, at(40)).value, 0.0);
    EXPECT_DOUBLE_EQ(table.advance(input_on, config, at(50)).value, 50.0);
}

}  // namespace canproof::test
