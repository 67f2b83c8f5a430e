// SPDX-License-Identifier: Apache-2.0
// Tests how ramps, enable, override and inputs in error determine a universal output. The tests set it up by SDO
// (AX130751 manual, 1.2, 1.3).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/output_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

// --- ramps (2330h, 2331h) ------------------------------------------------------------------------------------------

TEST_F(Ax130751Output, RampCrossesTheWholeSpanInItsRampTime) {
    verifies<req::AOR_OUT_012, req::AOR_OUT_013, req::AOR_OUT_017, req::AOR_OUT_018>();
    set8(0x2342, 1, 0);
    set16(0x2331, 1, 500);  // ramp times: up 1000 ms (the default), down 500 ms
    command(1, 5000);       // the ramp begins in the cycle that this call runs
    EXPECT_EQ(get16(0x7330, 1), 5000);
    EXPECT_EQ(get16(0x2370, 1), 0);
    pass(250);
    EXPECT_FLOAT_EQ(volts(1), 1.25F);
    pass(749);
    EXPECT_FLOAT_EQ(volts(1), 4.995F);
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    command(1, 0);
    pass(100);
    EXPECT_FLOAT_EQ(volts(1), 4.0F);  // the ramp falls by 10 V per second
    command(1, 5000);
    EXPECT_FLOAT_EQ(volts(1), 3.99F);
    pass(200);
    EXPECT_FLOAT_EQ(volts(1), 4.99F) << "from where it stood";
}

TEST_F(Ax130751Output, RampUpTimeAlsoAppliesToARisingFieldValueOfAnInverseSlope) {
    verifies<req::AOR_OUT_012>();
    make(10);
    set16(0x7321, 1, 5000);
    set16(0x7323, 1, 0);
    set16(0x2330, 1, 1000);
    set16(0x2331, 1, 100);
    command(1, 5000);  // a command of 5000 gives 0 V: the output stays at 0 V
    command(1, 0);     // a command of 0 gives 5 V: the output rises
    pass(100);
    EXPECT_FLOAT_EQ(volts(1), 0.5F);
    pass(900);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    command(1, 5000);
    pass(50);
    EXPECT_FLOAT_EQ(volts(1), 2.5F);
}

TEST_F(Ax130751Output, RampSpanIsTheDistanceBetweenScaling1AndScaling2) {
    verifies<req::AOR_OUT_012>();
    make(10);
    set16(0x7321, 1, 2000);
    set16(0x7323, 1, 4000);
    set16(0x2330, 1, 1000);
    set8(0x2342, 1, 1);
    set16(0x7320, 1, 100);  // a command of 0 is below 7320h (AO Output Scaling 1 PV), so the output is OFF
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    command(1, 5000);
    pass(500);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);  // the ramp rises from 0 V by 2 V per second, although the scaling begins at 2 V
    pass(1500);
    EXPECT_FLOAT_EQ(volts(1), 4.0F);
}

TEST_F(Ax130751Output, OutputRespondsWithinTenMilliseconds) {
    verifies<req::AOR_OUT_002, req::AOR_K_CYCLE>();
    start();
    no_ramps(1);
    pass(100);
    for (int i = 1; i <= 20; ++i) {
        // RPDO1 sets both process values (7300h) and the relay (6220h:3)
        send(fmt::format("27F#{}0000{:02X}", little_endian(static_cast<std::uint64_t>(200 * i), 2), i % 2));
        pass(9);
        EXPECT_FLOAT_EQ(volts(1), 0.2F * static_cast<float>(i));
        EXPECT_EQ(relay_on(), i % 2 == 1);
    }
}

// --- enable, override, fault (Tables 7 to 9, Figure 4) -------------------------------------------------------------

TEST_F(Ax130751Output, EnableResponsesFollowTable7) {
    verifies<req::AOR_OUT_009, req::AOR_T07, req::AOR_OUT_014, req::AOR_E_OUTPUT_DRIVE>();
    for (int response = 0; response < 6; ++response) {
        SCOPED_TRACE(response);
        make(10);
        set16(0x2331, 1, 500);
        connect(0x2350, 1);
        set8(0x2352, 1, response);
        const int running = response < 3 ? 100 : 0;
        extra(1, running);
        command(1, 4000);
        EXPECT_FLOAT_EQ(volts(1), 4.0F);
        extra(1, 100 - running);
        command(1, 2000);  // this new command has no effect on the output
        const int action = response % 3;
        if (action == 0) {
            EXPECT_FLOAT_EQ(volts(1), 0.0F) << "shut off";
        } else if (action == 1) {
            pass(99);  // 100 ms after the output was disabled: it falls by 10 V/s
            EXPECT_FLOAT_EQ(volts(1), 3.0F) << "ramps off";
            EXPECT_EQ(get16(0x7330, 1), 0);
        } else {
            EXPECT_FLOAT_EQ(volts(1), 4.0F) << "kept";
        }
        set8(0x2350, 1, not_used);
        pass(2000);
        EXPECT_FLOAT_EQ(volts(1), 2.0F) << "an enable that is not used is ignored";
    }
}

TEST_F(Ax130751Output, OverrideSetsTheOutputToOverrideFieldValue2300hAtOnce) {
    verifies<req::AOR_OUT_010, req::AOR_T08, req::AOR_OUT_014>();
    make(10);
    set16(0x2330, 1, 1000);
    set16(0x2300, 1, -7500);
    connect(0x2360, 2);
    command(1, 0);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    extra(2, 100);
    EXPECT_FLOAT_EQ(volts(1), -7.5F);
    EXPECT_EQ(get16(0x7330, 1), -7500);
    set8(0x2362, 1, 1);  // override response 1: the override works while its input is OFF
    extra(2, 0);
    EXPECT_FLOAT_EQ(volts(1), -7.5F);
    extra(2, 100);
    pass(500);
    EXPECT_FLOAT_EQ(volts(1), -5.0F) << "ramps back from where it stood, 5 V a second";
}

TEST_F(Ax130751Output, OverridePrecedesEnable) {
    verifies<req::AOR_OUT_007>();
    make(10);
    set16(0x2300, 1, 1000);
    connect(0x2350, 1);  // enable response 3, the default: the output is enabled while this input is OFF
    connect(0x2360, 2);
    command(1, 4000);
    extra(1, 100);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    extra(2, 100);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
}

TEST_F(Ax130751Output, OutputWithoutAControlIsOff) {
    verifies<req::AOR_OUT_032>();
    make(10);
    set16(0x7321, 1, 2000);
    command(1, 4000);
    set8(0x2340, 1, not_used);
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
}

// A ramp acts only while the control drives the output (section 1.3).
TEST_F(Ax130751Output, OutputThatLosesItsControlIsOffAtOnceWhateverItsRampIs) {
    verifies<req::AOR_OUT_032, req::AOR_OUT_014>();
    set16(0x2330, 1, 0);
    set16(0x2331, 1, 20);  // 5 V in 20 ms
    command(1, 5000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    command(1, 0);
    pass(10);
    EXPECT_FLOAT_EQ(volts(1), 2.5F) << "a command of 0 is a control";
    set8(0x2340, 1, not_used);
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    EXPECT_EQ(get16(0x7330, 1), 0);
}

TEST_F(Ax130751Output, UnusedOverrideIsNotReadAsOff) {
    verifies<req::AOR_OUT_008, req::AOR_T08>();
    make(10);
    set16(0x2300, 1, -3000);
    set8(0x2360, 1, not_used);
    set8(0x2362, 1, 1);  // override response 1: the override works while its input is OFF
    command(1, 4000);
    EXPECT_FLOAT_EQ(volts(1), 4.0F);
    connect(0x2360, 2);
    EXPECT_FLOAT_EQ(volts(1), -3.0F);
}

TEST_F(Ax130751Output, InverseDigitalOutputWithoutAControlIsOff) {
    verifies<req::AOR_OUT_032>();
    make(1020);
    set8(0x2241, 1, 1);
    set8(0x6220, 1, 0);
    pass(1);
    EXPECT_TRUE(is_on(1)) << "inverse of OFF";
    set8(0x2340, 1, not_used);
    pass(1);
    EXPECT_FALSE(is_on(1));
    set16(0x2300, 1, 1);
    connect(0x2360, 1);
    extra(1, 100);
    EXPECT_TRUE(is_on(1)) << "an override needs no control";
}

TEST_F(Ax130751Output, DisabledDigitalOutputThatKeepsItsStateNeedsNoControl) {
    verifies<req::AOR_OUT_007, req::AOR_OUT_032, req::AOR_DO_016>();
    make(1020);
    set8(0x2241, 1, 0);
    set8(0x6220, 1, 1);
    connect(0x2350, 1);
    set8(0x2352, 1, 5);  // response 5: the output is enabled while the input is OFF, and keeps its state while the
                         // input is ON
    extra(1, 0);
    EXPECT_TRUE(is_on(1));
    extra(1, 100);
    set8(0x2340, 1, not_used);
    pass(2);
    EXPECT_TRUE(is_on(1)) << "enable comes before control";
    extra(1, 0);
    EXPECT_FALSE(is_on(1)) << "enabled, but without a control";
}

TEST_F(Ax130751Output, ControlInputInErrorSetsFaultValue7341hOrFreezesTheOutput) {
    verifies<req::AOR_OUT_011, req::AOR_T09, req::AOR_OUT_007, req::AOR_SRC_004, req::AOR_E_OUTPUT_DRIVE,
             req::AOR_OUT_042>();
    make(10);
    set16(0x7341, 1, 1500);
    set16(0x1400, 5, 100);  // RPDO1 is expected every 100 ms
    start();
    send("27F#A00F000000");  // RPDO1 brings 4000: 4 V
    pass(50);
    EXPECT_FLOAT_EQ(volts(1), 4.0F);
    pass(60);
    EXPECT_FLOAT_EQ(volts(1), 1.5F);
    send("27F#A00F000000");
    pass(2);
    EXPECT_FLOAT_EQ(volts(1), 4.0F) << "received again";
    set8(0x6340, 1, 0);
    pass(200);
    EXPECT_FLOAT_EQ(volts(1), 4.0F) << "maintains its state";
}

TEST_F(Ax130751Output, OverrideInputInErrorSetsTheFaultValue) {
    verifies<req::AOR_OUT_011, req::AOR_OUT_007>();
    make(10);
    set16(0x7341, 1, 1500);
    set16(0x2300, 1, 3000);
    set32(0x1401, 1, 0x4000037F);  // 1401h:1 COB-ID of RPDO2: valid
    set16(0x1401, 5, 100);
    connect(0x2360, 1);  // 2500h:1 (EC Extra Received Process Value), mapped to RPDO2
    start();
    send("37F#640000000000");
    command(1, 4000);
    EXPECT_FLOAT_EQ(volts(1), 3.0F) << "overridden";
    pass(150);
    EXPECT_FLOAT_EQ(volts(1), 1.5F) << "an override in error is not used; the fault value applies";
}

TEST_F(Ax130751Output, EnableInputInErrorSetsFaultValue7341h) {
    verifies<req::AOR_OUT_011, req::AOR_OUT_007>();
    make(10);
    set16(0x7341, 1, 1500);
    set32(0x1401, 1, 0x4000037F);
    set16(0x1401, 5, 100);
    connect(0x2350, 1);
    set8(0x2352, 1, 0);  // enable response 0: the output runs while its enable input is ON
    start();
    send("37F#640000000000");
    command(1, 4000);
    EXPECT_FLOAT_EQ(volts(1), 4.0F) << "enabled";
    pass(150);
    EXPECT_FLOAT_EQ(volts(1), 1.5F);
}

}  // namespace canproof::test
