// SPDX-License-Identifier: Apache-2.0
// Tests the math blocks of the AX130751, which the tests set up and read by SDO (manual, 1.7).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

class Ax130751Math : public Ax130751Blocks {
  protected:
    void SetUp() override {
        Ax130751Blocks::SetUp();
        for (int number = 1; number <= 6; ++number) {
            extra_as_percent(number);
        }
    }
    static std::uint16_t index(int block, int offset) {
        return static_cast<std::uint16_t>(0x4000 + (0x100 * block) + offset);
    }
    /// Connects inputs 1 to `count` of a block to 2500h:1 to 2500h:`count` (EC Extra Received Process Value), scaled
    /// from 0 to 100.
    void make(int block, int count) {
        for (int input = 1; input <= count; ++input) {
            set8(index(block, 0x01), input, 3 + input);
            set8(index(block, 0x00), input, canopen);
            set8(index(block, 0x03), input, 0);
            set16(index(block, 0x22), input, 100);
        }
        set8(0x4000, block, 1);
    }
    void values(const std::vector<int>& all) {
        int number = 1;
        for (const int value : all) {
            set16(0x2500, number++, value);
        }
        pass(1);
    }
    int output(int block) { return get16(0x4030, block); }
};

TEST_F(Ax130751Math, EveryMathBlockAddsAsShipped) {
    verifies<req::AOR_MATH_001, req::AOR_MATH_002, req::AOR_MATH_008, req::AOR_SRC_001, req::AOR_MATH_024>();
    for (int block = 1; block <= 4; ++block) {
        SCOPED_TRACE(block);
        make(block, 2);
        values({20, 35});
        EXPECT_EQ(output(block), 5500);  // 55.00 % of full scale
        values({80, 35});
        EXPECT_EQ(output(block), 10000) << "saturates";
        set8(0x4000, block, 0);
        pass(1);
        EXPECT_EQ(output(block), 0);
    }
}

TEST_F(Ax130751Math, OperatorsFollowTable21) {
    verifies<req::AOR_T21, req::AOR_MATH_003, req::AOR_MATH_012, req::AOR_MATH_004, req::AOR_MATH_005>();
    make(1, 2);
    struct Row {
        int operation;
        int of_40_60, of_60_60, of_60_40;
    };
    const std::array<Row, 18> rows{{
        {0, 0, 10000, 0},
        {1, 10000, 0, 10000},
        {2, 0, 0, 10000},
        {3, 0, 10000, 10000},
        {4, 10000, 0, 0},
        {5, 10000, 10000, 0},
        {6, 10000, 10000, 10000},
        {7, 0, 0, 0},
        {8, 0, 10000, 0},
        {9, 10000, 0, 10000},
        {10, 10000, 0, 10000},
        {11, 0, 10000, 0},
        {12, 10000, 10000, 10000},  // operator 12: sums from 1.0 on are clamped to 1
        {13, 0, 0, 2000},           // 0.4 - 0.6 is clamped to 0
        {14, 2400, 3600, 2400},     // operator 14: 0.4 * 0.6 = 0.24
        {15, 6667, 10000, 10000},   // 0.4 / 0.6; 0.6 / 0.4 = 1.5 is clamped to 1
        {16, 4000, 6000, 4000},
        {17, 6000, 6000, 6000},
    }};
    for (const auto& row : rows) {
        set8(0x4150, 1, row.operation);
        values({40, 60});
        EXPECT_EQ(output(1), row.of_40_60) << row.operation;
        values({60, 60});
        EXPECT_EQ(output(1), row.of_60_60) << row.operation;
        values({60, 40});
        EXPECT_EQ(output(1), row.of_60_40) << row.operation;
    }
    set8(0x4150, 1, 15);
    values({60, 0});
    EXPECT_EQ(output(1), 0) << "divided by zero";
}

TEST_F(Ax130751Math, GainsOf75And25PercentWeightTheInputs) {
    verifies<req::AOR_K_GAIN_ONE, req::AOR_MATH_019>();
    make(1, 2);
    set8(0x4140, 1, 75);
    set8(0x4140, 2, 25);
    values({100, 0});
    EXPECT_EQ(output(1), 7500);
    values({100, 100});
    EXPECT_EQ(output(1), 10000);
    values({40, 60});
    EXPECT_EQ(output(1), 4500);  // 0.75 * 40 + 0.25 * 60 = 30 + 15 = 45 %
    EXPECT_EQ(write(0x4140, 1, 101, 1), "06090031");
    EXPECT_EQ(write(0x4140, 1, -101, 1), "06090032");
}

TEST_F(Ax130751Math, MathInputScalingHasItsOwnDecimalDigits) {
    verifies<req::AOR_MATH_001, req::AOR_MATH_020>();
    make(1, 2);
    set8(0x4103, 1, 1);
    set16(0x4120, 1, 200);   // an input of 20.0 becomes 0
    set16(0x4122, 1, 1000);  // an input of 100.0 becomes 1
    values({40, 0});
    EXPECT_EQ(output(1), 2500);
    values({10, 0});
    EXPECT_EQ(output(1), 0);
}

TEST_F(Ax130751Math, ThreeFunctionsFormAChain) {
    verifies<req::AOR_MATH_002, req::AOR_MATH_023>();
    make(2, 4);
    set8(0x4250, 2, 14);
    set8(0x4250, 3, 13);
    values({20, 60, 50, 10});
    EXPECT_EQ(output(2), 3000);  // (0.2 + 0.6) * 0.5 - 0.1
}

TEST_F(Ax130751Math, MathFunctionWithAnUnusedInputIsSkipped) {
    verifies<req::AOR_MATH_007, req::AOR_MATH_011, req::AOR_MATH_016>();
    make(1, 4);
    set8(0x4100, 3, not_used);
    set8(0x4150, 2, 14);
    values({20, 30, 50, 10});
    EXPECT_EQ(output(1), 6000);  // 0.2 + 0.3 + 0.1
    set8(0x4100, 4, not_used);
    pass(1);
    EXPECT_EQ(output(1), 5000);
    set8(0x4100, 2, not_used);
    set16(0x4021, 1, 500);
    pass(1);
    EXPECT_EQ(output(1), 0) << "no function to do: 0, not scaling 1";
}

TEST_F(Ax130751Math, DisabledMathBlockIsZeroDespiteItsScaling) {
    verifies<req::AOR_MATH_011, req::AOR_SRC_009>();
    set16(0x4021, 1, 500);
    pass(1);
    EXPECT_EQ(output(1), 0);
    make(1, 2);
    values({0, 0});
    EXPECT_EQ(output(1), 500);
}

TEST_F(Ax130751Math, MathOutputFollowsItsScalingAndDecimalDigits) {
    verifies<req::AOR_MATH_008, req::AOR_MATH_025>();
    make(1, 2);
    set8(0x4032, 1, 1);
    set16(0x4021, 1, -200);  // scaling 1: -20.0
    set16(0x4023, 1, 200);   // scaling 2: 20.0
    values({75, 0});
    EXPECT_EQ(output(1), 100);
    values({100, 100});
    EXPECT_EQ(output(1), 200);
    // Math block 1 gives other blocks 10.0 as its value; math block 2 scales its input from 0…20 to 0…1.
    values({75, 0});
    set8(0x4200, 1, math_source);
    set8(0x4201, 1, 1);
    set8(0x4200, 2, canopen);
    set8(0x4201, 2, 9);
    set16(0x4222, 1, 2000);
    set8(0x4000, 2, 1);
    pass(1);
    EXPECT_EQ(output(2), 5000);
}

TEST_F(Ax130751Math, NegativeDifferenceIsClampedUnlessAGainIsNegative) {
    verifies<req::AOR_MATH_005>();
    make(1, 3);
    set8(0x4150, 1, 13);
    values({20, 50, 90});
    EXPECT_EQ(output(1), 9000) << "0 + 0.9";
    set8(0x4140, 1, -100);
    pass(1);
    EXPECT_EQ(output(1), 2000) << "-0.2 - 0.5 + 0.9";
}

TEST_F(Ax130751Math, QuotientByANegativeNumberIsNegative) {
    verifies<req::AOR_MATH_004, req::AOR_T21>();
    make(1, 3);
    set8(0x4150, 1, 15);
    set8(0x4140, 2, -100);
    values({30, 60, 90});
    EXPECT_EQ(output(1), 4000);  // 0.3 / -0.6 + 0.9 = -0.5 + 0.9
    values({30, 0, 90});
    EXPECT_EQ(output(1), 9000) << "a division by 0 gives 0";
}

/// Function 1 is the greater of 2500h:2 and 1 % of its own result of the cycle before. After 160 cycles, 0.5 * 0.01^160
/// is below the least number that a double can hold, 4.9e-324.
TEST_F(Ax130751Math, FedBackShareOf1PercentFadesToZero) {
    verifies<req::AOR_MATH_009, req::AOR_MATH_015>();
    make(1, 2);
    set8(0x4150, 1, 17);
    set8(0x4101, 1, 1);
    set8(0x4100, 1, math_source);
    set8(0x4102, 1, 1);
    set8(0x4140, 1, 1);
    values({0, 50});
    EXPECT_EQ(output(1), 5000);
    values({0, 0});
    EXPECT_EQ(output(1), 50);
    pass(2);
    for (int cycle = 3; cycle < 200; ++cycle) {
        EXPECT_EQ(output(1), 0) << cycle;
        pass(1);
    }
    values({0, 50});
    EXPECT_EQ(output(1), 5000);
}

TEST_F(Ax130751Math, FunctionNumberOfAnInputSelectsAFunctionOfTheSameMathBlock) {
    verifies<req::AOR_MATH_009, req::AOR_MATH_014, req::AOR_MATH_010>();
    make(1, 4);
    set8(0x4150, 2, 14);
    values({20, 60, 50, 0});
    EXPECT_EQ(output(1), 4000);  // (0.2 + 0.6) * 0.5 + 0 = 0.4
    set8(0x4102, 4, 1);
    pass(1);
    EXPECT_EQ(output(1), 4000) << "no effect on another source";
    set8(0x4102, 1, 1);
    pass(1);
    EXPECT_EQ(output(1), 4000) << "nor on 2500h:1 in block 1";
    set8(0x4102, 1, 0);
    set8(0x4101, 4, 2);
    set8(0x4100, 4, math_source);
    pass(1);
    EXPECT_EQ(output(1), 4000) << "nor on another block, which is 0";
    set8(0x4101, 4, 1);
    pass(1);
    EXPECT_EQ(output(1), 10000) << "0.4 + function 1, 0.8, not scaled, held at 1";
    set8(0x4140, 4, 50);
    pass(1);
    EXPECT_EQ(output(1), 8000) << "times its gain";
    set8(0x4140, 4, -50);
    pass(1);
    EXPECT_EQ(output(1), 0);
    set8(0x4140, 4, 25);
    set8(0x4102, 4, 0);
    set16(0x4122, 4, 10000);
    set8(0x4103, 4, 2);
    pass(50);
    // the output x is an input of its own block: x = 0.4 + x / 4, so x = 0.5333
    EXPECT_EQ(output(1), 5333) << "the block's own output of the cycle before";
    // With 4023h = 5000 the output is half the result: x = (0.4 + x / 4) / 2 has the solution 0.4 / 1.75 = 0.22857.
    set16(0x4023, 1, 5000);
    pass(50);
    EXPECT_EQ(output(1), 2286) << "not the result of its last function";
}

TEST_F(Ax130751Math, FedBackSumGrowsWhileTheOutputIsConstant) {
    verifies<req::AOR_MATH_015, req::AOR_OUT_030>();
    make(1, 3);
    set8(0x4150, 2, 3);  // output: (function 1 of the previous cycle + 2500h:2) >= 2500h:3
    set8(0x4101, 1, 1);
    set8(0x4100, 1, math_source);
    set8(0x4102, 1, 1);
    values({0, 0, 50});
    pass(10);
    EXPECT_EQ(output(1), 0);
    pass(10);
    set16(0x2500, 2, 1);  // the sum grows by 1 % per cycle
    pass(45);
    EXPECT_EQ(device->objects().read(0x4030, 1), 0U);
    pass(10);
    EXPECT_EQ(output(1), 10000);
}

TEST_F(Ax130751Math, InputInErrorCountsAsZero) {
    verifies<req::AOR_MATH_006>();
    set32(0x1401, 1, 0x4000037F);
    set16(0x1401, 5, 50);  // event timer of RPDO2, which maps 2500h:1 to 2500h:3: 50 ms
    make(1, 1);
    set8(0x4101, 2, 7);  // 2500h:4 (EC Extra Received Process Value), which RPDO3 maps; RPDO3 is not valid
    set8(0x4100, 2, canopen);
    set8(0x4103, 2, 0);
    set16(0x4122, 2, 100);
    set16(0x2500, 4, 30);
    start();
    send("37F#280000000000");
    pass(2);
    EXPECT_EQ(output(1), 7000);
    pass(60);
    EXPECT_EQ(output(1), 3000);
}

TEST_F(Ax130751Math, DisablingAMathBlockClearsItsFedBackSum) {
    verifies<req::AOR_MATH_008, req::AOR_MATH_015>();
    make(1, 3);
    set8(0x4150, 2, 3);  // output: (function 1 of the previous cycle + 2500h:2) >= 2500h:3
    set8(0x4101, 1, 1);
    set8(0x4100, 1, math_source);
    set8(0x4102, 1, 1);
    values({0, 1, 50});  // the sum grows by 1 % per cycle
    pass(60);
    EXPECT_EQ(output(1), 10000);
    set16(0x2500, 2, 0);
    pass(5);
    EXPECT_EQ(output(1), 10000) << "the sum stays";
    set8(0x4000, 1, 0);
    pass(2);
    set8(0x4000, 1, 1);
    pass(5);
    EXPECT_EQ(output(1), 0) << "the sum begins at 0";
}

TEST_F(Ax130751Math, NewMathGainOf0AppliesAtOnce) {
    verifies<req::AOR_K_GAIN_ONE>();
    make(1, 2);
    set8(0x4140, 1, 50);
    values({20, 35});
    EXPECT_EQ(output(1), 4500);  // 20 * 0.5 + 35 = 45 %
    set8(0x4140, 1, 0);
    pass(1);
    EXPECT_EQ(output(1), 3500);
}

}  // namespace canproof::test
