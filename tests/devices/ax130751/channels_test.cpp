// SPDX-License-Identifier: Apache-2.0
// Tests that each output of an AX130751 follows its own parameters while the other output has different ones (manual,
// 1.2, 1.3).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751Channels : public Ax130751Blocks {
  protected:
    void SetUp() override {
        Ax130751Blocks::SetUp();
        no_ramps(1);
        no_ramps(2);
    }
    /// Connects the enable or override input of output n to 2500h:n (EC Extra Received Process Value).
    void connect(std::uint16_t source_index, int output) {
        extra_as_percent(output);
        set8(source_index, output, canopen);
        set8(static_cast<std::uint16_t>(source_index + 1), output, 3 + output);
    }
    /// Sends RPDO1 and RPDO4, whose time-out is 50 ms, and waits for 60 ms. RPDO1 sets both process values (7300h) and
    /// the relay (6220h:3), RPDO4 sets the states of both outputs (6220h:1, 6220h:2).
    void lose_commands() {
        set16(0x1400, 5, 50);
        set16(0x1403, 5, 50);
        start();
        send("27F#A00FA00F00");  // commands 4 V at each output
        send("57F#0101");
        pass(60);
    }
};

}  // namespace

TEST_F(Ax130751Channels, EachOutputHasItsOwnOverrideInputResponseAndValue) {
    verifies<req::AOR_OUT_010, req::AOR_T08, req::AOR_DO_006>();
    for (const int type : {10, 1020}) {
        for (const int ours : {1, 2}) {
            SCOPED_TRACE(fmt::format("type {}, output {}", type, ours));
            const int other = 3 - ours;
            for (const int output : {1, 2}) {
                set16(0x6310, output, type);
                connect(0x2360, output);
                set16(0x2500, output, 0);
                // `ours` is overridden while its override input is OFF, the other output while its override input is ON
                set8(0x2362, output, output == ours ? 1 : 0);
                set16(0x2300, output, output == ours ? 1 : 0);
            }
            pass(1);
            EXPECT_EQ(get16(0x7330, ours), 1);
            EXPECT_EQ(get16(0x7330, other), 0);
            EXPECT_EQ(is_on(ours), type == 1020);
            EXPECT_FALSE(is_on(other));
            extra(ours, 100);
            EXPECT_EQ(get16(0x7330, ours), 0) << "not overridden, and no command";
        }
    }
}

TEST_F(Ax130751Channels, EachOutputHasItsOwnEnableInputAndResponse) {
    verifies<req::AOR_OUT_009, req::AOR_T07>();
    command(1, 4000);
    command(2, 4000);
    for (const int ours : {1, 2}) {
        SCOPED_TRACE(ours);
        const int other = 3 - ours;
        for (const int output : {1, 2}) {
            connect(0x2350, output);
            set16(0x2500, output, 0);
            // `ours` is shut off while its enable input is OFF, the other output while its enable input is ON
            set8(0x2352, output, output == ours ? 0 : 3);
        }
        pass(1);
        EXPECT_FLOAT_EQ(volts(ours), 0.0F);
        EXPECT_FLOAT_EQ(volts(other), 4.0F);
        extra(ours, 100);
        EXPECT_FLOAT_EQ(volts(ours), 4.0F);
        extra(other, 100);
        EXPECT_FLOAT_EQ(volts(ours), 4.0F);
        EXPECT_FLOAT_EQ(volts(other), 0.0F);
    }
}

TEST_F(Ax130751Channels, EachAnalogueOutputHasItsOwnFaultModeAndValue) {
    verifies<req::AOR_OUT_011, req::AOR_T09, req::AOR_OUT_042>();
    for (const int ours : {1, 2}) {
        SCOPED_TRACE(ours);
        const int other = 3 - ours;
        set8(0x6340, ours, 0);  // fault mode 0: the output keeps its value
        set8(0x6340, other, 1);
        set16(0x7341, ours, 1000);
        set16(0x7341, other, 2000);
        lose_commands();
        EXPECT_FLOAT_EQ(volts(ours), 4.0F);
        EXPECT_FLOAT_EQ(volts(other), 2.0F);
        set8(0x6340, ours, 1);
        pass(1);
        EXPECT_FLOAT_EQ(volts(ours), 1.0F);
    }
}

TEST_F(Ax130751Channels, EachDigitalOutputHasItsOwnFaultModeAndState) {
    verifies<req::AOR_DO_005, req::AOR_T02, req::AOR_DO_015>();
    set16(0x6310, 1, 1020);
    set16(0x6310, 2, 1020);
    for (const int ours : {1, 2}) {
        SCOPED_TRACE(ours);
        const int other = 3 - ours;
        set8(0x6250, ours, 0);  // fault mode 0: the output keeps its state
        set8(0x6250, other, 1);
        set8(0x6340, ours, 1);  // 6340h is the fault mode of an analogue output; it has no effect here
        set8(0x6340, other, 0);
        set8(0x6260, ours, 1);
        set8(0x6260, other, 0);
        lose_commands();
        EXPECT_TRUE(is_on(ours));
        EXPECT_FALSE(is_on(other));
        set8(0x6250, ours, 1);
        set8(0x6260, ours, 0);
        set8(0x6260, other, 1);
        pass(1);
        EXPECT_FALSE(is_on(ours));
        EXPECT_TRUE(is_on(other));
    }
}

TEST_F(Ax130751Channels, EachOutputHasItsOwnLevelPolarityAndBlinkRate) {
    verifies<req::AOR_OUT_021, req::AOR_DO_010, req::AOR_T_DIGITAL_RANGE, req::AOR_OUT_048, req::AOR_DO_020>();
    set16(0x6310, 1, 1020);
    set16(0x6310, 2, 1020);
    set8(0x6220, 1, 1);
    set8(0x6220, 2, 1);
    for (const int ours : {1, 2}) {
        SCOPED_TRACE(ours);
        const int other = 3 - ours;
        set8(0x2240, ours, 1);
        set8(0x2240, other, 0);
        set8(0x2241, ours, 0);
        set8(0x2241, other, 1);
        pass(1);
        EXPECT_FLOAT_EQ(level(ours), 12.0F);
        EXPECT_FLOAT_EQ(level(other), 5.0F);
        EXPECT_FLOAT_EQ(volts(ours), 12.0F);
        EXPECT_FLOAT_EQ(volts(other), 0.0F) << "inverse";
        set16(0x2223, ours, 20);
        set16(0x2223, other, 50);
        set8(0x2241, ours, 3);
        set8(0x2241, other, 3);
        pass(1 + 20);
        EXPECT_FALSE(is_on(ours));
        EXPECT_TRUE(is_on(other));
        pass(30);
        EXPECT_TRUE(is_on(ours)) << "third of 20 ms";
        EXPECT_FALSE(is_on(other));
    }
}

TEST_F(Ax130751Channels, EachScalingHasItsOwnDecimalDigits) {
    verifies<req::AOR_OUT_003, req::AOR_OUT_005>();
    for (const int output : {1, 2}) {
        SCOPED_TRACE(output);
        set8(0x6302, output, 1);  // process value in tenths, scaled from 100.0 to 300.0
        set16(0x7322, output, 3000);
        set16(0x7320, output, 1000);
        set8(0x6332, output, 2);  // field value in hundredths, scaled from 1.00 V to 9.00 V
        set16(0x7323, output, 900);
        set16(0x7321, output, 100);
        set8(0x2342, output, 0);
        command(output, 1000);
        EXPECT_FLOAT_EQ(volts(output), 1.0F);
        command(output, 1500);
        EXPECT_FLOAT_EQ(volts(output), 3.0F);
        command(output, 2999);
        EXPECT_FLOAT_EQ(volts(output), 8.996F);
        EXPECT_EQ(get16(0x7330, output), 900) << "8.996, rounded";
    }
}

// When an output gets another type, all signals of its previous type at the terminals are cleared.
TEST_F(Ax130751Channels, NewOutputTypeClearsTheSignalsOfTheOldTypeAtTheTerminals) {
    verifies<req::AOR_OUT_023, req::AOR_OUT_021, req::AOR_OUT_025>();
    struct Terminals {
        int type;
        float volts, milliamperes, duty, hertz, level;
        bool on;
    };
    const std::vector<Terminals> all{{1020, 5, 0, 0, 0, 5, true},     {10, 4, 0, 0, 0, 0, false},
                                     {40, 0, 0, 100, 1000, 5, false}, {20, 0, 4, 0, 0, 0, false},
                                     {500, 0, 0, 50, 4000, 5, false}, {0, 0, 0, 0, 0, 0, false}};
    set16(0x2380, 2, 1000);
    set8(0x6220, 2, 1);
    set16(0x7300, 2, 4000);
    for (const Terminals& before : all) {
        for (const Terminals& after : all) {
            SCOPED_TRACE(fmt::format("{} to {}", before.type, after.type));
            set16(0x6310, 2, before.type);
            pass(2);
            set16(0x6310, 2, after.type);
            pass(2);
            EXPECT_FLOAT_EQ(volts(2), after.volts);
            EXPECT_FLOAT_EQ(milliamperes(2), after.milliamperes);
            EXPECT_FLOAT_EQ(duty(2), after.duty);
            EXPECT_FLOAT_EQ(hertz(2), after.hertz);
            EXPECT_FLOAT_EQ(level(2), after.level);
            EXPECT_EQ(is_on(2), after.on);
        }
    }
}

TEST_F(Ax130751Channels, NewOutputTypeSetsOverrideAndFaultValuesTo0) {
    verifies<req::AOR_OUT_037, req::AOR_T_TYPE_DEFAULTS>();
    for (const int type : {20, 40, 500, 1000, 1020}) {
        for (const int ours : {1, 2}) {
            SCOPED_TRACE(fmt::format("type {}, output {}", type, ours));
            for (const int output : {1, 2}) {
                set16(0x6310, output, 10);
                for (const std::uint16_t index : std::array<std::uint16_t, 4>{0x2300, 0x7341, 0x7323, 0x7321}) {
                    set16(index, output, 1500);
                }
            }
            set16(0x6310, ours, type);
            EXPECT_EQ(get16(0x2300, ours), 0);
            EXPECT_EQ(get16(0x7341, ours), 0);
            EXPECT_EQ(get16(0x2300, 3 - ours), 1500);
            EXPECT_EQ(get16(0x7341, 3 - ours), 1500);
            EXPECT_EQ(get16(0x7321, 3 - ours), 1500);
            EXPECT_EQ(get16(0x7323, 3 - ours), 1500);
            set16(0x6310, ours, 0);
        }
    }
}

TEST_F(Ax130751Channels, WritingThePresentOutputTypeAgainKeepsTheScaling) {
    verifies<req::AOR_OUT_022, req::AOR_OUT_023>();
    set16(0x6310, 1, 20);
    set16(0x7323, 1, 16000);
    set16(0x7323, 2, 4000);
    store();
    send("000#817F");
    set16(0x6310, 1, 20);
    set16(0x6310, 2, 10);
    EXPECT_EQ(get16(0x7323, 1), 16000);
    EXPECT_EQ(get16(0x7323, 2), 4000);
    set16(0x6310, 1, 10);
    EXPECT_EQ(get16(0x7323, 1), 5000);
    EXPECT_EQ(get16(0x7323, 2), 4000);
}

TEST_F(Ax130751Channels, NewOutputTypeResetsTheLatchAndTheBlinking) {
    verifies<req::AOR_OUT_023, req::AOR_DO_004, req::AOR_DO_010>();
    set16(0x1800, 5, 0);  // 1800h:5 event timer of TPDO1: off
    set16(0x6310, 2, 1020);
    set8(0x2241, 2, 2);  // polarity 2: latched
    set8(0x6220, 2, 1);
    pass(1);
    set8(0x6220, 2, 0);
    pass(1);
    EXPECT_TRUE(is_on(2));
    set16(0x6310, 2, 1000);
    pass(1);
    EXPECT_FALSE(is_on(2));
    set8(0x2241, 2, 3);  // polarity 3: blinking
    set16(0x2223, 2, 40);
    set8(0x6220, 2, 1);
    pass(1 + 30);
    EXPECT_TRUE(is_on(2));
    set16(0x6310, 2, 1020);
    pass(1 + 39);
    EXPECT_TRUE(is_on(2)) << "40 ms from its new beginning";
    pass(1);
    EXPECT_FALSE(is_on(2));
    set16(0x6310, 2, 10);
    pass(200);
    EXPECT_EQ(device->next_deadline(), never) << "a voltage does not blink";
}

TEST_F(Ax130751Channels, DigitalOutputWithoutAControlTakesItsFaultStateAtAnOverrideError) {
    verifies<req::AOR_DO_005, req::AOR_OUT_029, req::AOR_OUT_033>();
    set16(0x6310, 2, 1020);
    set8(0x2340, 2, not_used);
    set8(0x6260, 2, 1);
    connect(0x2360, 2);
    set32(0x1401, 1, 0x4000037F);  // RPDO2, which maps 2500h:1 to 2500h:3, becomes valid
    set16(0x1401, 5, 50);
    start();
    send("37F#000000000000");
    pass(20);
    EXPECT_FALSE(is_on(2)) << "no control";
    pass(40);
    EXPECT_TRUE(is_on(2)) << "the override is in error";
    set16(0x2300, 2, 1);
    send("37F#000064000000");
    set8(0x6260, 2, 0);
    pass(2);
    EXPECT_TRUE(is_on(2)) << "overridden";
}

}  // namespace canproof::test
