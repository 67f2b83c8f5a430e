// SPDX-License-Identifier: Apache-2.0
// Tests universal outputs of a digital type, which the tests set up by SDO (AX130751 manual, 1.2).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/output_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST_F(Ax130751Output, DigitalOutputOfBothTypesFollowsWriteState6220h) {
    verifies<req::AOR_DO_001, req::AOR_DO_009, req::AOR_SRC_002, req::AOR_S_DIGITAL, req::AOR_OUT_021,
             req::AOR_OUT_048>();
    for (const int type : {1000, 1020}) {
        SCOPED_TRACE(type);
        make(type);
        set8(0x6220, 1, 0);
        command(1, 1);
        EXPECT_FALSE(is_on(1)) << "7300h does not count";
        EXPECT_FLOAT_EQ(volts(1), 0.0F);
        EXPECT_EQ(get16(0x7330, 1), 0);
        EXPECT_EQ(get16(0x2370, 1), 0);
        set8(0x6220, 1, 1);
        pass(1);
        EXPECT_TRUE(is_on(1));
        EXPECT_FLOAT_EQ(volts(1), 5.0F);
        EXPECT_EQ(get16(0x7330, 1), 1);
        EXPECT_EQ(get16(0x2370, 1), 1);
        set8(0x2240, 1, 1);
        pass(1);
        EXPECT_FLOAT_EQ(volts(1), 12.0F);
        set8(0x2240, 1, 0);
    }
}

TEST_F(Ax130751Output, DigitalOutputFollowsItsPolarity) {
    verifies<req::AOR_DO_003, req::AOR_DO_007, req::AOR_T01, req::AOR_DO_017, req::AOR_DO_018, req::AOR_DO_019>();
    make(1020);
    const auto set = [this](int state) {
        set8(0x6220, 1, state);
        pass(1);
        return is_on(1);
    };
    EXPECT_TRUE(set(1));
    set8(0x2241, 1, 1);
    EXPECT_FALSE(set(1));
    EXPECT_EQ(get16(0x7330, 1), 1) << "logic state";
    EXPECT_EQ(get16(0x2370, 1), 0) << "drive state";
    EXPECT_TRUE(set(0));
    set8(0x2241, 1, 0);
    EXPECT_FALSE(set(0));
    set8(0x2241, 1, 2);
    EXPECT_FALSE(set(0));
    EXPECT_TRUE(set(1));
    pass(3);
    EXPECT_TRUE(is_on(1)) << "changes with an edge, not while it is ON";
    EXPECT_TRUE(set(0));
    EXPECT_FALSE(set(1));
    EXPECT_FALSE(set(0));
}

TEST_F(Ax130751Output, DigitalOutputBlinksAtItsRate) {
    verifies<req::AOR_DO_004, req::AOR_DO_010, req::AOR_DO_020>();
    make(1020);
    set8(0x2241, 1, 3);
    set16(0x2223, 1, 40);
    set8(0x6220, 1, 1);
    pass(1);
    for (int half = 0; half < 6; ++half) {
        EXPECT_EQ(is_on(1), half % 2 == 0) << half;
        pass(39);
        EXPECT_EQ(is_on(1), half % 2 == 0) << half;
        pass(1);
    }
    set8(0x6220, 1, 0);
    pass(1);
    EXPECT_FALSE(is_on(1));
}

TEST_F(Ax130751Output, AnalogueControlOfADigitalOutputHasHysteresis) {
    verifies<req::AOR_DO_002>();
    make(1020);
    set8(0x2340, 1, supply_source);  // its limits are 5022h (Under Voltage Threshold) and 5023h
    set8(0x5021, 0, 0);
    set8(0x5023, 0, 30);
    set8(0x5022, 0, 12);
    const auto at_volts = [this](float supply) {
        inputs.supply = supply;
        set_inputs();
        pass(1);
        return is_on(1);
    };
    EXPECT_FALSE(at_volts(24.0F));
    EXPECT_TRUE(at_volts(30.0F));
    EXPECT_TRUE(at_volts(12.1F));
    EXPECT_FALSE(at_volts(12.0F));
    EXPECT_FALSE(at_volts(29.9F));
}

TEST_F(Ax130751Output, DigitalOutputFollowsOverrideDisableAndFault) {
    verifies<req::AOR_DO_005, req::AOR_DO_006, req::AOR_DO_011, req::AOR_T02, req::AOR_DO_015>();
    make(1020);
    set8(0x2241, 1, 1);  // inverse polarity: without a command the output is ON, unless it is disabled or overridden
    connect(0x2350, 1);
    connect(0x2360, 2);
    EXPECT_TRUE(is_on(1));
    extra(1, 100);  // ON at the enable input disables the output (response 3), which is then shut off
    EXPECT_FALSE(is_on(1));
    set16(0x2300, 1, 1);
    extra(2, 100);
    EXPECT_TRUE(is_on(1)) << "overridden with a value that is not 0";
    set16(0x2300, 1, 0);
    pass(1);
    EXPECT_FALSE(is_on(1));
    extra(1, 0);
    extra(2, 0);
    EXPECT_TRUE(is_on(1));

    set32(0x1403, 1, 0x4000057F);
    set16(0x1403, 5, 50);  // event timer of RPDO4, which maps 6220h:1: 50 ms
    start();
    send("57F#0100");
    pass(5);
    EXPECT_FALSE(is_on(1));
    pass(60);
    EXPECT_TRUE(is_on(1)) << "6260h as shipped is ON, the polarity does not apply";
    send("57F#0100");
    pass(5);
    set8(0x6250, 1, 0);
    pass(60);
    EXPECT_FALSE(is_on(1)) << "maintains its state";
}

}  // namespace canproof::test
