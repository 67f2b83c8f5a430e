// SPDX-License-Identifier: Apache-2.0
// Gives an AX130751 the most work for one SDO write: it moves point 1 of all tables. When these tests run on the
// microcontroller, src/target/run_suites measures these frames.
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/disturbed_bus.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751FullFrameLoad : public DisturbedBus<Ax130751Blocks> {
  protected:
    /// Connects the X of a table to a source.
    void connect(int table, Choice from, int digits) {
        set8(table_object(table, 3), 0, digits);
        set8(table_object(table), 0, from.source);
        set8(table_object(table, 1), 0, from.number);
        pass(1);
    }
    /// Returns the X of point 1 of a table.
    std::int32_t first_x(int table) { return static_cast<std::int32_t>(read(table_object(table, 6), 1)); }
};

}  // namespace

TEST_F(Ax130751FullFrameLoad, WriteOfAScalingMovesPoint1OfAllTables) {
    verifies<req::AOR_LT_017, req::AOR_LT_018>();
    for (int table = 1; table <= 10; ++table) {
        connect(table, Choice{6 + (table % 2), 1}, 3);  // commanded and feedback value of output 1, in turns
    }
    set16(0x6310, 1, 0);  // 6310h:1 (AO Output Type): not used, so that its values have no range
    pass(2);
    is_blocked = true;
    free_bus(31);
    send_alone("67F#2B217301C7CF0000");  // 7321h:1 (AO Output Scaling 1 FV): -12.345
    for (int table = 1; table <= 10; ++table) {
        EXPECT_EQ(first_x(table), -12345) << "table " << table;
    }
}

TEST_F(Ax130751FullFrameLoad, WriteOfTheAxisOfATableMovesPoint1OfAllTables) {
    verifies<req::AOR_LT_014, req::AOR_LT_017, req::AOR_LT_018>();
    set8(0x3054, 0, 4);
    set8(0x3055, 1, 1);  // table 5 is a profile over time: Y of point 1 counts as 0
    for (int point = 2; point <= 11; ++point) {
        set16(0x3057, point, -10001 + point - 2);
        pass(1);
    }
    set16(0x3057, 1, -12345);
    for (int table = 1; table <= 10; ++table) {
        connect(table, table == 5 ? Choice{math_source, 1} : Choice{lookup_source, 5}, 3 + (table % 2));
    }
    EXPECT_EQ(first_x(1), -10001) << "-1.0001 with four decimal digits";
    EXPECT_EQ(first_x(2), -1000) << "the last X with three digits that is not below -1.0001";
    set16(0x4021, 1, -2);
    set8(0x4032, 1, 3);  // the limits of math block 1 are -0.002 and 10.0
    is_blocked = true;
    free_bus(31);
    send_alone("67F#2255300100000000");  // over a value; without a length, which the device looks up
    for (int table = 1; table <= 10; ++table) {
        const int x = table % 2 == 1 ? -12345 : -1234;  // -1.2345 with four digits, and with three, not below it
        EXPECT_EQ(first_x(table), table == 5 ? -20 : x) << "table " << table;
    }
}

}  // namespace canproof::test
