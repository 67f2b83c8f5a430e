// SPDX-License-Identifier: Apache-2.0
// Tests the X value of point 1 of a lookup table of the AX130751. It follows the minimum of the table's source when
// this minimum is below zero (manual, 1.5.1).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751LookupMinimum : public Ax130751Blocks {
  protected:
    void choose(int table, int source, int number) {
        set8(table_object(table, 1), 0, number);
        set8(table_object(table, 0), 0, source);
    }
    int x(int table, int point) { return static_cast<std::int32_t>(read(table_object(table, 6), point)); }
    /// Scales 2500h:1 (EC Extra Received Process Value) to integers from `low` to `high`.
    void make_extra(int low, int high) {
        set8(0x2502, 1, 0);
        set16(0x2522, 1, high);
        set16(0x2520, 1, low);
    }
};

}  // namespace

// The example of section 1.5.1: a temperature of -40 to 210 °C.
TEST_F(Ax130751LookupMinimum, XOfPoint1FollowsATemperatureSourceFromMinus40To210Degrees) {
    verifies<req::AOR_LT_018, req::AOR_LT_017>();
    make_extra(-40, 210);
    for (int table = 1; table <= 10; ++table) {
        SCOPED_TRACE(table);
        EXPECT_EQ(x(table, 1), 0);
        choose(table, canopen, 4);
        EXPECT_EQ(x(table, 1), -40);
        for (int point = 2; point <= 11; ++point) {
            EXPECT_EQ(x(table, point), 10 * (point - 1));
        }
        extra(1, -40);
        EXPECT_EQ(get16(table_object(table, 8), 0), 0);
        extra(1, -15);
        EXPECT_EQ(get16(table_object(table, 8), 0), 5);  // half way on the line from (-40, 0) to (10, 10)
        set8(table_object(table, 0), 0, not_used);
        EXPECT_EQ(x(table, 1), 0) << "no source, no minimum";
    }
}

TEST_F(Ax130751LookupMinimum, XOfPoint1FollowsTheScalingOfItsSource) {
    verifies<req::AOR_LT_018>();
    choose(1, canopen, 4);
    EXPECT_EQ(x(1, 1), 0) << "0 to 0 as shipped";
    set16(0x2520, 1, -400);
    EXPECT_EQ(x(1, 1), -40) << "in tenths as shipped";
    set8(0x2502, 1, 0);
    EXPECT_EQ(x(1, 1), -400);
    set16(0x2520, 1, -7);
    EXPECT_EQ(x(1, 1), -7);
    set16(0x2520, 2, -9);
    EXPECT_EQ(x(1, 1), -7) << "2500h:2 is not its source";
    set8(0x3011, 0, 5);
    EXPECT_EQ(x(1, 1), 0) << "2500h:2 is -0.9: no whole number of X lies below 0 and not below that";
    set8(0x3013, 0, 1);
    EXPECT_EQ(x(1, 1), -9);
    set16(0x2522, 2, 100);
    set16(0x2520, 2, 5);
    EXPECT_EQ(x(1, 1), 0);
}

TEST_F(Ax130751LookupMinimum, SourceTableMinimumIsItsLowestYEvenAtItsSecondOrLastPoint) {
    verifies<req::AOR_LT_018>();
    choose(5, lookup_source, 10);
    set16(0x3107, 11, -90);
    EXPECT_EQ(x(5, 1), -90);
    set16(0x3107, 11, 100);
    set16(0x3107, 2, -30);
    EXPECT_EQ(x(5, 1), -30);
}

TEST_F(Ax130751LookupMinimum, XOfPoint1FollowsTheMinimumOfEachSourceKindExceptTableAndExtraValue) {
    verifies<req::AOR_LT_018>();
    // 7320h (AO Output Scaling 1 PV) is in thousandths of a volt.
    set8(0x3013, 0, 3);
    choose(1, canopen, 1);
    set16(0x7320, 1, -5000);
    EXPECT_EQ(x(1, 1), -5000) << "7320h";
    set8(0x6302, 1, 4);
    EXPECT_EQ(x(1, 1), -500) << "6302h";
    set16(0x7322, 1, 6000);
    EXPECT_EQ(x(1, 1), -500) << "7322h lies above 7320h";
    set16(0x7323, 1, 4000);
    EXPECT_EQ(x(1, 1), -500) << "7323h is no limit of the command";
    set16(0x6310, 1, 20);  // by 5550h (automatic updates) the new type sets 7320h to 0
    EXPECT_EQ(x(1, 1), 0) << "6310h";
    // For sources 6 (target) and 7 (feedback) the minimum is the smaller of 7321h (AO Output Scaling 1 FV) and 7323h
    // (AO Output Scaling 2 FV).
    for (const int source : {6, 7}) {
        choose(2, source, 2);
        set8(0x3023, 0, 3);
        set16(0x7323, 2, -10000);
        EXPECT_EQ(x(2, 1), -10000) << "7323h";
        set16(0x7323, 2, 5000);
        set16(0x7321, 2, -2000);
        EXPECT_EQ(x(2, 1), -2000) << "7321h";
        set8(0x6332, 2, 4);
        EXPECT_EQ(x(2, 1), -200) << "6332h";
        set16(0x6310, 2, 20);  // by 5550h (automatic updates) the new type sets 7321h (AO Output Scaling 1 FV) to 0
        EXPECT_EQ(x(2, 1), 0) << "6310h";
        set16(0x6310, 2, 10);
        set16(0x7321, 2, -200);
        set8(0x6332, 2, 3);
        set16(0x7321, 2, 0);
        EXPECT_EQ(x(2, 1), 0);
        set8(0x3023, 0, 0);
    }
    // The minimum of a math block is the smaller of 4021h (Math Output Scaling 1 PV) and 4023h (Math Output Scaling 2
    // PV), in hundredths.
    choose(3, math_source, 2);
    set16(0x4021, 2, -3000);
    EXPECT_EQ(x(3, 1), -30) << "4021h";
    set16(0x4023, 2, -5000);
    EXPECT_EQ(x(3, 1), -50) << "4023h";
    set8(0x4032, 2, 3);
    EXPECT_EQ(x(3, 1), -5) << "4032h";
    // The minimum of source 9 (temperature) is 5032h (Over Temperature Threshold) minus 5033h (Hysteresis to Clear
    // Temperature Fault). As shipped it is 85 - 25 = 60, and X1 is 0, because X1 follows only a minimum below 0.
    choose(4, 9, 1);
    EXPECT_EQ(x(4, 1), 0) << "85 - 25";
    set8(0x5033, 0, 100);
    EXPECT_EQ(x(4, 1), -15) << "5033h";
    set8(0x5032, 0, 80);
    EXPECT_EQ(x(4, 1), -20) << "5032h";
    // The values of supply, logic block and relay command (6220h:3) are never below 0.
    choose(4, supply_source, 1);
    EXPECT_EQ(x(4, 1), 0);
    choose(4, logic_source, 1);
    EXPECT_EQ(x(4, 1), 0);
    choose(4, canopen, 3);
    EXPECT_EQ(x(4, 1), 0);
}

TEST_F(Ax130751LookupMinimum, EachMathBlockAndExtraValueHasItsOwnMinimum) {
    verifies<req::AOR_LT_018, req::AOR_SRC_007>();
    for (int block = 1; block <= 4; ++block) {
        set16(0x4021, block, -1000 * block);  // 4021h:n (Math Output Scaling 1 PV), in hundredths by default: -10 * n
    }
    for (int number = 1; number <= 6; ++number) {
        set16(0x2520, number, -200 * number);  // 2520h:n (EC Scaling 1 PV), in tenths by default: -20 * n
    }
    for (int block = 1; block <= 4; ++block) {
        choose(2, math_source, block);
        EXPECT_EQ(x(2, 1), -10 * block);
    }
    for (int number = 1; number <= 6; ++number) {
        choose(2, canopen, 3 + number);
        EXPECT_EQ(x(2, 1), -20 * number);
    }
}

TEST_F(Ax130751LookupMinimum, OverrideAndFaultValuesOfAnOutputMoveNoPoint) {
    verifies<req::AOR_LT_018>();
    set8(0x3013, 0, 3);
    for (const int source : {canopen, 6}) {  // the command and the target of output 1
        choose(1, source, 1);
        set16(source == canopen ? 0x7320 : 0x7321, 1, -3000);
        EXPECT_EQ(x(1, 1), -3000);
        for (const int value : {-5000, 2000}) {
            set16(0x2300, 1, value);
            set16(0x7341, 1, value);
            EXPECT_EQ(x(1, 1), -3000) << value;
        }
    }
}

TEST_F(Ax130751LookupMinimum, SourceTableGivesItsLowestYAsMinimum) {
    verifies<req::AOR_LT_018>();
    choose(5, lookup_source, 10);  // table 10, the source of table 5, has no source itself
    set16(0x3107, 3, -70);
    EXPECT_EQ(x(5, 1), -70);
    set16(0x3107, 1, -80);
    EXPECT_EQ(x(5, 1), -80);
    set8(0x3104, 0, 1);
    EXPECT_EQ(x(5, 1), -8) << "3yz4h";
    set8(0x3105, 1, 1);
    EXPECT_EQ(x(5, 1), -7) << "over time point 1 is 0";
    set16(0x3107, 3, 20);
    EXPECT_EQ(x(5, 1), 0);
}

TEST_F(Ax130751LookupMinimum, DigitalOutputCommandAsASourceHasMinimum0) {
    verifies<req::AOR_LT_018>();
    set8(0x5550, 0, 0);
    set8(0x3013, 0, 3);
    set16(0x7320, 1, -5000);
    choose(1, canopen, 1);
    EXPECT_EQ(x(1, 1), -5000);
    set16(0x6310, 1, 1020);
    EXPECT_EQ(x(1, 1), 0) << "6220h:1 is 0 or 1";
}

TEST_F(Ax130751LookupMinimum, RoundedSourceMinimumStaysWithinTheLimitsOfTheSource) {
    verifies<req::AOR_LT_018, req::AOR_LT_034>();
    set16(0x2522, 1, 2100);
    set16(0x2520, 1, -405);  // 2520h:1 (EC Scaling 1 PV) is -40.5
    choose(1, canopen, 4);
    EXPECT_EQ(x(1, 1), -40);
    EXPECT_EQ(write(0x3016, 1, -41, 4), "06090032");
    set8(0x3013, 0, 4);
    EXPECT_EQ(x(1, 1), -32768) << "-40.5000 is no 16-bit number";
}

TEST_F(Ax130751LookupMinimum, XOfPoint1ChangedByTheUserNoLongerFollowsItsSource) {
    verifies<req::AOR_LT_027, req::AOR_LT_017>();
    make_extra(-40, 210);
    set32(0x3016, 1, 5);
    choose(1, canopen, 4);
    EXPECT_EQ(x(1, 1), 5);
    set16(0x2520, 1, -50);
    EXPECT_EQ(x(1, 1), 5);
    set32(0x3016, 1, 0);
    EXPECT_EQ(x(1, 1), 0);
    set16(0x2520, 1, -60);
    EXPECT_EQ(x(1, 1), 0);
    set32(0x3016, 1, -60);
    set16(0x2520, 1, -61);
    EXPECT_EQ(x(1, 1), -61) << "at the minimum it goes along";
    set32(0x3016, 1, -55);
    set16(0x2520, 1, -55);
    EXPECT_EQ(x(1, 1), -55);
    set16(0x2520, 1, -57);
    EXPECT_EQ(x(1, 1), -57) << "the written X1 equals the position for the old minimum";
}

TEST_F(Ax130751LookupMinimum, XOfPoint1NeverExceedsXOfPoint2) {
    verifies<req::AOR_LT_028>();
    make_extra(-40, 210);
    choose(1, canopen, 4);
    set32(0x3016, 2, -20);
    set16(0x2520, 1, 0);
    EXPECT_EQ(x(1, 1), -40);
    set16(0x2520, 1, -20);
    EXPECT_EQ(x(1, 1), -20) << "point 2 itself";
    set16(0x2520, 1, 0);
    EXPECT_EQ(x(1, 1), -20);
    set32(0x3016, 2, 10);
    EXPECT_EQ(x(1, 1), 0);
}

TEST_F(Ax130751LookupMinimum, XOfPoint1OfATimeProfileIs0) {
    verifies<req::AOR_LT_018, req::AOR_LT_023>();
    make_extra(-40, 210);
    choose(1, canopen, 4);
    set8(0x3015, 1, 1);
    EXPECT_EQ(x(1, 1), 0);
    set16(0x2520, 1, -50);
    EXPECT_EQ(x(1, 1), 0);
    set8(0x3015, 1, 0);
    EXPECT_EQ(x(1, 1), -50);
}

TEST_F(Ax130751LookupMinimum, StoredTableContinuesToFollowItsSource) {
    verifies<req::AOR_LT_018, req::AOR_STORE_003>();
    make_extra(-40, 210);
    choose(1, canopen, 4);
    choose(2, canopen, 4);
    set32(0x3026, 1, 0);
    store();
    power_on();
    EXPECT_EQ(x(1, 1), -40);
    EXPECT_EQ(x(2, 1), 0) << "moved by the user";
    set16(0x2520, 1, -50);
    EXPECT_EQ(x(1, 1), -50);
    EXPECT_EQ(x(2, 1), 0);
}

TEST_F(Ax130751LookupMinimum, StoredTablesOfSeveralSourcesEachFollowTheirOwn) {
    verifies<req::AOR_LT_018, req::AOR_STORE_003>();
    for (int number = 1; number <= 2; ++number) {
        set8(0x2502, number, 0);
        set16(0x2522, number, 210);
        set16(0x2520, number, -20 * number);
    }
    set16(0x4021, 1, -5500);  // 4021h:1 (Math Output Scaling 1 PV), in hundredths by default: -55
    choose(1, canopen, 4);
    choose(2, canopen, 5);
    choose(3, math_source, 1);
    choose(4, canopen, 4);
    store();
    power_on();
    EXPECT_EQ(x(1, 1), -20);
    EXPECT_EQ(x(2, 1), -40);
    EXPECT_EQ(x(3, 1), -55);
    EXPECT_EQ(x(4, 1), -20);
    set16(0x2520, 2, -41);
    EXPECT_EQ(x(2, 1), -41) << "another channel than that of table 1";
    set16(0x4021, 1, -5600);
    EXPECT_EQ(x(3, 1), -56) << "another quantity than that of table 2";
    set16(0x2520, 1, -21);
    EXPECT_EQ(x(1, 1), -21);
    EXPECT_EQ(x(4, 1), -21) << "the same source as table 1, but not as table 3 before it";
}

TEST_F(Ax130751LookupMinimum, WriteToASourceTableThatHasATableAsSourceMovesTheRightPoint) {
    verifies<req::AOR_LT_018>();
    choose(5, lookup_source, 3);
    choose(6, lookup_source, 5);
    set16(0x3037, 3, -30);
    EXPECT_EQ(x(5, 1), -30);
    set16(0x3057, 3, -70);
    EXPECT_EQ(x(6, 1), -70);
    EXPECT_EQ(x(5, 1), -30) << "table 3, its source, has not changed";
}

TEST_F(Ax130751LookupMinimum, OutputTypeMovesThePointsForTheCommandAndForTheTarget) {
    verifies<req::AOR_LT_018>();
    set8(0x5550, 0, 0);  // no automatic updates: the new type leaves the scaling as it is
    set16(0x7320, 1, -5000);
    set16(0x7321, 1, -3000);
    choose(1, canopen, 1);
    choose(2, 6, 1);
    set8(0x3013, 0, 3);
    set8(0x3023, 0, 3);
    EXPECT_EQ(x(1, 1), -5000);
    EXPECT_EQ(x(2, 1), -3000);
    set16(0x6310, 1, 1020);
    EXPECT_EQ(x(1, 1), 0) << "the command of a digital output is 0 or 1";
    EXPECT_EQ(x(2, 1), 0);
    set16(0x6310, 1, 10);
    EXPECT_EQ(x(1, 1), -5000);
    EXPECT_EQ(x(2, 1), -3000);
}

TEST_F(Ax130751LookupMinimum, MovedPoint1HasTheDecimalDigitsOfX) {
    verifies<req::AOR_LT_018, req::AOR_LT_038>();
    set8(0x3013, 0, 1);  // the X of points 1 and 2 are then 0.0 and 1.0
    set16(0x2522, 1, 2000);
    choose(1, canopen, 4);
    set16(0x2520, 1, -10);  // in tenths by default: -1.0
    EXPECT_EQ(x(1, 1), -10);
    extra(1, 0);
    EXPECT_EQ(get16(0x3018, 0), 5) << "half way from (-1.0, 0) to (1.0, 10)";
}

}  // namespace canproof::test
