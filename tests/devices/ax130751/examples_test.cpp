// SPDX-License-Identifier: Apache-2.0
// Tests the examples of the AX130751 manual on the whole device. They are a joystick with a deadband (section 1.5.3,
// Figure 7), a joystick trimmed by a potentiometer (section 1.7), and 30 slopes from three lookup tables (sections 1.5,
// 1.6).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751Examples : public Ax130751Test {
  protected:
    void SetUp() override {
        Ax130751Test::SetUp();
        start();
    }
    void put(std::uint16_t index, int sub, std::int64_t value, int bytes) {
        EXPECT_EQ(write(index, sub, value, bytes), "") << std::hex << index << ":" << sub;
    }
    /// Sets the range of extra received value `number`: 0 to `greatest_tenths`, in tenths.
    void declare_extra(int number, int greatest_tenths) { put(0x2522, number, greatest_tenths, 2); }
    void receive_extra(int number, int tenths) {
        put(0x2500, number, tenths, 2);
        pass(20);
    }
    /// Makes extra received value 1 the input of the lookup table whose objects begin at index `base`.
    void read_extra_1(std::uint16_t base) {
        put(base, 0, 1, 1);
        put(static_cast<std::uint16_t>(base + 1), 0, 4, 1);
    }
    /// Writes X from point 11 down to 1, as section 1.5.1 recommends, then Y from point 1 on. Points after the last
    /// given point get the X of that point and are ignored.
    void put_points(std::uint16_t base, const std::vector<std::pair<int, int>>& points) {
        const auto at = [base](int offset) { return static_cast<std::uint16_t>(base + offset); };
        const int count = static_cast<int>(points.size());
        for (int point = 11; point >= 1; --point) {
            put(at(6), point, points[static_cast<std::size_t>(std::min(point, count) - 1)].first, 4);
        }
        for (int point = 1; point <= count; ++point) {
            put(at(7), point, points[static_cast<std::size_t>(point - 1)].second, 2);
        }
        if (count < 11) {
            put(at(5), count + 1, 0, 1);
        }
    }
    double volts(int output) const { return device->outputs().out_voltage[static_cast<std::size_t>(output - 1)]; }
};

}  // namespace

// Section 1.5.3: "mirrored" profiles with two slopes on each side of the centre, from the same input
TEST_F(Ax130751Examples, JoystickWithDeadbandDrivesTwoOutputs) {
    verifies<req::AOR_LT_001, req::AOR_LT_002, req::AOR_LT_004, req::AOR_LT_007, req::AOR_OUT_003, req::AOR_OUT_006>();
    declare_extra(1, 1000);
    read_extra_1(0x3010);
    read_extra_1(0x3020);
    put_points(0x3010, {{0, 0}, {55, 0}, {75, 30}, {100, 100}});
    put_points(0x3020, {{0, 100}, {25, 30}, {45, 0}, {100, 0}});
    for (int output = 1; output <= 2; ++output) {
        put(0x2340, output, 3, 1);
        put(0x2341, output, output, 1);
        put(0x2342, output, 0, 1);  // single output profile
        put(0x6302, output, 0, 1);
        put(0x7322, output, 100, 2);
        put(0x7323, output, 10000, 2);
        put(0x2330, output, 0, 2);
        put(0x2331, output, 0, 2);
    }
    struct Position {
        int tenths;
        double forward;
        double backward;
    };
    const std::vector<Position> positions{
        {0, 0.0, 10.0},    // full backward
        {125, 0.0, 6.5},   // output 2 is half way between 100 and 30 %
        {250, 0.0, 3.0},   // here the two slopes meet, at 30 %
        {350, 0.0, 1.5},   // output 2 is half way between 30 and 0 %
        {450, 0.0, 0.0},   // the deadband begins
        {500, 0.0, 0.0},   // centre
        {550, 0.0, 0.0},   // the deadband ends
        {650, 1.5, 0.0},   //
        {750, 3.0, 0.0},   //
        {875, 6.5, 0.0},   //
        {1000, 10.0, 0.0}  // full forward
    };
    for (const Position& position : positions) {
        receive_extra(1, position.tenths);
        EXPECT_NEAR(volts(1), position.forward, 0.001) << position.tenths;
        EXPECT_NEAR(volts(2), position.backward, 0.001) << position.tenths;
    }
}

// Section 1.7: the joystick has a gain of 0.75, the potentiometer one of 0.25
TEST_F(Ax130751Examples, PotentiometerTrimsAJoystick) {
    verifies<req::AOR_OD_4140>();
    declare_extra(1, 1000);
    declare_extra(2, 1000);
    put(0x4000, 1, 1, 1);
    for (int input = 1; input <= 2; ++input) {
        put(0x4100, input, 1, 1);
        put(0x4101, input, 3 + input, 1);
        put(0x4103, input, 1, 1);     // the scaling of the input has one decimal digit
        put(0x4122, input, 1000, 2);  // the upper scaling is 100.0
    }
    put(0x4140, 1, 75, 1);
    put(0x4140, 2, 25, 1);
    put(0x4150, 1, 12, 1);  // operator 12: plus
    struct Command {
        int joystick;
        int potentiometer;
        std::uint64_t hundredths;
    };
    const std::vector<Command> commands{{0, 0, 0},        {1000, 0, 7500},   {0, 1000, 2500}, {1000, 1000, 10000},
                                        {500, 500, 5000}, {1000, 500, 8750}, {200, 800, 3500}};
    for (const Command& command : commands) {
        receive_extra(1, command.joystick);
        receive_extra(2, command.potentiometer);
        EXPECT_EQ(read(0x4030, 1), command.hundredths) << command.joystick << " " << command.potentiometer;
    }
}

// Sections 1.5, 1.6: each of three tables covers a part of the input's range; extra received values 2 and 3 are the
// borders between the parts
TEST_F(Ax130751Examples, LogicBlockWithThreeLookupTablesGivesACurveOfThirtySegments) {
    verifies<req::AOR_LT_001, req::AOR_LT_002, req::AOR_OD_3310, req::AOR_OD_3320>();
    for (int number = 1; number <= 3; ++number) {
        declare_extra(number, 3000);
    }
    receive_extra(2, 1000);
    receive_extra(3, 2000);
    // 31 points, whose X are 10.0 apart. Y rises by 3 % per point; every second point is 5 % higher.
    const auto x = [](int point) { return 100 * point; };                             // X in tenths
    const auto y = [](int point) { return 30 * point + (point % 2 == 1 ? 50 : 0); };  // Y in tenths of a percent
    for (int table = 0; table < 3; ++table) {
        const auto base = static_cast<std::uint16_t>(0x3010 + 0x10 * table);
        put(static_cast<std::uint16_t>(base + 3), 0, 1, 1);
        put(static_cast<std::uint16_t>(base + 4), 0, 1, 1);
        read_extra_1(base);
        std::vector<std::pair<int, int>> points;
        for (int point = 10 * table; point <= 10 * table + 10; ++point) {
            points.emplace_back(x(point), y(point));
        }
        put_points(base, points);
    }
    put(0x3300, 1, 1, 1);
    const auto below = [this](std::uint16_t condition, int border) {
        put(condition, 1, 1, 1);  // extra value 1 …
        put(condition, 2, 4, 1);
        put(condition, 3, 1, 1);  // … is less than the border (comparison operator 4)
        put(condition, 4, 3 + border, 1);
        put(condition, 5, 4, 1);
    };
    below(0x3411, 2);  // the condition that selects table A: the input is below border 1
    below(0x3421, 3);  // the condition that selects table B: the input is below border 2; otherwise table C applies
    for (int point = 0; point < 30; ++point) {
        receive_extra(1, x(point));
        EXPECT_EQ(read(0x3310, 1), static_cast<std::uint64_t>(1 + point / 10)) << point;
        EXPECT_EQ(read(0x3320, 1), static_cast<std::uint64_t>(y(point))) << point;
        receive_extra(1, x(point) + 50);  // X half way between two points
        EXPECT_EQ(read(0x3320, 1), static_cast<std::uint64_t>((y(point) + y(point + 1)) / 2)) << point;
    }
    receive_extra(1, 3000);
    EXPECT_EQ(read(0x3320, 1), 900U);  // 30 * 3 %
}

}  // namespace canproof::test
