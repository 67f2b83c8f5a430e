// SPDX-License-Identifier: Apache-2.0
// Tests the lookup tables of the AX130751, which the tests set up and read by SDO (manual, 1.5).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

class Ax130751Lookup : public Ax130751Blocks {
  protected:
    /// Connects the X axis of a table to 2500h:n (EC Extra Received Process Value), scaled from 0 to 100 without
    /// decimal digits.
    void connect(int table, int extra_number) {
        extra_as_percent(extra_number);
        set8(table_object(table, 0), 0, canopen);
        set8(table_object(table, 1), 0, 3 + extra_number);
    }
    int output(int table) { return get16(table_object(table, 8), 0); }
    std::string write_x(int table, int point, std::int64_t x) { return write(table_object(table, 6), point, x, 4); }
};

TEST_F(Ax130751Lookup, EveryTableFollowsItsPoints) {
    verifies<req::AOR_LT_001, req::AOR_LT_002, req::AOR_SRC_001, req::AOR_LT_037>();
    for (int table = 1; table <= 10; ++table) {
        SCOPED_TRACE(table);
        connect(table, 1);
        set16(table_object(table, 7), 4, -70);  // (30, 30) becomes (30, -70)
        extra(1, 20);
        EXPECT_EQ(output(table), 20);
        extra(1, 25);
        EXPECT_EQ(output(table), -25);  // half way from 20 to -70
        extra(1, 30);
        EXPECT_EQ(output(table), -70);
        extra(1, 120);
        EXPECT_EQ(output(table), 100);
        set8(table_object(table, 0), 0, not_used);
    }
}

TEST_F(Ax130751Lookup, JumpAndIgnoreResponsesAreFollowed) {
    verifies<req::AOR_LT_003, req::AOR_LT_019, req::AOR_LT_004, req::AOR_T14>();
    connect(1, 1);
    set8(0x3015, 3, 2);  // jump to (20, 20)
    set8(0x3015, 5, 0);  // ignore from (40, 40) on
    extra(1, 10);
    EXPECT_EQ(output(1), 10);
    extra(1, 11);
    EXPECT_EQ(output(1), 20);
    extra(1, 25);
    EXPECT_EQ(output(1), 25);
    extra(1, 31);
    EXPECT_EQ(output(1), 30);
    extra(1, 99);
    EXPECT_EQ(output(1), 30);
    EXPECT_EQ(write(0x3015, 1, 2, 1), "06090031") << "2 is no type of the X axis";
}

TEST_F(Ax130751Lookup, PointsOfEqualXGiveAJump) {
    verifies<req::AOR_LT_005, req::AOR_LT_020>();
    connect(1, 1);
    set32(0x3016, 3, 30);
    set16(0x3017, 3, 5);
    set16(0x3017, 4, 80);
    extra(1, 30);
    EXPECT_EQ(output(1), 5);
    extra(1, 31);
    EXPECT_EQ(output(1), 76);  // 80 falling to 40 at 40
}

TEST_F(Ax130751Lookup, DecimalDigitsApplyToBothAxes) {
    verifies<req::AOR_LT_008, req::AOR_SRC_009, req::AOR_LT_038, req::AOR_LT_039>();
    extra_as_percent(1);
    set8(0x2502, 1, 2);  // 2502h:1 = 2: 2500h:1 (EC Extra Received Process Value) has two decimal digits
    set16(0x2522, 1, 10000);
    set8(0x3010, 0, canopen);
    set8(0x3011, 0, 4);
    set8(0x3014, 0, 1);  // Y in tenths: 0…10.0
    extra(1, 2525);      // 2500h:1 (EC Extra Received Process Value) is 25.25 of 100, so Y is 2.525 of 10.0: 25 tenths
    EXPECT_EQ(output(1), 25);
    EXPECT_EQ(get16(0x3018, 0), 25);
    set8(0x3013, 0, 1);  // X points are 0…10.0
    extra(1, 525);       // 2500h:1 = 5.25 gives Y = 5.25, that is 52.5 tenths, rounded to 53
    EXPECT_EQ(output(1), 53);
}

TEST_F(Ax130751Lookup, OutputLimitsOfATableComeFromAllPointsEvenIgnoredOnes) {
    verifies<req::AOR_LT_007, req::AOR_LT_006, req::AOR_SRC_007, req::AOR_K_PERCENT_LOW, req::AOR_K_PERCENT_HIGH,
             req::AOR_SRC_018>();
    // Logic block 1 shows the output as a percentage of the limits of table 1.
    connect(1, 1);
    set8(0x3300, 1, 1);
    set8(0x3015, 3, 0);  // point 3 is ignored, so only points 1 (0, 0) and 2 (10, 10) are used
    extra(1, 5);
    EXPECT_EQ(get16(0x3320, 1), 50) << "5.0 % of 0 to 100";
    for (int point = 1; point <= 10; ++point) {
        set16(0x3017, point, 40);
    }
    pass(1);
    EXPECT_EQ(get16(0x3320, 1), 400) << "40 to 100 lies within 0 to 100";
    for (int point = 1; point <= 10; ++point) {
        set16(0x3017, point, 10 * (point - 1));
    }
    set16(0x3017, 11, 101);  // the range of Y includes the ignored point 11: 0 to 101
    pass(1);
    EXPECT_EQ(get16(0x3320, 1), 50);  // 4.95 % of 0 to 101, rounded
    set16(0x3017, 11, 1000);
    pass(1);
    EXPECT_EQ(get16(0x3320, 1), 5);  // 5 of 0 to 1000 is 0.5 %
    set16(0x3017, 10, -1000);
    pass(1);
    EXPECT_EQ(get16(0x3320, 1), 503);  // 5 is 1005 above the lowest Y (-1000), and the range is 2000: 1005 / 2000 =
                                       // 50.3 %
    set16(0x3017, 11, 100);
    set16(0x3017, 10, -300);
    pass(1);
    // 5 is 305 above the lowest Y (-300); the range up to the highest Y (100) is 400: 305 / 400 = 76.3 %
    EXPECT_EQ(get16(0x3320, 1), 763);
}

TEST_F(Ax130751Lookup, XThatBreaksTheOrderOfThePointsIsRefused) {
    verifies<req::AOR_LT_009, req::AOR_LT_033, req::AOR_LT_035>();
    EXPECT_EQ(write_x(1, 5, 29), "06090032") << "below point 4";
    EXPECT_EQ(write_x(1, 5, 51), "06090031") << "above point 6";
    EXPECT_EQ(write_x(1, 5, 30), "");
    EXPECT_EQ(write_x(1, 5, 50), "");
    EXPECT_EQ(write_x(1, 1, -32768), "");
    EXPECT_EQ(write_x(1, 1, -32769), "06090032");
    EXPECT_EQ(write_x(1, 11, 32767), "");
    EXPECT_EQ(write_x(1, 11, 32768), "06090031") << "no 16-bit number";
    EXPECT_EQ(write_x(10, 1, 11), "06090031");
    EXPECT_EQ(write_x(10, 11, 89), "06090032");
    set16(0x3097, 2, 0);
    EXPECT_EQ(write_x(9, 11, 500), "") << "nothing but its own axis limits it";
}

TEST_F(Ax130751Lookup, EachPointStaysBetweenItsNeighbours) {
    verifies<req::AOR_LT_009, req::AOR_LT_033, req::AOR_LT_035>();
    for (int point = 1; point <= 11; ++point) {
        SCOPED_TRACE(point);
        const int x = 10 * (point - 1);
        EXPECT_EQ(write_x(7, point, point == 1 ? -32769 : x - 11), "06090032");
        EXPECT_EQ(write_x(7, point, point == 11 ? 32768 : x + 11), "06090031");
        EXPECT_EQ(write_x(7, point, point == 11 ? x : x + 10), "");
        EXPECT_EQ(write_x(7, point, point == 1 ? x : x - 10), "");
        EXPECT_EQ(write_x(7, point, x), "");
    }
}

TEST_F(Ax130751Lookup, PointsOutOfOrderAreReadInAscendingOrder) {
    verifies<req::AOR_LT_009, req::AOR_LT_001>();
    connect(1, 1);
    set8(0x3015, 1, 1);    // time response: intervals may be written in any order
    set32(0x3016, 2, 20);  // point 2 is (20, 10)
    set32(0x3016, 3, 5);   // point 3 is (5, 20)
    set32(0x3016, 4, 30);  // point 4 is (30, 30)
    set32(0x3016, 5, 40000);
    set8(0x3015, 1, 0);
    extra(1, 4);
    EXPECT_EQ(output(1), 2);  // X = 4 is a fifth of the way from point 1 (0, 0) to point 2 (20, 10), so Y is 2
    extra(1, 20);
    EXPECT_EQ(output(1), 10) << "point 3 lies behind";
    extra(1, 25);
    EXPECT_EQ(output(1), 28);  // 20 + 10 * (25 - 5) / (30 - 5) = 28
    EXPECT_EQ(write_x(1, 6, 50), "06090032") << "below point 5";
    EXPECT_EQ(write_x(1, 3, 6), "06090032") << "below point 2";
    EXPECT_EQ(write_x(1, 2, 5), "");
    EXPECT_EQ(write_x(1, 3, 30), "");
    extra(1, 20);
    EXPECT_EQ(output(1), 16);  // 10 + 10 * (20 - 5) / (30 - 5) = 16
}

TEST_F(Ax130751Lookup, XOutsideTheLimitsOfTheSourceIsRefused) {
    verifies<req::AOR_LT_034, req::AOR_LT_035, req::AOR_LT_009, req::AOR_LT_017, req::AOR_LT_031, req::AOR_SRC_017>();
    set8(0x3020, 0, supply_source);  // X can be 8 to 35 V
    for (int point = 1; point <= 11; ++point) {
        EXPECT_EQ(read(0x3026, point), static_cast<std::uint64_t>(10 * (point - 1))) << "8 V is not below 0";
    }
    EXPECT_EQ(write_x(2, 1, 7), "06090032");
    EXPECT_EQ(write_x(2, 1, 8), "");
    EXPECT_EQ(write_x(2, 11, 99), "06090031");
    EXPECT_EQ(write_x(2, 4, 35), "");
    EXPECT_EQ(write_x(2, 4, 36), "06090031");
    EXPECT_EQ(write_x(2, 3, 9), "06090032") << "within the limits, but below point 2";
    set8(0x3020, 0, canopen);  // 2500h:1 (EC Extra Received Process Value), both of whose default limits are 0
    set8(0x3021, 0, 4);
    EXPECT_EQ(write_x(2, 4, 36), "");
    set8(0x3020, 0, supply_source);
    set8(0x3023, 0, 1);  // X is in tenths of a volt from here on
    EXPECT_EQ(write_x(2, 4, 36), "06090032") << "3.6 V";
}

TEST_F(Ax130751Lookup, UnavailableSourceDoesNotLimitThePoints) {
    verifies<req::AOR_LT_034, req::AOR_LOGIC_014>();
    set8(0x3020, 0, logic_source);  // an enabled logic block gives 0 to 100 %; while it is disabled, it gives no limits
    set8(0x3021, 0, 1);
    EXPECT_EQ(write_x(2, 11, 150), "");
    connect(1, 1);
    set8(0x3300, 1, 1);
    pass(2);
    EXPECT_EQ(write_x(2, 11, 140), "06090031");
    EXPECT_EQ(write_x(2, 11, 100), "");
}

TEST_F(Ax130751Lookup, NewLimitsOfATableReachALowerNumberedTableOneCycleLater) {
    verifies<req::AOR_OUT_030, req::AOR_LT_007, req::AOR_LT_010>();
    // Extra received value 1 (2500h:1) is the input of table 2, and table 2 the input of table 1, whose time profile
    // rises to 50 in 100 ms.
    connect(2, 1);
    for (int point = 8; point <= 11; ++point) {
        set16(0x3027, point, 60);
    }
    set8(0x3010, 0, lookup_source);
    set8(0x3011, 0, 2);
    set8(0x3015, 1, 1);
    set32(0x3016, 2, 100);
    set16(0x3017, 2, 50);
    set8(0x3015, 3, 0);
    extra(1, 60);
    pass(10);
    EXPECT_EQ(output(1), 0) << "60 of 0 to 100 is not ON";
    pass(10);
    set16(0x3027, 11, -10);  // the lowest Y of table 2 becomes -10: it still gives 60, now in a range of -10 to 60
    pass(2 + 50);            // the next cycle sets the limits of table 2, and the following cycle uses them
    EXPECT_EQ(output(1), 25);
}

TEST_F(Ax130751Lookup, TimeResponseRunsWhileTheInputIsOn) {
    verifies<req::AOR_LT_010, req::AOR_LT_011, req::AOR_LT_012, req::AOR_LT_029>();
    connect(3, 1);
    set8(0x3035, 1, 1);
    set32(0x3036, 2, 100);
    set16(0x3037, 2, 50);
    set32(0x3036, 3, 20);
    set16(0x3037, 3, 90);
    set8(0x3035, 3, 2);  // jump
    set8(0x3035, 4, 0);
    pass(5);
    EXPECT_EQ(output(3), 0);
    extra(1, 40);
    pass(10);
    EXPECT_EQ(output(3), 0) << "still OFF: between the limits 0 and 100";
    extra(1, 100);  // extra() runs one cycle, which turns the input ON and starts the profile
    EXPECT_EQ(output(3), 0);
    pass(50);
    EXPECT_EQ(output(3), 25);
    extra(1, 40);  // still ON: between the limits 0 and 100
    pass(49);
    EXPECT_EQ(output(3), 50) << "point 2 after 100 ms";
    pass(1);
    EXPECT_EQ(output(3), 90) << "jump";
    pass(1000);
    EXPECT_EQ(output(3), 90) << "stays at its end";
    extra(1, 0);
    EXPECT_EQ(output(3), 0);
    extra(1, 100);
    pass(10);
    EXPECT_EQ(output(3), 5) << "from the beginning";
}

TEST_F(Ax130751Lookup, AutoRepeatRestartsTheTimeProfileAtItsEnd) {
    verifies<req::AOR_LT_013>();
    connect(3, 1);
    set8(0x3035, 1, 1);
    set8(0x3032, 0, 1);
    set32(0x3036, 2, 100);
    set16(0x3037, 2, 50);
    set8(0x3035, 3, 0);
    extra(1, 100);
    pass(100);
    EXPECT_EQ(output(3), 50);
    pass(20);
    EXPECT_EQ(output(3), 10);
    pass(1000);
    EXPECT_EQ(output(3), 10);
    extra(1, 0);
    EXPECT_EQ(output(3), 0);
}

TEST_F(Ax130751Lookup, SelectingTheTimeResponseClearsPoint1AndSetsTheTimeLimits) {
    verifies<req::AOR_LT_014, req::AOR_LT_023, req::AOR_LT_024, req::AOR_K_SHORTEST_INTERVAL,
             req::AOR_K_LONGEST_INTERVAL, req::AOR_LT_032, req::AOR_LT_040>();
    set8(0x3103, 0, 2);
    set32(0x3106, 1, -5);
    set16(0x3107, 1, 77);
    set8(0x3105, 1, 0);
    EXPECT_EQ(get16(0x3107, 1), 77) << "data response sets nothing";
    EXPECT_EQ(get8(0x3103, 0), 2);
    set8(0x3105, 1, 1);
    EXPECT_EQ(read(0x3106, 1), 0U);
    EXPECT_EQ(get16(0x3107, 1), 0);
    EXPECT_EQ(get8(0x3103, 0), 0);
    EXPECT_EQ(write_x(10, 1, 1), "06090031");
    EXPECT_EQ(write_x(10, 1, -1), "06090032");
    EXPECT_EQ(write_x(10, 1, 0), "");
    EXPECT_EQ(write_x(10, 2, 0), "06090032");
    EXPECT_EQ(write_x(10, 2, 1), "");
    EXPECT_EQ(write_x(10, 2, 86'400'000), "") << "above the next: intervals have no order";
    EXPECT_EQ(write_x(10, 2, 86'400'001), "06090031");
    for (int point = 3; point <= 11; ++point) {
        EXPECT_EQ(write_x(10, point, 0), "06090032") << point;
        EXPECT_EQ(write_x(10, point, 86'400'001), "06090031") << point;
        EXPECT_EQ(write_x(10, point, 86'400'000), "") << point;
        EXPECT_EQ(write_x(10, point, 1), "") << point;
    }
    // Point 1 counts as (0, 0 ms) even if its Y is not 0, and the X of the other points are in milliseconds even when
    // 3103h (decimal digits) is not 0.
    connect(10, 1);
    set16(0x3107, 1, 60);
    set8(0x3103, 0, 3);
    set32(0x3106, 2, 100);
    set8(0x3105, 3, 0);
    EXPECT_EQ(get16(0x3107, 1), 60) << "the choice itself sets it, not what is written later";
    EXPECT_EQ(get8(0x3103, 0), 3);
    extra(1, 100);
    EXPECT_EQ(output(10), 0);
    pass(50);
    EXPECT_EQ(output(10), 5);
}

TEST_F(Ax130751Lookup, DisabledTableIsZeroAndNotAvailable) {
    verifies<req::AOR_LT_015>();
    connect(1, 1);
    extra(1, 60);
    EXPECT_EQ(output(1), 60);
    no_ramps(1);
    set8(0x2340, 1, lookup_source);
    set8(0x2341, 1, 1);
    set8(0x6302, 1, 0);
    set16(0x7322, 1, 100);
    set16(0x7321, 1, 1000);
    set8(0x2342, 1, 0);
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 3.4F);  // 1 V + 60 % of 4 V
    set8(0x3010, 0, not_used);
    pass(1);
    EXPECT_EQ(output(1), 0);
    EXPECT_FLOAT_EQ(volts(1), 0.0F) << "no control: OFF, not the 1 V of scaling 1";
}

TEST_F(Ax130751Lookup, InputErrorPassesThroughAChainOfTablesAgainstTheEvaluationOrder) {
    verifies<req::AOR_LT_016, req::AOR_OUT_030>();
    set32(0x1401, 1, 0x4000037F);
    set16(0x1401, 5, 50);  // event timer of RPDO2, which maps 2500h:1: 50 ms
    // Extra received value 1 (2500h:1) → table 4 → table 3 → table 2 → table 1 → output 1: from one cycle to the next
    // only the error state passes on.
    connect(4, 1);
    for (int table = 1; table <= 3; ++table) {
        set8(table_object(table, 0), 0, lookup_source);
        set8(table_object(table, 1), 0, table + 1);
    }
    no_ramps(1);
    set8(0x2340, 1, lookup_source);
    set8(0x2341, 1, 1);
    set16(0x7341, 1, 2000);
    start();
    send("37F#280000000000");
    pass(20);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);  // the control signal is 40.000; 5.000 or more gives 5 V (scaling 2)
    pass(32);
    EXPECT_FLOAT_EQ(volts(1), 5.0F) << "the error of the 50th millisecond is as far as table 3";
    pass(10);
    EXPECT_FLOAT_EQ(volts(1), 2.0F);
    EXPECT_EQ(output(1), 40);
}

TEST_F(Ax130751Lookup, InputErrorOfATableIsPassedOnToItsOutput) {
    verifies<req::AOR_LT_016, req::AOR_LT_025, req::AOR_LT_026, req::AOR_SRC_004, req::AOR_LT_030>();
    set32(0x1401, 1, 0x4000037F);
    set16(0x1401, 5, 50);  // event timer of RPDO2, which maps 2500h:1: 50 ms
    connect(1, 1);
    no_ramps(1);
    set8(0x2340, 1, lookup_source);
    set8(0x2341, 1, 1);
    set16(0x7341, 1, 2000);
    start();
    send("37F#280000000000");
    pass(5);
    EXPECT_EQ(output(1), 40);
    pass(60);
    EXPECT_EQ(output(1), 40) << "keeps its value";
    EXPECT_FLOAT_EQ(volts(1), 2.0F) << "but the output takes its fault value";
    // While the X axis is time, an input in error makes the output of the table 0.
    send("37F#640000000000");
    set8(0x3015, 1, 1);
    set32(0x3016, 2, 20);
    set8(0x3015, 3, 0);
    set16(0x3017, 2, 80);
    pass(30);
    EXPECT_EQ(output(1), 80);
    pass(40);
    EXPECT_EQ(output(1), 0);
    send("37F#640000000000");
    pass(11);
    EXPECT_EQ(output(1), 40) << "again, 10 ms after it began";
}

}  // namespace canproof::test
