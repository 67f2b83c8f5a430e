// SPDX-License-Identifier: Apache-2.0
// Tests the control sources of the AX130751 (manual, 1.3, Tables 4A, 4B and 5). The tests read the value of a source as
// the output of lookup table 1, and its limits from the X that the table accepts.
#include <limits>

#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

class Ax130751Sources : public Ax130751Blocks {
  protected:
    void SetUp() override {
        Ax130751Blocks::SetUp();
        // lookup table 1 has Y = X from -300 to 300, in tenths on both axes
        set8(0x3013, 0, 1);
        set8(0x3014, 0, 1);
        for (int point = 1; point <= 11; ++point) {
            set16(0x3017, point, point == 1 ? -3000 : 3000);
        }
        set32(0x3016, 1, -3000);
        for (int point = 11; point >= 2; --point) {
            set32(0x3016, point, 3000);
        }
    }
    /// Returns the value, in tenths, of control source `source` with the number `number`; 0 if this source has no
    /// value.
    int tenths(int source, int number) {
        set8(0x3010, 0, source);
        set8(0x3011, 0, number);
        pass(2);
        return get16(0x3018, 0);
    }
    /// Returns whether a pair of source and number counts as "not used". If so, output 1 is OFF; otherwise it has at
    /// least 1 V, the lower end of its scaling.
    bool is_not_used(int source, int number) {
        set8(0x2340, 1, source);
        set8(0x2341, 1, number);
        pass(2);
        return volts(1) < 0.5F;
    }
    /// Connects output 1 to 7300h:1 (AO Output Process Value) of RPDO1, and output 2 to 2500h:4 (EC Extra Received
    /// Process Value) of RPDO3. The outputs have no ramps; their fault value is 3 V.
    void control_by_two_rpdos() {
        for (const int output : {1, 2}) {
            no_ramps(output);
            set16(0x7341, output, 3000);
        }
        extra_as_percent(4);
        set8(0x2340, 2, canopen);
        set8(0x2341, 2, 7);
        set8(0x6302, 2, 0);
        set16(0x7322, 2, 100);
    }
    /// Checks the lowest and the highest X, in hundredths, that a source allows for a point of lookup table 2.
    void expect_limits(int source, int number, int low, int high) {
        SCOPED_TRACE(fmt::format("source {}, number {}", source, number));
        set8(0x3020, 0, source);
        set8(0x3021, 0, number);
        set8(0x3023, 0, 2);
        EXPECT_EQ(write(0x3026, 2, low, 4), "");
        EXPECT_EQ(write(0x3026, 2, low - 1, 4), "06090032");
        EXPECT_EQ(write(0x3026, 2, high, 4), "");
        EXPECT_EQ(write(0x3026, 2, high + 1, 4), "06090031");
    }
};

TEST_F(Ax130751Sources, EveryControlSourceAndNumberOfTable4BReadsItsObject) {
    verifies<req::AOR_SRC_001, req::AOR_SRC_002, req::AOR_SRC_003, req::AOR_SRC_009, req::AOR_T4A, req::AOR_T4B,
             req::AOR_DO_022>();
    set16(0x7300, 1, 1100);  // 1100 is 1.1 V
    set16(0x7300, 2, 2200);
    set8(0x6220, 3, 1);
    EXPECT_EQ(tenths(1, 1), 11);
    EXPECT_EQ(tenths(1, 2), 22);
    EXPECT_EQ(tenths(1, 3), 10);
    EXPECT_EQ(tenths(2, 1), 10);
    for (int number = 1; number <= 6; ++number) {
        set16(0x2500, number, 100 + number);  // 10.1 to 10.6, because 2500h has one decimal digit by default
        EXPECT_EQ(tenths(1, 3 + number), 100 + number);
    }
    for (int table = 2; table <= 10; ++table) {
        const auto base = static_cast<std::uint16_t>(table == 10 ? 0x3100 : 0x3000 + (0x10 * table));
        set8(base, 0, 1);
        set8(static_cast<std::uint16_t>(base + 1), 0, 9);
        set16(0x2500, 6, 10 * table);  // 2500h:6 is the number of the table, in tenths; by default, Y equals X
        EXPECT_EQ(tenths(3, table), 10 * table);
    }
    set8(0x3044, 0, 2);  // Y of table 4 now has two decimal digits; the new Y values make Y equal to X again
    for (int point = 1; point <= 11; ++point) {
        set16(0x3047, point, 1000 * (point - 1));
    }
    set16(0x2500, 6, 55);
    EXPECT_EQ(tenths(3, 4), 55);
    for (int block = 1; block <= 4; ++block) {
        const auto base = static_cast<std::uint16_t>(0x4000 + (0x100 * block));
        for (const int input : {1, 2}) {
            set8(base, input, 1);
            set8(static_cast<std::uint16_t>(base + 1), input, 4);
        }
        // operator 17 gives the larger input; both inputs are 2500h:1
        set8(static_cast<std::uint16_t>(base + 0x50), 1, 17);
        set8(0x4000, block, 1);
        set16(0x4023, block, 1000 * block);
        set16(0x2500, 1, 500);  // 2500h:1 (EC Extra Received Process Value) = 50.0
        EXPECT_EQ(tenths(4, block), 50 * block);
    }
    for (int block = 1; block <= 3; ++block) {
        set8(0x3300, block, 1);
        set8(static_cast<std::uint16_t>(0x3301 + (0x100 * block)), 1, 1 + block);
        set16(0x2500, 6, 70);
        EXPECT_EQ(tenths(5, block), 70);
    }
    no_ramps(1);
    no_ramps(2);
    EXPECT_EQ(tenths(6, 1), 11);
    EXPECT_EQ(tenths(6, 2), 22);
    EXPECT_EQ(tenths(7, 1), 11);
    EXPECT_EQ(tenths(7, 2), 22);
    inputs.supply = 27.26F;
    inputs.cpu_temperature = -12.34F;
    set_inputs();
    for (const int number : {0, 1, 7}) {
        EXPECT_EQ(tenths(8, number), 273) << "the number does not matter";
        EXPECT_EQ(tenths(9, number), -123);
    }
}

TEST_F(Ax130751Sources, ControlSourcesAndNumbersNotInTable4BCountAsNotUsed) {
    verifies<req::AOR_SRC_011, req::AOR_T4B>();
    no_ramps(1);
    set8(0x2342, 1, 0);
    set16(0x7321, 1, 1000);
    EXPECT_FALSE(is_not_used(1, 1));
    EXPECT_TRUE(is_not_used(0, 1));
    EXPECT_TRUE(is_not_used(1, 0));
    EXPECT_TRUE(is_not_used(1, 10));
    EXPECT_TRUE(is_not_used(2, 0));
    EXPECT_TRUE(is_not_used(2, 2));
    EXPECT_TRUE(is_not_used(3, 0));
    EXPECT_TRUE(is_not_used(4, 0));
    EXPECT_TRUE(is_not_used(4, 5));
    EXPECT_FALSE(is_not_used(4, 4)) << "a math block that is off is 0";
    EXPECT_TRUE(is_not_used(5, 0));
    EXPECT_TRUE(is_not_used(5, 4));
    EXPECT_TRUE(is_not_used(6, 0));
    EXPECT_TRUE(is_not_used(6, 3));
    EXPECT_TRUE(is_not_used(7, 3));
    EXPECT_FALSE(is_not_used(8, 0));
    EXPECT_FALSE(is_not_used(9, 0));
}

TEST_F(Ax130751Sources, DigitalOutputAsAControlSourceGivesItsCommandLogicOrDriveState) {
    verifies<req::AOR_SRC_002, req::AOR_T05>();
    set16(0x6310, 2, 1020);
    set8(0x2241, 2, 1);
    set8(0x6220, 2, 1);
    EXPECT_EQ(tenths(1, 2), 10) << "6220h:2";
    EXPECT_EQ(tenths(6, 2), 10) << "logic state";
    EXPECT_EQ(tenths(7, 2), 0) << "drive state, inverse";
    set8(0x2241, 2, 0);
    set8(0x6302, 2, 2);
    set8(0x6332, 2, 2);
    EXPECT_EQ(tenths(1, 2), 10) << "states have no decimal digits";
    EXPECT_EQ(tenths(6, 2), 10);
    EXPECT_EQ(tenths(7, 2), 10);
}

TEST_F(Ax130751Sources, SourceLimitsFollowTable5) {
    verifies<req::AOR_SRC_007, req::AOR_T05, req::AOR_SRC_008, req::AOR_E_QUANTITY>();
    for (int point = 11; point >= 3; --point) {
        set32(0x3026, point, 32000);
    }
    set32(0x3026, 1, -32000);
    expect_limits(1, 1, 0, 500);  // limits of 7320h (AO Output Scaling 1 PV) and 7322h: 0 to 5 V
    set16(0x7322, 2, 8000);
    set16(0x7320, 2, -2000);
    expect_limits(1, 2, -200, 800);
    expect_limits(1, 3, 0, 100);
    expect_limits(2, 1, 0, 100);
    set16(0x2522, 4, 450);
    set16(0x2520, 4, -50);
    expect_limits(1, 7, -500, 4500);  // -50 and 450 with one decimal digit
    set16(0x2522, 6, 300);
    set16(0x2520, 6, 20);
    expect_limits(1, 9, 200, 3000);
    expect_limits(4, 1, 0, 10000);  // limits of 4021h (Math Output Scaling 1 PV) and 4023h: 0 to 100 %
    set16(0x4021, 2, 3000);
    set16(0x4023, 2, -3000);
    expect_limits(4, 2, -3000, 3000);  // the smaller of the two scalings is the lower limit
    set8(0x4032, 3, 0);
    set16(0x4023, 3, 80);
    expect_limits(4, 3, 0, 8000);     // with 0 decimal digits, 80 is 80 %
    expect_limits(8, 0, 800, 3500);   // limits of 5022h (Under Voltage Threshold) and 5023h: 8 to 35 V
    expect_limits(9, 0, 6000, 8500);  // 5032h (Over Temperature Threshold) and 5033h: 85 - 25 = 60 to 85 degrees
    set16(0x7321, 1, 4000);
    set16(0x7323, 1, 1000);
    expect_limits(6, 1, 100, 400);
    expect_limits(7, 1, 100, 400);
    set8(0x3300, 1, 1);
    set8(0x3401, 1, 1);
    set8(0x3010, 0, 1);
    set8(0x3011, 0, 4);
    pass(2);
    expect_limits(5, 1, 0, 10000);  // a logic block gives a percentage: 0 to 100 %
    set16(0x3017, 1, -1500);        // table 1: -150.0 to 300.0
    pass(2);
    expect_limits(3, 1, -15000, 30000);
    set16(0x3017, 1, 0);
    for (int point = 2; point <= 11; ++point) {
        set16(0x3017, point, 900);
    }
    pass(2);
    expect_limits(3, 1, 0, 10000);  // the Y values are 0 to 90, within 0 to 100, so the limits are 0 to 100
}

TEST_F(Ax130751Sources, ReceivedValueIsValidBeforeItsFirstRpdo) {
    verifies<req::AOR_SRC_006>();
    no_ramps(1);
    set8(0x2342, 1, 0);
    set16(0x7321, 1, 1000);
    set16(0x7341, 1, 3000);
    set16(0x1400, 5, 20);
    start();
    pass(100);
    EXPECT_FLOAT_EQ(volts(1), 1.0F) << "0 of 7300h, not the fault value";
}

TEST_F(Ax130751Sources, NeverReceivedCommandAndExtraValueAreZero) {
    verifies<req::AOR_SRC_006>();
    set16(0x6310, 1, 1020);
    set8(0x2241, 1, 1);  // inverse: ON without a command
    set8(0x6250, 1, 1);
    set8(0x6260, 1, 0);  // fault state of output 1: OFF
    no_ramps(2);
    set16(0x7341, 2, 3000);
    extra_as_percent(4);
    set8(0x2341, 2, 7);  // 2500h:4 (EC Extra Received Process Value) of RPDO3
    set8(0x6302, 2, 0);
    set16(0x7322, 2, 100);
    set16(0x7321, 2, 1000);
    set32(0x1402, 1, 0x4000047F);
    for (const std::uint16_t rpdo : std::array<std::uint16_t, 2>{0x1402, 0x1403}) {
        set16(rpdo, 5, 20);
    }
    start();
    pass(100);
    EXPECT_TRUE(is_on(1)) << "0 of 6220h";
    EXPECT_FLOAT_EQ(volts(2), 1.0F) << "0 of 2500h";
    send("57F#0000");
    send("47F#000000000000");
    pass(19);
    EXPECT_TRUE(is_on(1));
    EXPECT_FLOAT_EQ(volts(2), 1.0F);
    pass(3);
    EXPECT_FALSE(is_on(1)) << "overdue";
    EXPECT_FLOAT_EQ(volts(2), 3.0F) << "overdue";
}

TEST_F(Ax130751Sources, SupplyAndTemperatureAreValidOutsideTheirLimits) {
    verifies<req::AOR_SRC_008, req::AOR_SRC_014>();
    inputs.supply = 7.54F;
    inputs.cpu_temperature = 99.04F;
    set_inputs();
    pass(20000);  // longer than any delay of the supply and temperature faults
    EXPECT_NE(read(0x1003, 0), 0U);
    EXPECT_EQ(tenths(supply_source, 0), 75);
    EXPECT_EQ(tenths(9, 0), 990);
}

/// The Y of the table goes from -300.0 to 300.0.
TEST_F(Ax130751Sources, InfiniteTemperatureGivesTheFirstOrTheLastYOfATable) {
    verifies<req::AOR_LT_036, req::AOR_LT_037>();
    for (const float sign : {-1.0F, 1.0F}) {
        inputs.cpu_temperature = sign * std::numeric_limits<float>::infinity();
        set_inputs();
        EXPECT_EQ(tenths(temperature_source, 0), sign < 0.0F ? -3000 : 3000);
    }
}

TEST_F(Ax130751Sources, OnlyObjectsMappedInTheOverdueRpdoAreInError) {
    verifies<req::AOR_SRC_004>();
    control_by_two_rpdos();
    set16(0x2500, 4, 50);
    set16(0x1400, 5, 50);
    start();
    send("27F#E803000000");
    pass(2);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
    EXPECT_FLOAT_EQ(volts(2), 2.5F);
    pass(60);
    EXPECT_FLOAT_EQ(volts(1), 3.0F);
    EXPECT_FLOAT_EQ(volts(2), 2.5F);
    send("27F#E803000000");
    pass(2);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
}

TEST_F(Ax130751Sources, OverdueRpdoThatMapsNoControlSourceLeavesAllSourcesValid) {
    verifies<req::AOR_SRC_004>();
    control_by_two_rpdos();
    set16(0x2500, 4, 50);
    set8(0x1601, 0, 0);
    set32(0x1601, 1, 0x22500110);  // RPDO2 maps 2250h:1 (Relay Blink Rate)
    set8(0x1601, 0, 1);
    set32(0x1401, 1, 0x4000037F);
    set16(0x1401, 5, 50);
    start();
    send("27F#E803000000");
    send("37F#E803");
    pass(60);
    EXPECT_EQ(read(0x1003, 1), 0x00008100U) << "RPDO2 is overdue";
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
    EXPECT_FLOAT_EQ(volts(2), 2.5F);
}

TEST_F(Ax130751Sources, EachRpdoIsOverdueAfterItsOwnEventTime) {
    verifies<req::AOR_SRC_004>();
    control_by_two_rpdos();
    set32(0x1402, 1, 0x4000047F);
    set16(0x1402, 5, 50);
    set16(0x1400, 5, 100);
    start();
    send("27F#E803000000");
    send("47F#320000000000");
    pass(10);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
    EXPECT_FLOAT_EQ(volts(2), 2.5F);
    pass(50);
    EXPECT_FLOAT_EQ(volts(1), 1.0F) << "RPDO1 has still 40 ms";
    EXPECT_FLOAT_EQ(volts(2), 3.0F);
    pass(41);  // 101 ms: RPDO1 is late now, and no other event has requested a cycle
    EXPECT_FLOAT_EQ(volts(1), 3.0F) << "the second one counts as well";
}

TEST_F(Ax130751Sources, LostHeartbeatIsDetectedWhileAnRpdoIsOverdue) {
    verifies<req::AOR_SRC_005>();
    no_ramps(2);
    set16(0x7341, 2, 3000);
    extra_as_percent(4);
    set8(0x2341, 2, 7);  // 2500h:4 (EC Extra Received Process Value), which RPDO3 maps; RPDO3 is not valid
    set8(0x6302, 2, 0);
    set16(0x7322, 2, 100);
    set16(0x2500, 4, 50);
    set32(0x1016, 2, 0x00050064);  // 1016h:2 consumer heartbeat time: node 5, 100 ms
    set16(0x1400, 5, 50);
    start();
    send("27F#E803000000");
    send("705#05");
    pass(60);
    EXPECT_EQ(read(0x1003, 1), 0x00008100U) << "RPDO1 is overdue";
    pass(10);
    EXPECT_FLOAT_EQ(volts(2), 2.5F);
    pass(31);
    EXPECT_FLOAT_EQ(volts(2), 3.0F) << "101 ms after the heartbeat";
}

TEST_F(Ax130751Sources, LostHeartbeatPutsAReceivedCommandInError) {
    verifies<req::AOR_SRC_005>();
    no_ramps(1);
    set16(0x7341, 1, 3000);
    command(1, 1000);
    set32(0x1016, 2, 0x00050064);  // 1016h:2 consumer heartbeat time: node 5, 100 ms
    send("705#05");
    pass(90);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
    pass(20);
    EXPECT_FLOAT_EQ(volts(1), 3.0F);
    set8(0x2340, 1, math_source);  // a math block cannot time out, unlike a received message
    pass(2);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    set8(0x2340, 1, canopen);
    pass(2);
    send("705#05");
    pass(2);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
}

TEST_F(Ax130751Sources, LostLifeGuardingPutsAReceivedCommandInError) {
    verifies<req::AOR_SRC_005>();
    no_ramps(1);
    set16(0x7341, 1, 3000);
    command(1, 1000);
    set16(0x100C, 0, 50);
    set8(0x100D, 0, 2);
    send("77F#R");
    pass(99);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
    pass(5);
    EXPECT_FLOAT_EQ(volts(1), 3.0F);
    send("77F#R");
    pass(2);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
}

}  // namespace canproof::test
