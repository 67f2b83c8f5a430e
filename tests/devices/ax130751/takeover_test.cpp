// SPDX-License-Identifier: Apache-2.0
// Tests what a block of the AX130751 remembers and what it forgets while another input, such as an override, determines
// its output.
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751Takeover : public Ax130751Test {
  protected:
    /// Connects an input to extra received value `number` (2500h), scaled from 0 to 100.
    void connect(std::uint16_t source_index, int sub, int number) {
        write(0x2502, number, 0, 1);
        write(0x2522, number, 100, 2);
        write(static_cast<std::uint16_t>(source_index + 1), sub, 3 + number, 1);
        write(source_index, sub, 1, 1);
    }
    int table_1() { return static_cast<std::int16_t>(read(0x3018, 0)); }
    /// Sets 6220h:`number` (DO Write State 1 Output Line) and runs a cycle.
    void set_state(int number, int state) {
        write(0x6220, number, state, 1);
        pass(1);
    }
    /// Monitors node 5, which sends a heartbeat now and at each call of beat().
    void watch_node_5() {
        write(0x1016, 1, 0x00050064, 4);  // 1016h:1 consumer heartbeat time: node 5, 100 ms
        start();
        beat();
    }
    void beat() {
        send("705#05");
        pass(1);
    }
};

}  // namespace

// Section 1.2, Table 1: an output that begins to blink begins with ON
TEST_F(Ax130751Takeover, BlinkingRestartsAfterAnOverride) {
    verifies<req::AOR_DO_004>();
    write(0x6310, 1, 1020, 2);
    write(0x2241, 1, 3, 1);   // polarity 3: output 1 blinks while ON
    write(0x2223, 1, 40, 2);  // output 1 is ON for 40 ms, then OFF for 40 ms
    write(0x2360, 1, 2, 1);   // 6220h:3 overrides output 1
    write(0x2361, 1, 1, 1);
    write(0x2300, 1, 0, 2);  // the override switches output 1 OFF
    write(0x6220, 1, 1, 1);
    start();
    pass(1);
    EXPECT_TRUE(device->outputs().out_on[0]);
    pass(10);
    write(0x6220, 3, 1, 1);
    pass(50);  // without the override the output would be OFF from 40 ms to 80 ms
    EXPECT_FALSE(device->outputs().out_on[0]);
    write(0x6220, 3, 0, 1);
    pass(1);
    EXPECT_TRUE(device->outputs().out_on[0]);
    pass(39);
    EXPECT_TRUE(device->outputs().out_on[0]);
    pass(1);
    EXPECT_FALSE(device->outputs().out_on[0]) << "40 ms after the override";
}

// Sections 1.5.4, 1.2: after a change to time response the input counts as OFF until it reaches its upper limit
TEST_F(Ax130751Takeover, TableSwitchedToTimeResponseIgnoresAnEarlierOnStateOfItsInput) {
    verifies<req::AOR_LT_021>();
    write(0x2522, 1, 100, 2);  // 2500h:1 (EC Extra Received Process Value) is scaled from 0 to 100
    write(0x3011, 0, 4, 1);
    write(0x3010, 0, 1, 1);
    write(0x3015, 1, 1, 1);  // lookup table 1 has time response
    write(0x2500, 1, 100, 2);
    pass(5);
    EXPECT_NE(read(0x3018, 0), 0U) << "the profile runs";
    write(0x3015, 1, 0, 1);  // lookup table 1 has data response
    write(0x2500, 1, 0, 2);
    pass(5);
    write(0x2500, 1, 50, 2);
    pass(5);
    write(0x3015, 1, 1, 1);
    pass(5);
    EXPECT_EQ(read(0x3018, 0), 0U);
    write(0x2500, 1, 100, 2);
    pass(5);
    EXPECT_NE(read(0x3018, 0), 0U);
}

// only the input of a lookup table starts its time profile; a new point takes effect at once
TEST_F(Ax130751Takeover, TimeProfileContinuesWhileItsPointsAreWritten) {
    verifies<req::AOR_LT_010, req::AOR_LT_011, req::AOR_LT_007>();
    connect(0x3010, 0, 1);
    write(0x3015, 1, 1, 1);
    write(0x3016, 2, 100, 4);
    write(0x3017, 2, 50, 2);
    write(0x3015, 3, 0, 1);
    write(0x3300, 1, 1, 1);  // logic block 1 shows table 1 as a percentage of its limits
    start();
    write(0x2500, 1, 100, 2);
    pass(1 + 40);
    EXPECT_EQ(table_1(), 20);
    EXPECT_EQ(read(0x3320, 1), 200U) << "of 0 to 100";
    write(0x3017, 2, 200, 2);
    pass(1);
    EXPECT_EQ(table_1(), 82) << "41 of 100 ms on the way to 200";
    EXPECT_EQ(read(0x3320, 1), 410U) << "of 0 to 200";
    write(0x3016, 2, 50, 4);
    pass(1);
    EXPECT_EQ(table_1(), 168) << "42 of 50 ms";
    pass(8);
    EXPECT_EQ(table_1(), 200);
}

TEST_F(Ax130751Takeover, XOfPoint1OfThreeTablesFollowsTheMinimumOfOneSource) {
    verifies<req::AOR_LT_018>();
    connect(0x3010, 0, 1);
    connect(0x3070, 0, 1);
    connect(0x3100, 0, 1);
    write(0x2520, 1, -40, 2);
    write(0x2500, 1, -40, 2);
    for (const std::uint16_t table : std::array<std::uint16_t, 3>{0x3010, 0x3070, 0x3100}) {
        EXPECT_EQ(static_cast<std::int32_t>(read(static_cast<std::uint16_t>(table + 6), 1)), -40) << table;
        write(static_cast<std::uint16_t>(table + 7), 2, 90, 2);
    }
    start();
    pass(2);
    write(0x2520, 1, -90, 2);
    write(0x2500, 1, -40, 2);
    pass(1);
    for (const std::uint16_t table : std::array<std::uint16_t, 3>{0x3010, 0x3070, 0x3100}) {
        EXPECT_EQ(static_cast<std::int32_t>(read(static_cast<std::uint16_t>(table + 6), 1)), -90) << table;
        EXPECT_EQ(read(static_cast<std::uint16_t>(table + 8), 0), 45U) << "half way from (-90, 0) to (10, 90)";
    }
}

TEST_F(Ax130751Takeover, YOfPoint1OfATimeProfileDoesNotCountForTheMinimumOfTheTable) {
    verifies<req::AOR_LT_018, req::AOR_LT_023>();
    write(0x3021, 0, 1, 1);
    write(0x3020, 0, 3, 1);  // table 2 reads table 1
    write(0x3015, 1, 1, 1);
    write(0x3017, 1, -60, 2);
    EXPECT_EQ(read(0x3026, 1), 0U);
    write(0x3017, 3, -20, 2);
    EXPECT_EQ(static_cast<std::int32_t>(read(0x3026, 1)), -20);
}

// Section 1.6: a disabled logic block gives no value.
TEST_F(Ax130751Takeover, OutputGoesOffWhenTheLogicBlockThatControlsItIsDisabled) {
    verifies<req::AOR_OUT_032, req::AOR_LOGIC_014>();
    connect(0x3010, 0, 1);
    write(0x3300, 1, 1, 1);
    write(0x2340, 2, 5, 1);
    write(0x2341, 2, 1, 1);
    write(0x2342, 2, 0, 1);
    write(0x2330, 2, 0, 2);  // only 2331h (AO Ramp Down) has a ramp, of 1000 ms
    write(0x7321, 2, 1000, 2);
    start();
    pass(2);
    EXPECT_FLOAT_EQ(device->outputs().out_voltage[1], 1.0F) << "scaling 1 at 0 %";
    write(0x3300, 1, 0, 1);
    pass(2);
    EXPECT_FLOAT_EQ(device->outputs().out_voltage[1], 0.0F) << "no control: OFF at once";
    write(0x3300, 1, 1, 1);
    pass(2);
    EXPECT_FLOAT_EQ(device->outputs().out_voltage[1], 1.0F);
}

// Section 1.3: an enable is a safety interlock, which a disabled block must not release. Without inputs, the output of
// a math block is 0, which is read as OFF.
TEST_F(Ax130751Takeover, MathBlockEnablesOutputAndRelayOnlyWhileItIsSwitchedOn) {
    verifies<req::AOR_OUT_028, req::AOR_RELAY_018>();
    for (const std::uint16_t source : std::array<std::uint16_t, 2>{0x2350, 0x2280}) {
        write(static_cast<std::uint16_t>(source + 1), 1, 1, 1);
        write(source, 1, 4, 1);  // math block 1 enables
    }
    write(0x2352, 1, 3, 1);  // output 1 is enabled while its enable input is OFF
    write(0x2282, 1, 1, 1);  // and so is the relay
    write(0x2330, 1, 0, 2);
    start();
    write(0x7300, 1, 4000, 2);
    set_state(3, 1);
    for (const bool on : {true, false, true}) {
        SCOPED_TRACE(on);
        write(0x4000, 1, on ? 1 : 0, 1);
        pass(2);
        EXPECT_FLOAT_EQ(device->outputs().out_voltage[0], on ? 4.0F : 0.0F);
        EXPECT_EQ(device->outputs().relay_nc, on);
    }
}

// Section 1.2: a valid override determines the output whatever state its control has.
TEST_F(Ax130751Takeover, DigitalOutputIsOverriddenWhileItsControlIsInError) {
    verifies<req::AOR_OUT_029, req::AOR_DO_006, req::AOR_SRC_005>();
    write(0x6310, 2, 1020, 2);
    write(0x6260, 2, 1, 1);
    connect(0x2360, 2, 1);
    write(0x2360, 2, 8, 1);  // the supply overrides output 2; its limits are 8 and 35 V
    write(0x5021, 0, 0, 1);
    write(0x1016, 1, 0x00050064, 4);  // 1016h:1 consumer heartbeat time: node 5, 100 ms
    start();
    send("705#05");
    pass(90);
    EXPECT_FALSE(device->outputs().out_on[1]);
    pass(20);
    EXPECT_TRUE(device->outputs().out_on[1]) << "6260h: a lost heartbeat concerns 6220h as well";
    inputs.supply = 36.0F;
    set_inputs();
    pass(1);
    EXPECT_FALSE(device->outputs().out_on[1]) << "2300h is 0";
    inputs.supply = 8.0F;
    set_inputs();
    pass(1);
    EXPECT_TRUE(device->outputs().out_on[1]);
    send("705#05");
    pass(1);
    EXPECT_FALSE(device->outputs().out_on[1]) << "6220h:2 is 0";
}

TEST_F(Ax130751Takeover, LostHeartbeatPutsTheRelayOff) {
    verifies<req::AOR_SRC_005, req::AOR_RELAY_011>();
    write(0x1016, 3, 0x00050064, 4);
    // source 1 with number 3, and source 2 with number 1, both select 6220h:3 (DO Write State 1 Output Line)
    for (const int source : {1, 2}) {
        SCOPED_TRACE(source);
        write(0x2260, 1, source, 1);
        write(0x2261, 1, source == 1 ? 3 : 1, 1);
        start();
        write(0x6220, 3, 1, 1);
        send("705#05");
        pass(99);
        EXPECT_TRUE(device->outputs().relay_nc);
        pass(2);
        EXPECT_FALSE(device->outputs().relay_nc);
        send("705#05");
        pass(1);
        EXPECT_TRUE(device->outputs().relay_nc);
        pass(200);
    }
}

// Sections 1.2 and 1.4: a control that is in error does not drive a latch, so its changes do not count.
TEST_F(Ax130751Takeover, LatchedRelayIgnoresAChangeOfItsControlDuringAnErrorOfTheControl) {
    verifies<req::AOR_RELAY_025, req::AOR_RELAY_017>();
    watch_node_5();
    for (const int polarity : {3, 4}) {
        SCOPED_TRACE(polarity);
        const bool begins_on = polarity == 4;  // the inverse latch begins ON, and changes when the control goes OFF
        const int rest = begins_on ? 1 : 0;
        set_state(3, rest);
        write(0x2242, 1, polarity, 1);
        beat();
        EXPECT_EQ(device->outputs().relay_nc, begins_on);
        pass(101);
        EXPECT_FALSE(device->outputs().relay_nc) << "in error";
        set_state(3, 1 - rest);
        EXPECT_FALSE(device->outputs().relay_nc);
        beat();
        EXPECT_EQ(device->outputs().relay_nc, begins_on) << "the end of the error is no edge";
        set_state(3, rest);
        set_state(3, 1 - rest);
        EXPECT_EQ(device->outputs().relay_nc, !begins_on) << "the next edge counts";
    }
}

TEST_F(Ax130751Takeover, LatchedRelayIgnoresAChangeOfItsControlWhileTheControlHasNoValue) {
    verifies<req::AOR_RELAY_025>();
    connect(0x3010, 0, 1);  // table 1 has Y = X
    write(0x2242, 1, 3, 1);
    write(0x2261, 1, 1, 1);
    write(0x2260, 1, 3, 1);  // table 1 controls the relay
    start();
    pass(1);
    EXPECT_FALSE(device->outputs().relay_nc);
    write(0x3010, 0, 0, 1);
    pass(1);
    write(0x2500, 1, 100, 2);
    pass(1);
    write(0x3010, 0, 1, 1);
    pass(2);
    EXPECT_EQ(table_1(), 100);
    EXPECT_FALSE(device->outputs().relay_nc) << "a control that appears as ON is no edge";
    write(0x2500, 1, 0, 2);
    pass(1);
    write(0x2500, 1, 100, 2);
    pass(1);
    EXPECT_TRUE(device->outputs().relay_nc) << "the next edge counts";
}

TEST_F(Ax130751Takeover, LatchedOutputIgnoresAChangeOfItsControlDuringAnErrorOfTheControl) {
    verifies<req::AOR_DO_013, req::AOR_DO_021>();
    write(0x6310, 2, 1020, 2);
    write(0x2241, 2, 2, 1);  // polarity 2: latched logic
    write(0x6260, 2, 0, 1);  // the fault state is OFF
    watch_node_5();
    EXPECT_FALSE(device->outputs().out_on[1]);
    pass(101);
    set_state(2, 1);
    EXPECT_FALSE(device->outputs().out_on[1]) << "in error";
    beat();
    EXPECT_FALSE(device->outputs().out_on[1]) << "the end of the error is no edge";
    set_state(2, 0);
    set_state(2, 1);
    EXPECT_TRUE(device->outputs().out_on[1]) << "the next edge counts";
}

// Section 1.4: the unlatch input is read with every polarity. So the state of its hysteresis is known when a latch is
// selected.
TEST_F(Ax130751Takeover, UnlatchInputKeepsItsHysteresisStateWhenALatchIsSelected) {
    verifies<req::AOR_RELAY_005, req::AOR_DO_002>();
    connect(0x2270, 1, 1);
    start();
    write(0x2500, 1, 100, 2);
    pass(1);
    write(0x2500, 1, 50, 2);
    pass(1);
    write(0x2242, 1, 3, 1);
    pass(1);
    write(0x6220, 3, 1, 1);
    pass(1);
    EXPECT_FALSE(device->outputs().relay_nc) << "unlatched";
    write(0x2500, 1, 0, 2);
    write(0x6220, 3, 0, 1);
    pass(1);
    write(0x6220, 3, 1, 1);
    pass(1);
    EXPECT_TRUE(device->outputs().relay_nc);
}

// Section 1.8: supply and temperature are measured even while the detection of their faults is off
TEST_F(Ax130751Takeover, SupplyAndTemperatureAreMeasuredWithoutFaultDetection) {
    verifies<req::AOR_DIAG_001, req::AOR_DIAG_005, req::AOR_DIAG_018>();
    write(0x5021, 0, 0, 1);
    write(0x5031, 0, 0, 1);
    inputs.supply = 12.5F;
    inputs.cpu_temperature = 99.0F;
    set_inputs();
    EXPECT_EQ(pass(1), Frames{});
    EXPECT_EQ(read(0x5020, 0), 0x41480000U);  // 12.5 as REAL32
    EXPECT_EQ(read(0x5030, 0), 0x42C60000U);  // 99.0 as REAL32
}

}  // namespace canproof::test
