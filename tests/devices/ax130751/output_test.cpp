// The universal outputs of the AX130751 over SDO (1.2, 1.3).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

class Ax130751Output : public Ax130751Blocks {
  protected:
    /// Output 1 of a type, without ramps, its profile also outside (2342h = 0).
    void make(int type) {
        set16(0x6310, 1, type);
        no_ramps(1);
        set8(0x2342, 1, 0);
        pass(1);
    }
    /// Input enable or override of output 1: number 3 + n of the CANopen messages, read as digital.
    void connect(std::uint16_t source_index, int number) {
        extra_as_percent(number);
        set8(source_index, 1, canopen);
        set8(static_cast<std::uint16_t>(source_index + 1), 1, 3 + number);
        pass(1);
    }
};

// --- scaling (Figure 3) --------------------------------------------------------------------------------------------

TEST_F(Ax130751Output, AsShippedItFollows7300hFrom0To5Volts) {
    verifies<req::AOR_OUT_003, req::AOR_OUT_005, req::AOR_S_VOLTAGE, req::AOR_T03>();
    no_ramps(1);
    command(1, 2500);  // 2.500 V of 0…5.000 V
    EXPECT_FLOAT_EQ(volts(1), 2.5F);
    EXPECT_EQ(get16(0x7330, 1), 2500);
    EXPECT_EQ(get16(0x2370, 1), 2500);
    command(1, 5000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    command(1, 9000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    EXPECT_FLOAT_EQ(volts(2), 0.0F);
    EXPECT_FALSE(is_on(1)) << "no digital output";
}

TEST_F(Ax130751Output, InverseSlope) {
    verifies<req::AOR_OUT_004>();
    make(10);
    set16(0x7321, 1, 10000);
    set16(0x7323, 1, -10000);
    command(1, 0);
    EXPECT_FLOAT_EQ(volts(1), 10.0F);
    command(1, 1250);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);  // 10 - 20 * 1.25 / 5
    command(1, 5000);
    EXPECT_FLOAT_EQ(volts(1), -10.0F);
}

TEST_F(Ax130751Output, DigitsOfProcessAndFieldValueAreTheirOwn) {
    verifies<req::AOR_OUT_005>();
    make(10);
    set8(0x6302, 1, 1);      // process value in tenths: 7320h…7322h are 0…500.0
    set8(0x6332, 1, 2);      // field value in hundredths of a volt
    set16(0x7321, 1, 0);     // 0 V
    set16(0x7323, 1, 1000);  // 10.00 V
    command(1, 2500);        // 250.0 of 500.0
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    EXPECT_EQ(get16(0x7330, 1), 500);
}

TEST_F(Ax130751Output, ControlResponseSwitchesOffOutsideOfTheProfile) {
    verifies<req::AOR_OUT_006, req::AOR_OUT_015, req::AOR_T06>();
    make(10);
    set16(0x7322, 1, 4000);
    set16(0x7320, 1, 1000);
    set16(0x7321, 1, 1000);
    set16(0x7323, 1, 4000);
    const auto at_ends = [this](int response) {
        set8(0x2342, 1, response);
        std::vector<float> seen;
        for (const int value : {999, 1000, 4000, 4001}) {
            command(1, value);
            seen.push_back(volts(1));
        }
        return seen;
    };
    EXPECT_EQ(at_ends(0), (std::vector<float>{1, 1, 4, 4}));
    EXPECT_EQ(at_ends(1), (std::vector<float>{0, 1, 4, 4}));
    EXPECT_EQ(at_ends(2), (std::vector<float>{1, 1, 4, 0}));
}

// --- types (Table 3) -----------------------------------------------------------------------------------------------

TEST_F(Ax130751Output, CurrentIsMeasuredThroughItsLoad) {
    verifies<req::AOR_OUT_018, req::AOR_OUT_019, req::AOR_S_CURRENT, req::AOR_S_LOAD, req::AOR_K_COMPLIANCE>();
    make(20);
    command(1, 20000);  // 20 mA
    EXPECT_FLOAT_EQ(milliamperes(1), 20.0F);
    EXPECT_EQ(get16(0x2370, 1), 20000);
    inputs.load[0] = 1000.0F;  // 14 V / 1 kOhm
    set_inputs();
    pass(1);
    EXPECT_FLOAT_EQ(milliamperes(1), 14.0F);
    EXPECT_EQ(get16(0x2370, 1), 14000);
    EXPECT_EQ(get16(0x7330, 1), 20000) << "the target stays";
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
}

TEST_F(Ax130751Output, NeitherLoadNorFrequencyOfAVoltageOutputMatter) {
    verifies<req::AOR_OUT_018, req::AOR_OUT_019, req::AOR_OUT_020>();
    make(10);
    set16(0x2380, 1, 0);
    inputs.load[0] = 10000.0F;  // 14 V would drive 1.4 mA through it
    set_inputs();
    command(1, 5000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    EXPECT_EQ(get16(0x2370, 1), 5000);
}

TEST_F(Ax130751Output, PwmHasTheFrequencyOf2380h) {
    verifies<req::AOR_OUT_020, req::AOR_OUT_021, req::AOR_S_DUTY, req::AOR_S_FREQUENCY, req::AOR_S_LEVEL>();
    make(40);
    set16(0x2380, 1, 1200);
    command(1, 375);  // 37.5 %
    EXPECT_FLOAT_EQ(duty(1), 37.5F);
    EXPECT_FLOAT_EQ(hertz(1), 1200.0F);
    EXPECT_FLOAT_EQ(level(1), 5.0F);
    set8(0x2240, 1, 1);
    pass(1);
    EXPECT_FLOAT_EQ(level(1), 12.0F);
}

TEST_F(Ax130751Output, PwmWithoutPulsesIsOff) {
    verifies<req::AOR_OUT_020, req::AOR_OUT_018, req::AOR_OD_2380>();
    make(40);
    command(1, 375);
    set16(0x2380, 1, 0);
    pass(1);
    EXPECT_FLOAT_EQ(duty(1), 0.0F);
    EXPECT_FLOAT_EQ(hertz(1), 0.0F);
    EXPECT_EQ(get16(0x7330, 1), 375);
    EXPECT_EQ(get16(0x2370, 1), 0);
    set16(0x2380, 1, 1);
    pass(1);
    EXPECT_FLOAT_EQ(duty(1), 37.5F);
}

TEST_F(Ax130751Output, FrequencyHasADutyCycleOfOneHalf) {
    verifies<req::AOR_OUT_020, req::AOR_OUT_016, req::AOR_K_FREQUENCY_DUTY>();
    make(500);
    command(1, 440);
    EXPECT_FLOAT_EQ(hertz(1), 440.0F);
    EXPECT_FLOAT_EQ(duty(1), 50.0F);
    EXPECT_FLOAT_EQ(level(1), 5.0F);
    set8(0x2342, 1, 1);
    command(1, 49);  // below scaling 1: OFF, no pulses
    EXPECT_FLOAT_EQ(hertz(1), 0.0F);
    EXPECT_FLOAT_EQ(duty(1), 0.0F);
}

TEST_F(Ax130751Output, VoltageAndCurrentDoNotDependOn2240h) {
    verifies<req::AOR_OUT_021>();
    make(10);
    set8(0x2240, 1, 1);
    command(1, 3000);
    EXPECT_FLOAT_EQ(volts(1), 3.0F);
    EXPECT_FLOAT_EQ(level(1), 0.0F);
    make(20);
    command(1, 3000);
    EXPECT_FLOAT_EQ(milliamperes(1), 3.0F);
    EXPECT_FLOAT_EQ(level(1), 0.0F);
}

TEST_F(Ax130751Output, NotUsedDrivesNothing) {
    verifies<req::AOR_OUT_025>();
    make(10);
    command(1, 3000);
    make(0);
    command(1, 3000);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    EXPECT_EQ(get16(0x7330, 1), 0);
    EXPECT_EQ(get16(0x2370, 1), 0);
}

TEST_F(Ax130751Output, StaysInTheRangeOfItsType) {
    verifies<req::AOR_OUT_016>();
    make(10);
    set16(0x7323, 1, 10000);
    set8(0x6332, 1, 2);  // the same integers are now 100.00 V
    command(1, 5000);
    EXPECT_FLOAT_EQ(volts(1), 10.0F);
    EXPECT_EQ(get16(0x7330, 1), 1000);
}

TEST_F(Ax130751Output, FieldValuesOutsideOfTheTypeAreRefused) {
    verifies<req::AOR_OUT_024>();
    for (const std::uint16_t index : std::array<std::uint16_t, 4>{0x7321, 0x7323, 0x2300, 0x7341}) {
        set16(0x6310, 1, 10);
        EXPECT_EQ(write(index, 1, 10000, 2), "") << index;
        EXPECT_EQ(write(index, 1, 10001, 2), "06090031") << index;
        EXPECT_EQ(write(index, 1, -10000, 2), "") << index;
        EXPECT_EQ(write(index, 1, -10001, 2), "06090032") << index;
        set16(0x6310, 1, 500);
        EXPECT_EQ(write(index, 1, 49, 2), "06090032") << index;
        EXPECT_EQ(write(index, 1, 50, 2), "") << index;
        EXPECT_EQ(write(index, 1, 0, 2), "") << index << ": OFF";
        EXPECT_EQ(write(index, 1, 30001, 2), "06090031") << index;
        set16(0x6310, 1, 20);
        EXPECT_EQ(write(index, 1, 24000, 2), "") << index;
        EXPECT_EQ(write(index, 1, 24001, 2), "06090031") << index;
        EXPECT_EQ(write(index, 1, -1, 2), "06090032") << index;
        set16(0x6310, 1, 0);
        EXPECT_EQ(write(index, 1, 32767, 2), "") << index;
    }
}

TEST_F(Ax130751Output, AnAutomaticUpdateWritesTheTypesOwnValues) {
    verifies<req::AOR_OUT_022, req::AOR_T_TYPE_DEFAULTS>();
    struct Row {
        int type, digits, scaling_1, scaling_2;
    };
    for (const auto& row : {Row{20, 3, 0, 20000}, Row{40, 1, 0, 1000}, Row{500, 0, 50, 30000}, Row{1020, 0, 0, 1},
                            Row{10, 3, 0, 5000}, Row{1000, 0, 0, 1}}) {
        set16(0x6310, 2, row.type);
        EXPECT_EQ(get8(0x6302, 2), row.digits) << row.type;
        EXPECT_EQ(get8(0x6332, 2), row.digits) << row.type;
        EXPECT_EQ(get16(0x7320, 2), row.scaling_1) << row.type;
        EXPECT_EQ(get16(0x7322, 2), row.scaling_2) << row.type;
        EXPECT_EQ(get16(0x7321, 2), row.scaling_1) << row.type;
        EXPECT_EQ(get16(0x7323, 2), row.scaling_2) << row.type;
        EXPECT_EQ(get16(0x2300, 2), 0) << row.type;
        EXPECT_EQ(get16(0x7341, 2), 0) << row.type;
    }
    EXPECT_EQ(get16(0x7322, 1), 5000) << "the other output is not concerned";
}

TEST_F(Ax130751Output, WithoutAutomaticUpdatesNothingIsWritten) {
    verifies<req::AOR_OUT_022>();
    set8(0x5550, 0, 0);
    set16(0x7341, 1, 1000);
    set16(0x6310, 1, 40);
    EXPECT_EQ(get8(0x6302, 1), 3);
    EXPECT_EQ(get16(0x7323, 1), 5000);
    EXPECT_EQ(get16(0x7341, 1), 1000);
}

TEST_F(Ax130751Output, NorForTheSameTypeOrForNone) {
    verifies<req::AOR_OUT_022>();
    set16(0x7323, 1, 4000);
    set16(0x6310, 1, 10);
    EXPECT_EQ(get16(0x7323, 1), 4000);
    set16(0x6310, 1, 0);
    EXPECT_EQ(get16(0x7323, 1), 4000);
}

TEST_F(Ax130751Output, ANewTypeBeginsOff) {
    verifies<req::AOR_OUT_023, req::AOR_OUT_014>();
    set8(0x5550, 0, 0);
    make(10);
    command(1, 5000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    set16(0x2330, 1, 1000);
    set16(0x6310, 1, 40);
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    EXPECT_FLOAT_EQ(duty(1), 0.0F);
    pass(500);
    EXPECT_FLOAT_EQ(duty(1), 2.5F) << "5 % in a second, from OFF";
}

// --- ramps (2330h, 2331h) ------------------------------------------------------------------------------------------

TEST_F(Ax130751Output, RampsPassTheWholeSpanInTheirTime) {
    verifies<req::AOR_OUT_012, req::AOR_OUT_013, req::AOR_OUT_017, req::AOR_OUT_018>();
    set8(0x2342, 1, 0);
    set16(0x2331, 1, 500);  // down; up 1000 as shipped
    command(1, 5000);       // the cycle that just ran began the ramp
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
    EXPECT_FLOAT_EQ(volts(1), 4.0F);  // 10 V/s
    command(1, 5000);
    EXPECT_FLOAT_EQ(volts(1), 3.99F);
    pass(200);
    EXPECT_FLOAT_EQ(volts(1), 4.99F) << "from where it stood";
}

TEST_F(Ax130751Output, UpIsARisingFieldValueAlsoWithAnInverseSlope) {
    verifies<req::AOR_OUT_012>();
    make(10);
    set16(0x7321, 1, 5000);
    set16(0x7323, 1, 0);
    set16(0x2330, 1, 1000);
    set16(0x2331, 1, 100);
    command(1, 5000);  // 0 V: nothing moves
    command(1, 0);     // 5 V: up
    pass(100);
    EXPECT_FLOAT_EQ(volts(1), 0.5F);
    pass(900);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    command(1, 5000);
    pass(50);
    EXPECT_FLOAT_EQ(volts(1), 2.5F);
}

TEST_F(Ax130751Output, TheSpanOfARampIsTheDistanceOfTheScalings) {
    verifies<req::AOR_OUT_012>();
    make(10);
    set16(0x7321, 1, 2000);
    set16(0x7323, 1, 4000);
    set16(0x2330, 1, 1000);
    set8(0x2342, 1, 1);
    set16(0x7320, 1, 100);  // 0 is below: OFF
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    command(1, 5000);
    pass(500);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);  // 2 V a second, also below the 2 V of scaling 1
    pass(1500);
    EXPECT_FLOAT_EQ(volts(1), 4.0F);
}

TEST_F(Ax130751Output, RespondsWithinTenMilliseconds) {
    verifies<req::AOR_OUT_002, req::AOR_K_CYCLE>();
    start();
    no_ramps(1);
    pass(100);
    for (int i = 1; i <= 20; ++i) {
        // RPDO1: 7300h:1, 7300h:2, 6220h:3
        send(fmt::format("27F#{}0000{:02X}", little_endian(static_cast<std::uint64_t>(200 * i), 2), i % 2));
        pass(9);
        EXPECT_FLOAT_EQ(volts(1), 0.2F * static_cast<float>(i));
        EXPECT_EQ(relay_on(), i % 2 == 1);
    }
}

// --- enable, override, fault (Tables 7 to 9, Figure 4) -------------------------------------------------------------

TEST_F(Ax130751Output, EnableResponsesOfTable7) {
    verifies<req::AOR_OUT_009, req::AOR_T07, req::AOR_OUT_014>();
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
        command(1, 2000);  // has no effect any more
        const int action = response % 3;
        if (action == 0) {
            EXPECT_FLOAT_EQ(volts(1), 0.0F) << "shut off";
        } else if (action == 1) {
            pass(99);  // 100 ms since it was disabled, 10 V/s
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

TEST_F(Ax130751Output, OverrideTakes2300hAtOnce) {
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
    set8(0x2362, 1, 1);  // override when OFF
    extra(2, 0);
    EXPECT_FLOAT_EQ(volts(1), -7.5F);
    extra(2, 100);
    pass(500);
    EXPECT_FLOAT_EQ(volts(1), -5.0F) << "ramps back from where it stood, 5 V a second";
}

TEST_F(Ax130751Output, OverrideComesBeforeEnable) {
    verifies<req::AOR_OUT_007>();
    make(10);
    set16(0x2300, 1, 1000);
    connect(0x2350, 1);  // response 3: enabled while OFF
    connect(0x2360, 2);
    command(1, 4000);
    extra(1, 100);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    extra(2, 100);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
}

TEST_F(Ax130751Output, WithoutAControlItIsOff) {
    verifies<req::AOR_OUT_008>();
    make(10);
    set16(0x7321, 1, 2000);
    command(1, 4000);
    set8(0x2340, 1, not_used);
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
}

TEST_F(Ax130751Output, WithoutAControlItRampsToOff) {
    verifies<req::AOR_OUT_008, req::AOR_OUT_012>();
    command(1, 5000);
    pass(1000);  // 5 V in a second, as shipped
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    set8(0x2340, 1, not_used);
    pass(1 + 500);
    EXPECT_FLOAT_EQ(volts(1), 2.5F);
    pass(500);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
}

TEST_F(Ax130751Output, AnOverrideThatIsNotUsedIsNotReadAsOff) {
    verifies<req::AOR_OUT_008, req::AOR_T08>();
    make(10);
    set16(0x2300, 1, -3000);
    set8(0x2360, 1, not_used);
    set8(0x2362, 1, 1);  // override when OFF
    command(1, 4000);
    EXPECT_FLOAT_EQ(volts(1), 4.0F);
    connect(0x2360, 2);
    EXPECT_FLOAT_EQ(volts(1), -3.0F);
}

TEST_F(Ax130751Output, WithoutAControlAnInverseDigitalOutputIsOffToo) {
    verifies<req::AOR_OUT_008>();
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

TEST_F(Ax130751Output, ADisabledDigitalOutputThatKeepsItsStateNeedsNoControl) {
    verifies<req::AOR_OUT_007, req::AOR_DO_006, req::AOR_OUT_008>();
    make(1020);
    set8(0x2241, 1, 0);
    set8(0x6220, 1, 1);
    connect(0x2350, 1);
    set8(0x2352, 1, 5);  // enabled when OFF, else it keeps its state
    extra(1, 0);
    EXPECT_TRUE(is_on(1));
    extra(1, 100);
    set8(0x2340, 1, not_used);
    pass(2);
    EXPECT_TRUE(is_on(1)) << "enable comes before control";
    extra(1, 0);
    EXPECT_FALSE(is_on(1)) << "enabled, but without a control";
}

TEST_F(Ax130751Output, AnInputInErrorTakes7341hOrKeeps) {
    verifies<req::AOR_OUT_011, req::AOR_T09, req::AOR_OUT_007, req::AOR_SRC_004>();
    make(10);
    set16(0x7341, 1, 1500);
    set16(0x1400, 5, 100);  // RPDO1 is expected every 100 ms
    start();
    send("27F#A00F000000");  // 4000: 4 V
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

TEST_F(Ax130751Output, AnEnableOrOverrideInErrorCountsToo) {
    verifies<req::AOR_OUT_011, req::AOR_OUT_007>();
    make(10);
    set16(0x7341, 1, 1500);
    set16(0x2300, 1, 3000);
    set32(0x1401, 1, 0x4000037F);  // RPDO2 exists
    set16(0x1401, 5, 100);
    connect(0x2360, 1);  // 2500h:1, mapped to RPDO2
    start();
    send("37F#640000000000");
    command(1, 4000);
    EXPECT_FLOAT_EQ(volts(1), 3.0F) << "overridden";
    pass(150);
    EXPECT_FLOAT_EQ(volts(1), 1.5F) << "an error comes before the override";
}

TEST_F(Ax130751Output, AnEnableInErrorTakes7341h) {
    verifies<req::AOR_OUT_011, req::AOR_OUT_007>();
    make(10);
    set16(0x7341, 1, 1500);
    set32(0x1401, 1, 0x4000037F);
    set16(0x1401, 5, 100);
    connect(0x2350, 1);
    set8(0x2352, 1, 0);  // runs while the enable is ON
    start();
    send("37F#640000000000");
    command(1, 4000);
    EXPECT_FLOAT_EQ(volts(1), 4.0F) << "enabled";
    pass(150);
    EXPECT_FLOAT_EQ(volts(1), 1.5F);
}

// --- digital (1.2) -------------------------------------------------------------------------------------------------

TEST_F(Ax130751Output, DigitalFollows6220hWithBothValuesOfTheType) {
    verifies<req::AOR_DO_001, req::AOR_SRC_002, req::AOR_S_DIGITAL, req::AOR_OUT_021>();
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

TEST_F(Ax130751Output, DigitalPolarities) {
    verifies<req::AOR_DO_003, req::AOR_DO_007, req::AOR_T01>();
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

TEST_F(Ax130751Output, DigitalBlinksAtItsRate) {
    verifies<req::AOR_DO_004>();
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
    set8(0x2340, 1, supply_source);  // limits 5022h and 5023h
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

TEST_F(Ax130751Output, DigitalOverrideDisableAndFault) {
    verifies<req::AOR_DO_005, req::AOR_DO_006, req::AOR_T02>();
    make(1020);
    set8(0x2241, 1, 1);  // inverse: ON as long as nothing else decides
    connect(0x2350, 1);
    connect(0x2360, 2);
    EXPECT_TRUE(is_on(1));
    extra(1, 100);  // disabled, shut off
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
    set16(0x1403, 5, 50);  // RPDO4 maps 6220h:1
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

// --- cycle ---------------------------------------------------------------------------------------------------------

TEST_F(Ax130751Output, PowerOnAndResetBeginOff) {
    verifies<req::AOR_OUT_026>();
    set8(0x2242, 1, 2);  // inverse: the relay is ON
    set16(0x7321, 1, 2000);
    set16(0x7320, 1, -5000);
    no_ramps(1);
    store();
    pass(10);
    EXPECT_FLOAT_EQ(volts(1), 3.5F);  // 2 V + half of 3 V
    EXPECT_TRUE(relay_on());
    const auto all_off = [this] { return volts(1) == 0.0F && !relay_on() && device->outputs().relay_no; };
    send("000#817F");
    EXPECT_TRUE(all_off()) << "reset";
    pass(1);
    EXPECT_TRUE(all_off()) << "pre-operational";
    start();
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 3.5F);
    EXPECT_TRUE(relay_on());
    power_on();
    EXPECT_TRUE(all_off()) << "power-on";
    EXPECT_FLOAT_EQ(get_real(0x5020), 24.0F) << "measured at once";
    start();
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 3.5F);
}

TEST_F(Ax130751Output, AResetPutsBothOutputsOffWithoutARamp) {
    verifies<req::AOR_OUT_026>();
    command(1, 5000);
    command(2, 5000);
    pass(1000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    EXPECT_FLOAT_EQ(volts(2), 5.0F);
    send("000#817F");
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    EXPECT_FLOAT_EQ(volts(2), 0.0F);
}

TEST_F(Ax130751Output, AChainRunsThroughInOneCycleAndALoopStepsOnce) {
    verifies<req::AOR_OUT_001>();
    // 2500h:1 → table 1 → logic 1 → math 1 → output 1, each 0 to 100
    extra_as_percent(1);
    extra_as_percent(2);
    set8(0x3010, 0, canopen);
    set8(0x3011, 0, 4);
    set8(0x3300, 1, 1);
    set8(0x4000, 1, 1);
    set8(0x4100, 1, logic_source);
    set8(0x4101, 1, 1);
    set8(0x4100, 2, canopen);
    set8(0x4101, 2, 5);
    no_ramps(1);
    set8(0x2340, 1, math_source);
    set8(0x6302, 1, 2);
    set16(0x7322, 1, 10000);
    pass(1);
    extra(1, 50);  // one cycle
    EXPECT_FLOAT_EQ(volts(1), 2.5F);
    // Math 2 adds 1 % to its own output: one step a cycle.
    set16(0x2500, 2, 1);
    for (const auto& [sub, source, number] : {std::tuple{1, math_source, 2}, std::tuple{2, canopen, 5}}) {
        set8(0x4200, sub, source);
        set8(0x4201, sub, number);
    }
    set16(0x4222, 2, 10000);
    set8(0x4000, 2, 1);
    pass(1);
    EXPECT_EQ(get16(0x4030, 2), 100);
    pass(1);
    EXPECT_EQ(get16(0x4030, 2), 200);
    pass(10);
    EXPECT_EQ(get16(0x4030, 2), 1200);
    pass(200);
    EXPECT_EQ(get16(0x4030, 2), 10000) << "bounded by its scaling";
}

TEST_F(Ax130751Output, AChainAgainstTheOrderTakesACycleForEachBlock) {
    verifies<req::AOR_OUT_001, req::AOR_OUT_002>();
    // 2500h:1 → table 10 → table 9 → … → table 1: ten cycles
    extra_as_percent(1);
    for (int table = 1; table <= 9; ++table) {
        set8(static_cast<std::uint16_t>(0x3000 + (0x10 * table)), 0, lookup_source);
        set8(static_cast<std::uint16_t>(0x3001 + (0x10 * table)), 0, table + 1);
    }
    set8(0x3100, 0, canopen);
    set8(0x3101, 0, 4);
    pass(100);
    set16(0x2500, 1, 70);
    pass(1);
    EXPECT_EQ(get16(0x3108, 0), 70);
    EXPECT_EQ(get16(0x3098, 0), 0);
    now = now + milliseconds(8);
    device->advance(now);  // nothing comes that would wake it
    EXPECT_EQ(get16(0x3028, 0), 70);
    EXPECT_EQ(get16(0x3018, 0), 0);
    pass(1);
    EXPECT_EQ(get16(0x3018, 0), 70);
}

TEST_F(Ax130751Output, AnOutputFollowsABlinkingOneACycleLater) {
    verifies<req::AOR_OUT_001, req::AOR_DO_004>();
    make(10);
    set8(0x2340, 1, 7);  // output 1 is 0 or 5 V with the drive state of output 2
    set8(0x2341, 1, 2);
    set8(0x6302, 1, 0);
    set16(0x7322, 1, 1);
    set16(0x6310, 2, 1020);
    set8(0x2241, 2, 3);
    set16(0x2223, 2, 40);
    pass(10);
    set8(0x6220, 2, 1);
    pass(1);
    EXPECT_TRUE(is_on(2));
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    for (int half = 0; half < 6; ++half) {
        pass(1);
        EXPECT_EQ(is_on(2), half % 2 == 0) << half;
        EXPECT_FLOAT_EQ(volts(1), half % 2 == 0 ? 5.0F : 0.0F) << half;
        pass(39);
    }
}

TEST_F(Ax130751Output, ALoopOfOutputsStepsOnceACycle) {
    verifies<req::AOR_OUT_001>();
    // Output 2 repeats what output 1 does, which is a tenth of a volt or of a milliampere more than output 2 did.
    const auto close_loop = [this](int type, int source, int full) {
        for (const int output : {1, 2}) {
            set16(0x6310, output, type);
            no_ramps(output);
            set8(0x2341, output, 3 - output);
            set16(0x7322, output, full);
            set16(0x7323, output, full);
        }
        set16(0x7322, 1, full - 100);
        set16(0x7321, 1, 100);
        set8(0x2340, 2, source);
        set8(0x2340, 1, not_used);  // OFF
        pass(10);
        set8(0x2340, 1, source);
    };
    close_loop(10, 7, 5000);
    pass(20);
    EXPECT_FLOAT_EQ(volts(1), 2.0F);
    pass(10);
    EXPECT_FLOAT_EQ(volts(2), 3.0F);
    // Through 1 MOhm 14 V drive 0.014 mA: the feedback stands, the targets grow.
    inputs.load = {1.0e6F, 1.0e6F};
    set_inputs();
    close_loop(20, 6, 20000);
    pass(20);
    EXPECT_EQ(get16(0x2370, 1), 14);
    EXPECT_EQ(get16(0x7330, 1), 2000);
    EXPECT_EQ(get16(0x7330, 2), 2000);
}

TEST_F(Ax130751Output, OtherDeadlinesDoNotShiftTheCycle) {
    verifies<req::AOR_OUT_001, req::AOR_OUT_027>();
    // Math 2 adds 1 % to its own output in every cycle; TPDO1 is due every 7 ms, half a millisecond after a cycle.
    send("000#807F");
    extra_as_percent(2);
    for (const auto& [sub, source, number] : {std::tuple{1, math_source, 2}, std::tuple{2, canopen, 5}}) {
        set8(0x4200, sub, source);
        set8(0x4201, sub, number);
    }
    set16(0x4222, 2, 10000);
    set8(0x4000, 2, 1);
    set16(0x1800, 5, 7);
    pass(10);
    now = now + Duration{500};
    start();
    set16(0x2500, 2, 1);
    EXPECT_EQ(pass(10).size(), 1U);
    EXPECT_EQ(device->objects().read(0x4030, 2), 1000U);
    EXPECT_EQ(pass(10).size(), 1U);
    EXPECT_EQ(device->objects().read(0x4030, 2), 2000U);
}

TEST_F(Ax130751Output, ALateCallMakesUpForWhatWasDue) {
    verifies<req::AOR_OUT_027>();
    send("000#807F");
    start();                 // TPDO1 from here on each 100 ms: 2370h:1 and 2370h:2
    send("27F#8813000000");  // 5 V: the ramp of a second begins with the cycle 1 ms later
    now = now + milliseconds(300);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"1FF#EF010000", "1FF#E3030000", "1FF#D7050000"}));  // 495, 995 and 1495 mV
    pass(1000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    now = now + milliseconds(300);  // nothing moves any more
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"1FF#88130000", "1FF#88130000", "1FF#88130000"}));
}

TEST_F(Ax130751Output, AFullQueueHoldsNoOutputUp) {
    verifies<req::AOR_OUT_027>();
    set16(0x1800, 5, 1);
    start();
    send("27F#8813000000");  // 5 V: the ramp of a second begins with the cycle 1 ms later
    now = now + milliseconds(501);
    device->advance(now);  // 501 TPDOs, which nobody takes away
    EXPECT_FLOAT_EQ(volts(1), 2.5F);
    EXPECT_EQ(sent().size(), TransmitQueue::capacity);
}

TEST_F(Ax130751Output, ASlowRampDoesNotFallAsleep) {
    verifies<req::AOR_OUT_012>();
    make(10);
    set16(0x7323, 1, 100);  // 0.1 V in 10 s: a digit in 100 ms
    set16(0x2330, 1, 10000);
    set16(0x7300, 1, 5000);
    pass(1);
    pass(5000);
    EXPECT_FLOAT_EQ(volts(1), 0.05F);
    EXPECT_EQ(get16(0x2370, 1), 50);
    pass(5000);
    EXPECT_FLOAT_EQ(volts(1), 0.1F);
}

TEST_F(Ax130751Output, NothingToDoNeedsNoCycle) {
    verifies<req::AOR_OUT_001>();
    set16(0x1800, 5, 0);  // no TPDO1
    pass(5000);
    EXPECT_EQ(device->next_deadline(), never) << "at rest";
    command(1, 5000);
    EXPECT_LE(device->next_deadline(), now + milliseconds(1)) << "a ramp is under way";
    pass(5000);
    EXPECT_EQ(device->next_deadline(), never);
    set16(0x6310, 2, 1020);
    set8(0x6220, 2, 1);
    pass(10);
    EXPECT_EQ(device->next_deadline(), never) << "nor has a digital output anything to do";
}

}  // namespace canproof::test
