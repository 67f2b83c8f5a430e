// SPDX-License-Identifier: Apache-2.0
// Tests the logic blocks of the AX130751, which the tests set up and read by SDO (manual, 1.6).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

class Ax130751Logic : public Ax130751Blocks {
  protected:
    void SetUp() override {
        Ax130751Blocks::SetUp();
        for (int number = 1; number <= 6; ++number) {
            extra_as_percent(number);
        }
    }
    /// Returns `offset` plus the first index of the objects of logic block `block` (1 to 3), which is 3400h, 3500h or
    /// 3600h.
    static std::uint16_t index(int block, int offset) {
        return static_cast<std::uint16_t>(0x3300 + (0x100 * block) + offset);
    }
    /// Sets condition `number` of function A, B or C (`function` 1, 2 or 3) of a block. The condition compares extra
    /// received values (2500h) `first` and `second`.
    void condition(int block, int function, int number, int first, int comparison, int second) {
        const std::uint16_t at = index(block, (0x10 * function) + number);
        set8(at, 1, canopen);
        set8(at, 2, 3 + first);
        set8(at, 3, canopen);
        set8(at, 4, 3 + second);
        set8(at, 5, comparison);
    }
    /// Connects a lookup table to extra received value `number` (2500h).
    void connect_table(int table, int number) {
        set8(table_object(table), 0, canopen);
        set8(table_object(table, 1), 0, 3 + number);
    }
    int selected(int block) {
        pass(1);
        return get8(0x3310, block);
    }
    int output(int block) { return get16(0x3320, block); }
};

TEST_F(Ax130751Logic, DisabledLogicBlockSelectsNoTableAndGives0) {
    verifies<req::AOR_LOGIC_009>();
    connect_table(3, 1);
    extra(1, 60);
    EXPECT_EQ(selected(1), 0);
    EXPECT_EQ(output(1), 0);
    set8(0x3300, 1, 1);
    EXPECT_EQ(selected(1), 1) << "and of nothing but unused conditions holds: table A";
    set8(0x3402, 1, 0);
    set8(0x3401, 1, 3);
    EXPECT_EQ(selected(1), 3);
    EXPECT_EQ(output(1), 600);
    set8(0x3300, 1, 0);
    EXPECT_EQ(selected(1), 0);
    EXPECT_EQ(output(1), 0);
}

TEST_F(Ax130751Logic, EachLogicBlockSelectsOneOfItsOwnTables) {
    verifies<req::AOR_LOGIC_003, req::AOR_LOGIC_006, req::AOR_T20>();
    set16(0x2500, 2, 50);
    for (int block = 1; block <= 3; ++block) {
        SCOPED_TRACE(block);
        set8(0x3300, block, 1);
        condition(block, 1, 1, 1, 4, 2);  // A: 2500h:1 < 50
        // condition of function B: 2500h:1 (EC Extra Received Process Value) = 50; function C applies by default
        condition(block, 2, 1, 1, 0, 2);
        const int first = (3 * block) - 2;
        extra(1, 40);
        EXPECT_EQ(selected(block), first);
        extra(1, 50);
        EXPECT_EQ(selected(block), first + 1);
        extra(1, 60);
        EXPECT_EQ(selected(block), first + 2);
        set8(index(block, 1), 2, 10);
        extra(1, 50);
        EXPECT_EQ(selected(block), 10);
    }
}

TEST_F(Ax130751Logic, ComparisonsFollowTable16) {
    verifies<req::AOR_LOGIC_001, req::AOR_T16>();
    set8(0x3300, 1, 1);
    set16(0x2500, 2, 50);
    const auto holds = [this](int comparison) {
        condition(1, 1, 1, 1, comparison, 2);
        std::string seen;
        for (const int value : {49, 50, 51}) {
            extra(1, value);
            seen += selected(1) == 1 ? '#' : '.';
        }
        return seen;
    };
    EXPECT_EQ(holds(0), ".#.");
    EXPECT_EQ(holds(1), "#.#");
    EXPECT_EQ(holds(2), "..#");
    EXPECT_EQ(holds(3), ".##");
    EXPECT_EQ(holds(4), "#..");
    EXPECT_EQ(holds(5), "##.");
}

TEST_F(Ax130751Logic, ValuesWithDifferentDecimalDigitsAreComparedByTheirPhysicalValue) {
    verifies<req::AOR_LOGIC_001>();
    set8(0x3300, 1, 1);
    condition(1, 1, 1, 1, 0, 2);
    set8(0x2502, 1, 1);
    set8(0x2502, 2, 3);
    set16(0x2500, 1, 123);    // 2500h:1 = 12.3
    set16(0x2500, 2, 12300);  // 2500h:2 (EC Extra Received Process Value) = 12.300
    EXPECT_EQ(selected(1), 1);
    set16(0x2500, 2, 12301);
    EXPECT_EQ(selected(1), 2) << "B, whose conditions are not used";
}

TEST_F(Ax130751Logic, OperatorsWithThreeConditionsFollowTable18) {
    verifies<req::AOR_LOGIC_004, req::AOR_LOGIC_011, req::AOR_T18, req::AOR_T19>();
    set8(0x3300, 1, 1);
    set16(0x2500, 6, 1);
    for (int number = 1; number <= 3; ++number) {
        condition(1, 1, number, number, 0, 6);  // condition `number` compares 2500h:`number` with 2500h:6, which is 1
    }
    for (int operation = 0; operation <= 4; ++operation) {
        set8(0x3402, 1, operation);
        for (int bits = 0; bits < 8; ++bits) {
            const bool a = (bits & 1) != 0;
            const bool b = (bits & 2) != 0;
            const bool c = (bits & 4) != 0;
            set16(0x2500, 1, a ? 1 : 0);
            set16(0x2500, 2, b ? 1 : 0);
            set16(0x2500, 3, c ? 1 : 0);
            const std::array<bool, 5> expected{true, a && b && c, a || b || c, (a && b) || c, (a || b) && c};
            EXPECT_EQ(selected(1) == 1, expected[static_cast<std::size_t>(operation)]) << operation << ' ' << bits;
        }
    }
}

TEST_F(Ax130751Logic, UnusedConditionsCountAsTrueOnlyForTheAndOperator) {
    verifies<req::AOR_LOGIC_004, req::AOR_LOGIC_002, req::AOR_T17, req::AOR_T19>();
    set8(0x3300, 1, 1);
    condition(1, 1, 1, 1, 0, 1);  // condition 1 is always true; conditions 2 and 3 are not used by default
    const auto holds = [this](int operation) {
        set8(0x3402, 1, operation);
        return selected(1) == 1;
    };
    EXPECT_TRUE(holds(1));
    EXPECT_TRUE(holds(2));
    EXPECT_FALSE(holds(3));
    EXPECT_FALSE(holds(4));
}

TEST_F(Ax130751Logic, ConditionInErrorNeverSelectsATable) {
    verifies<req::AOR_LOGIC_002, req::AOR_T17>();
    set8(0x3300, 1, 1);
    set32(0x1401, 1, 0x4000037F);
    set16(0x1401, 5, 50);  // event timer of RPDO2, which maps 2500h:1 to 2500h:3: 50 ms
    condition(1, 1, 1, 1, 0, 1);
    condition(1, 2, 1, 4, 2, 4);  // function B compares a value with itself by "greater" (2), so it never selects its
                                  // table
    start();
    send("37F#000000000000");
    EXPECT_EQ(selected(1), 1);
    pass(60);
    EXPECT_EQ(selected(1), 3) << "its argument is in error";
    set8(0x3402, 1, 2);
    EXPECT_EQ(selected(1), 3);
    send("37F#000000000000");
    EXPECT_EQ(selected(1), 1);
}

TEST_F(Ax130751Logic, TableAIsSelectedWhenNoFunctionSelectsItsTable) {
    verifies<req::AOR_LOGIC_005>();
    set8(0x3300, 2, 1);
    set8(0x3502, 3, 1);
    for (int function = 1; function <= 3; ++function) {
        condition(2, function, 1, 1, 2, 1);  // 2500h:1 (EC Extra Received Process Value) > itself
    }
    EXPECT_EQ(selected(2), 4);
}

TEST_F(Ax130751Logic, FunctionWithTheDefaultOperatorSelectsItsTableIfNoEarlierFunctionDoes) {
    verifies<req::AOR_LOGIC_003>();
    set8(0x3300, 2, 1);
    set8(0x3502, 2, 0);
    condition(2, 1, 1, 1, 2, 1);  // 2500h:1 > 2500h:1 is never true, so function A never selects its table
    condition(2, 3, 1, 1, 0, 1);  // 2500h:1 = 2500h:1 is always true, so function C always selects its table
    EXPECT_EQ(selected(2), 5);
}

TEST_F(Ax130751Logic, OutputIsTheTableValueAsPercentageOfTheRangeOfTheTable) {
    verifies<req::AOR_LOGIC_007, req::AOR_LOGIC_012>();
    set8(0x3300, 3, 1);
    set8(0x3602, 1, 0);
    connect_table(7, 1);
    set16(0x3077, 11, 300);
    extra(1, 75);
    EXPECT_EQ(selected(3), 7);
    EXPECT_EQ(output(3), 250);  // 75 of 300 is 25.0 %
    extra(1, 100);
    EXPECT_EQ(output(3), 1000);
    for (int point = 1; point <= 11; ++point) {
        set16(0x3077, point, 300);
    }
    pass(1);
    EXPECT_EQ(output(3), 0) << "limits coincide";
}

TEST_F(Ax130751Logic, LogicBlockGives0PercentWhenItsTableHasNoSource) {
    verifies<req::AOR_LOGIC_007, req::AOR_LOGIC_008>();
    set8(0x3300, 1, 1);
    connect_table(1, 1);
    set16(0x3017, 1, -100);  // makes the limits of table 1 -100 to 100
    extra(1, 50);
    EXPECT_EQ(selected(1), 1);
    EXPECT_EQ(output(1), 750);
    set8(0x3010, 0, not_used);
    pass(1);
    EXPECT_EQ(output(1), 0) << "not the half of its limits";
}

TEST_F(Ax130751Logic, ChainOfLogicBlocksAgainstTheEvaluationOrderTakesOneCyclePerBlock) {
    verifies<req::AOR_OUT_030, req::AOR_LOGIC_008>();
    // Block 3 reads 2500h:1 (EC Extra Received Process Value), block 2 reads block 3, block 1 reads block 2. While its
    // source is available and 0, a block selects its table A, which gives 0. Otherwise it selects its table B, which
    // has no source. So all outputs stay 0.
    condition(3, 1, 1, 1, 0, 2);
    for (const int block : {1, 2}) {
        const std::uint16_t at = index(block, 0x11);
        set8(at, 1, logic_source);
        set8(at, 2, block + 1);
        set8(at, 3, canopen);
        set8(at, 4, 5);  // number 5: 2500h:2 (EC Extra Received Process Value)
        set8(at, 5, 0);
        set8(index(block, 2), 1, 2);  // operator 2: or
    }
    for (int block = 1; block <= 3; ++block) {
        connect_table((3 * block) - 2, 3);
        set8(0x3300, block, 1);
    }
    pass(10);
    for (int block = 1; block <= 3; ++block) {
        EXPECT_EQ(get8(0x3310, block), (3 * block) - 2);
    }
    pass(10);
    set16(0x2500, 1, 5);
    pass(2);
    EXPECT_EQ(device->objects().read(0x3310, 2), 5U);
    EXPECT_EQ(device->objects().read(0x3310, 1), 1U);
    pass(1);
    for (int block = 1; block <= 3; ++block) {
        EXPECT_EQ(get8(0x3310, block), (3 * block) - 1);
        EXPECT_EQ(output(block), 0);
    }
}

TEST_F(Ax130751Logic, LogicBlockHasTheSignalStateOfItsSelectedTable) {
    verifies<req::AOR_LOGIC_008, req::AOR_LOGIC_013>();
    // Output 1 follows logic block 1: it is OFF while the block is not available, and takes its fault value while the
    // block is in error.
    set8(0x3300, 1, 1);
    set8(0x3402, 1, 0);
    no_ramps(1);
    set8(0x2340, 1, logic_source);
    set8(0x2341, 1, 1);
    set8(0x6302, 1, 1);
    set16(0x7322, 1, 1000);
    set16(0x7321, 1, 1000);
    set16(0x7341, 1, 3000);
    set32(0x1401, 1, 0x4000037F);
    set16(0x1401, 5, 50);
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 0.0F) << "table 1 has no source";
    connect_table(1, 1);
    start();
    send("37F#320000000000");
    pass(5);
    EXPECT_FLOAT_EQ(volts(1), 3.0F);  // the output is 1 V + half of 4 V
    pass(60);
    EXPECT_FLOAT_EQ(volts(1), 3.0F) << "fault value";
    set16(0x7341, 1, 2000);
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 2.0F);
}

TEST_F(Ax130751Logic, LogicBlockWithThreeLookupTablesGivesACurveOfThirtySegments) {
    verifies<req::AOR_LOGIC_003, req::AOR_LOGIC_007>();
    // One input from 0 to 100 selects table 1 below 30, table 2 below 60, and table 3 otherwise. Each table has its own
    // ten slopes.
    set16(0x2500, 2, 30);
    set16(0x2500, 3, 60);
    const auto points = [this](int table, const std::array<int, 11>& x, const std::array<int, 11>& y) {
        connect_table(table, 1);
        const auto x_index = static_cast<std::uint16_t>(0x3006 + (0x10 * table));
        const auto y_index = static_cast<std::uint16_t>(0x3007 + (0x10 * table));
        // Increasing X are written from the last point to the first, decreasing X from the first to the last. So the
        // points stay in order during the writes.
        for (int i = 10; i >= 0; --i) {
            if (x.at(static_cast<std::size_t>(i)) >= 10 * i) {
                set32(x_index, i + 1, x.at(static_cast<std::size_t>(i)));
            }
        }
        for (int i = 0; i <= 10; ++i) {
            if (x.at(static_cast<std::size_t>(i)) < 10 * i) {
                set32(x_index, i + 1, x.at(static_cast<std::size_t>(i)));
            }
            set16(y_index, i + 1, y.at(static_cast<std::size_t>(i)));
        }
    };
    points(1, {0, 3, 6, 9, 12, 15, 18, 21, 24, 27, 30}, {0, 3, 6, 9, 12, 15, 18, 21, 24, 27, 30});
    points(2, {30, 33, 36, 39, 42, 45, 48, 51, 54, 57, 60}, {60, 57, 54, 51, 48, 45, 42, 39, 36, 33, 30});
    points(3, {60, 64, 68, 72, 76, 80, 84, 88, 92, 96, 100}, {60, 63, 66, 69, 72, 75, 78, 81, 84, 87, 90});
    set8(0x3300, 1, 1);
    condition(1, 1, 1, 1, 5, 2);  // condition A: x <= 30
    condition(1, 2, 1, 1, 5, 3);  // condition B: x <= 60
    const auto at = [this](int x) {
        extra(1, x);
        pass(1);
        return get16(0x3320, 1);
    };
    EXPECT_EQ(at(15), 150);  // table 1: Y rises to 30 at X = 30, so it is 15.0 at X = 15
    EXPECT_EQ(at(30), 300);
    EXPECT_EQ(at(45), 450);  // table 2: Y falls from 60 at X = 30 to 30 at X = 60
    EXPECT_EQ(at(33), 570);
    EXPECT_EQ(at(60), 300);
    EXPECT_EQ(at(80), 750);  // table 3: Y rises by 3 per 4 of X: 60 + 20 * 3 / 4 = 75
    EXPECT_EQ(at(82), 770);  // Y is 76.5, rounded to 77, because Y has no decimal digits
    EXPECT_EQ(at(100), 900);
}

}  // namespace canproof::test
