// SPDX-License-Identifier: Apache-2.0
// Runs the AX130751 with the most work per cycle: all blocks run, and every input reads a received value, with all
// RPDOs overdue, or the temperature. When these tests run on the microcontroller, src/target/run_suites measures the
// longest cycle. It must take at most 85 % of the cycle's period of 1 ms, the first cycle after power-on at most 100 %.
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

class Ax130751CycleLoad : public Ax130751Blocks {
  protected:
    /// Connects an input, whose source and number are 8-bit entries, to `source` and `source_number`.
    void connect(std::uint16_t source_index, int source_sub, std::uint16_t number_index, int number_sub) {
        set8(source_index, source_sub, source);
        set8(number_index, number_sub, source_number);
    }
    void run_all_tables() {
        for (int table = 1; table <= 10; ++table) {
            connect(table_object(table), 0, table_object(table, 1), 0);
            pass(1);  // waits, because a bus of 1 Mbit/s has time for only few writes per millisecond
        }
    }
    /// Makes each of the three conditions of each function compare the source with itself.
    void run_all_logic_blocks() {
        for (int block = 1; block <= 3; ++block) {
            for (int condition = 0; condition < 9; ++condition) {
                const auto at = static_cast<std::uint16_t>(0x3300 + (0x100 * block) + (0x10 * (1 + (condition / 3))) +
                                                           1 + (condition % 3));
                connect(at, 1, at, 2);
                connect(at, 3, at, 4);
            }
            set8(0x3300, block, 1);
            pass(1);
        }
    }
    void run_all_math_blocks() {
        for (int block = 1; block <= 4; ++block) {
            const auto at = static_cast<std::uint16_t>(0x4000 + (0x100 * block));
            for (int input = 1; input <= 4; ++input) {
                connect(at, input, static_cast<std::uint16_t>(at + 1), input);
            }
            set8(0x4000, block, 1);
            pass(1);
        }
    }
    /// Makes all four RPDOs valid, each with a time-out of 50 ms.
    void watch_all_rpdos() {
        for (int number = 1; number < 4; ++number) {
            const auto parameter = static_cast<std::uint16_t>(0x1400 + number);
            set32(parameter, 1, 0x4000027F + (0x100 * number));
        }
        for (int number = 0; number < 4; ++number) {
            set16(static_cast<std::uint16_t>(0x1400 + number), 5, 50);
        }
        start();
    }
    void receive_all_rpdos() {
        send("27F#E803E80300");
        send("37F#000000000000");
        send("47F#000000003200");
        send("57F#0000");
        pass(2);
    }

    /// Makes every input of every block, with the control, enable and override inputs of the outputs, read the
    /// temperature.
    void read_the_temperature() {
        source = temperature_source;
        source_number = 0;
        run_all_tables();
        run_all_logic_blocks();
        run_all_math_blocks();
        for (const int output : {1, 2}) {
            no_ramps(output);
            connect(0x2340, output, 0x2341, output);
            connect(0x2350, output, 0x2351, output);
            connect(0x2360, output, 0x2361, output);
        }
    }
    /// Gives all inputs of math blocks the gain 0.77, and all points of all tables four decimal digits. Y is 1.2345 at
    /// the first point and grows by 0.1234 a point.
    void use_decimal_digits() {
        for (int block = 1; block <= 4; ++block) {
            const auto at = static_cast<std::uint16_t>(0x4000 + (0x100 * block));
            for (int input = 1; input <= 4; ++input) {
                set8(static_cast<std::uint16_t>(at + 0x40), input, 77);
            }
            pass(1);
        }
        for (int table = 1; table <= 10; ++table) {
            set8(table_object(table, 3), 0, 4);
            set8(table_object(table, 4), 0, 4);
            for (int point = 1; point <= 11; ++point) {
                set16(table_object(table, 7), point, 12345 + (1234 * (point - 1)));
            }
            pass(1);
        }
    }

    int source{canopen};
    int source_number{9};  ///< number 9 of the CANopen messages is 2500h:6 (EC Extra Received Process Value)
};

TEST_F(Ax130751CycleLoad, AllInputsAreInErrorWhileAllRpdosAreOverdue) {
    verifies<req::AOR_SRC_004>();
    extra_as_percent(6);
    run_all_tables();
    run_all_logic_blocks();
    run_all_math_blocks();
    for (const int output : {1, 2}) {
        no_ramps(output);
        set16(0x7341, output, 3000);
    }
    watch_all_rpdos();
    receive_all_rpdos();
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
    EXPECT_EQ(get8(0x3310, 1), 1) << "2500h:6 equals itself: table A";
    pass(60);
    EXPECT_FLOAT_EQ(volts(1), 3.0F) << "output 1 has its fault value";
    EXPECT_FLOAT_EQ(volts(2), 3.0F);
    EXPECT_EQ(get8(0x3310, 1), 3) << "table C, whose operator is true without a condition";
    receive_all_rpdos();
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
    EXPECT_EQ(get8(0x3310, 1), 1);
}

TEST_F(Ax130751CycleLoad, InputsFromObjectsThatNoOverdueRpdoMapsStayValid) {
    verifies<req::AOR_SRC_004>();
    set8(0x1602, 0, 0);
    set8(0x1602, 0, 2);  // RPDO3 maps 2500h:4 and 2500h:5 (EC Extra Received Process Value), not 2500h:6
    extra_as_percent(6);
    run_all_tables();
    run_all_logic_blocks();
    run_all_math_blocks();
    watch_all_rpdos();
    extra(6, 50);
    receive_all_rpdos();
    pass(60);
    EXPECT_EQ(read(0x1003, 1), 0x00008100U) << "an RPDO is overdue";
    EXPECT_EQ(get8(0x3310, 1), 1) << "2500h:6 equals itself: table A";
}

TEST_F(Ax130751CycleLoad, AllBlocksRunInTheFirstCycleAfterPowerOn) {
    verifies<req::AOR_OUT_001>();
    extra_as_percent(6);
    run_all_tables();
    run_all_logic_blocks();
    run_all_math_blocks();
    store();
    power_on();
    pass(1);
    EXPECT_EQ(get8(0x3310, 1), 1) << "0 equals itself: table A";
    EXPECT_EQ(get8(0x3310, 3), 7);
}

TEST_F(Ax130751CycleLoad, AllInputsReadTheTemperature) {
    verifies<req::AOR_SRC_008>();
    read_the_temperature();
    start();
    for (int step = 0; step < 10; ++step) {
        inputs.cpu_temperature = 45.3F + static_cast<float>(step);
        set_inputs();
        pass(1);
    }
    EXPECT_EQ(get8(0x3310, 1), 1) << "the temperature equals itself: table A";
    EXPECT_EQ(get8(0x3310, 3), 7);
}

TEST_F(Ax130751CycleLoad, FirstCycleReadsAllPointsOfAllTables) {
    verifies<req::AOR_OUT_001, req::AOR_SRC_008>();
    read_the_temperature();
    use_decimal_digits();
    set8(0x5555, 0, 1);  // 5555h (start in operational mode)
    store();
    inputs.cpu_temperature = 45.3F;
    power_on();
    pass(1);
    EXPECT_EQ(get16(0x3018, 0), 24685) << "above the last X, 0.01: 1.2345 + 10 x 0.1234";
    EXPECT_EQ(get16(0x3108, 0), 24685) << "table 10";
    EXPECT_EQ(get8(0x3310, 1), 1) << "the temperature equals itself: table A";
}

TEST_F(Ax130751CycleLoad, WriteOfALimitOfTheSourceChecksTheFirstPointOfAllTables) {
    verifies<req::AOR_LT_018>();
    read_the_temperature();
    start();
    pass(3);
    set8(0x5032, 0, 99);  // 5032h (Over Temperature Threshold)
    EXPECT_EQ(static_cast<std::int32_t>(read(0x3016, 1)), 0) << "the minimum of the source is not below 0";
}

}  // namespace canproof::test
