// Control sources of the AX130751 (manual 1.3, Tables 4A, 4B and 5), seen through blocks of the device. A lookup table
// as shipped hands on its X from 0 to 100 as it is, in whole numbers.
#include "support/ax130751_bench.hpp"
#include "support/verifies.hpp"

namespace canproof::test {

namespace {

using Frames = Ax130751Bench::Frames;

class Ax130751Sources : public Ax130751Test {
  protected:
    /// What lookup table 1 shows with this source and number.
    std::int16_t seen(int source, int number) {
        EXPECT_EQ(write(0x3010, 0, source, 1), "");
        EXPECT_EQ(write(0x3011, 0, number, 1), "");
        pass(20);
        return static_cast<std::int16_t>(read(0x3018, 0));
    }
    /// Extra received value `number`, in tenths.
    void receive_extra(int number, int tenths) { EXPECT_EQ(write(0x2500, number, tenths, 2), ""); }
    void use_extra(std::uint16_t source_index, int sub, int number) {
        EXPECT_EQ(write(source_index, sub, 1, 1), "");
        EXPECT_EQ(write(static_cast<std::uint16_t>(source_index + 1), sub, number + 3, 1), "");
    }
    double volts(int output) const { return device->outputs().out_voltage[static_cast<std::size_t>(output - 1)]; }
    bool relay_is_on() const { return device->outputs().relay_nc; }
};

}  // namespace

// Table 4B, row by row
TEST_F(Ax130751Sources, CanOpenMessages) {
    verifies<req::AOR_SRC_001, req::AOR_T4A, req::AOR_T4B, req::AOR_OD_2500>();
    EXPECT_EQ(write(0x7300, 1, 21000, 2), "");  // 21.000 with the three digits of 6302h
    EXPECT_EQ(write(0x7300, 2, 22000, 2), "");
    EXPECT_EQ(write(0x6220, 3, 1, 1), "");
    for (int number = 1; number <= 6; ++number) {
        receive_extra(number, 300 + 10 * number);  // 31.0 to 36.0
    }
    EXPECT_EQ(seen(1, 1), 21);
    EXPECT_EQ(seen(1, 2), 22);
    EXPECT_EQ(seen(1, 3), 1);
    for (int number = 4; number <= 9; ++number) {
        EXPECT_EQ(seen(1, number), 27 + number);
    }
}

TEST_F(Ax130751Sources, OtherBlocks) {
    verifies<req::AOR_SRC_001, req::AOR_SRC_009, req::AOR_T4A, req::AOR_T4B>();
    EXPECT_EQ(write(0x6220, 3, 1, 1), "");
    EXPECT_EQ(seen(2, 1), 1);
    // lookup tables 2 to 10, each of an extra value
    for (int table = 2; table <= 10; ++table) {
        const auto source = static_cast<std::uint16_t>(table < 10 ? 0x3000 + 0x10 * table : 0x3100);
        receive_extra(1, 500 + 10 * table);
        use_extra(source, 0, 1);
        EXPECT_EQ(seen(3, table), 50 + table);
        EXPECT_EQ(write(source, 0, 0, 1), "");
    }
    // math blocks 1 to 4, their first input an extra value of 0.00 to 100.00
    for (int block = 1; block <= 4; ++block) {
        EXPECT_EQ(write(0x4000, block, 1, 1), "");
        use_extra(static_cast<std::uint16_t>(0x4000 + 0x100 * block), 1, block);
        use_extra(static_cast<std::uint16_t>(0x4000 + 0x100 * block), 2, 6);
        receive_extra(block, 600 + 10 * block);
        receive_extra(6, 0);  // plus nothing
        EXPECT_EQ(seen(4, block), 60 + block);
    }
    // logic blocks 1 to 3 select their table A, 2, 4 and 7, since none of their conditions is used
    const std::vector<int> tables{2, 4, 7};
    EXPECT_EQ(write(0x3401, 1, 2, 1), "");
    for (int block = 1; block <= 3; ++block) {
        EXPECT_EQ(write(0x3300, block, 1, 1), "");
        use_extra(static_cast<std::uint16_t>(0x3000 + 0x10 * tables[static_cast<std::size_t>(block - 1)]), 0, block);
        receive_extra(block, 700 + 10 * block);
        EXPECT_EQ(seen(5, block), 70 + block);
    }
}

TEST_F(Ax130751Sources, OutputsSupplyAndTemperature) {
    verifies<req::AOR_SRC_001, req::AOR_T4A, req::AOR_T4B, req::AOR_OD_7330, req::AOR_OD_2370>();
    EXPECT_EQ(write(0x2330, 1, 10000, 2), "");  // the feedback of output 1 climbs 5 V in 10 s
    EXPECT_EQ(write(0x2330, 2, 0, 2), "");
    EXPECT_EQ(write(0x7300, 1, 3000, 2), "");
    EXPECT_EQ(write(0x7300, 2, 4000, 2), "");
    EXPECT_EQ(seen(6, 1), 3);
    EXPECT_EQ(seen(6, 2), 4);
    EXPECT_EQ(seen(7, 1), 0);
    EXPECT_EQ(seen(7, 2), 4);
    inputs.supply = 24.0F;
    inputs.cpu_temperature = 35.0F;
    set_inputs();
    for (const int number : {0, 1, 7}) {  // N/A: any
        EXPECT_EQ(seen(8, number), 24);
        EXPECT_EQ(seen(9, number), 35);
    }
}

TEST_F(Ax130751Sources, APairWithoutARowIsNotUsed) {
    verifies<req::AOR_SRC_001, req::AOR_T4B, req::AOR_LT_015>();
    EXPECT_EQ(write(0x7300, 1, 21000, 2), "");
    for (int number = 1; number <= 6; ++number) {
        receive_extra(number, 300);
    }
    const std::vector<std::pair<int, int>> pairs{{0, 1}, {1, 0}, {1, 10}, {2, 0}, {2, 2}, {3, 0}, {4, 0},
                                                 {4, 5}, {5, 0}, {5, 4},  {6, 0}, {6, 3}, {7, 0}, {7, 3}};
    for (const auto& [source, number] : pairs) {
        EXPECT_EQ(seen(source, number), 0) << source << ", " << number;
    }
    // an output without a control is off
    EXPECT_EQ(write(0x2331, 1, 0, 2), "");
    EXPECT_EQ(write(0x7300, 1, 3000, 2), "");
    EXPECT_EQ(write(0x2330, 1, 0, 2), "");
    pass(20);
    EXPECT_NEAR(volts(1), 3.0, 0.001);
    EXPECT_EQ(write(0x2341, 1, 0, 1), "");
    pass(20);
    EXPECT_NEAR(volts(1), 0.0, 0.001);
}

TEST_F(Ax130751Sources, MessagesOneAndTwoAreTheWriteStatesOfDigitalOutputs) {
    verifies<req::AOR_SRC_002, req::AOR_DO_001, req::AOR_OD_6220, req::AOR_OD_7300>();
    EXPECT_EQ(write(0x6310, 1, 1020, 2), "");
    EXPECT_EQ(write(0x6220, 1, 1, 1), "");
    EXPECT_EQ(write(0x7300, 1, 0, 2), "");
    EXPECT_EQ(write(0x6220, 2, 1, 1), "");
    EXPECT_EQ(write(0x7300, 2, 23000, 2), "");
    EXPECT_EQ(seen(1, 1), 1);
    EXPECT_TRUE(device->outputs().out_on[0]);
    EXPECT_EQ(seen(1, 2), 23);  // output 2 is a voltage
    EXPECT_EQ(write(0x6310, 1, 1000, 2), "");
    EXPECT_EQ(seen(1, 1), 1);
    EXPECT_EQ(write(0x6220, 1, 0, 1), "");
    EXPECT_EQ(seen(1, 1), 0);
    EXPECT_FALSE(device->outputs().out_on[0]);
}

TEST_F(Ax130751Sources, TheRelaysCommandIsNeverWrittenByTheDevice) {
    verifies<req::AOR_SRC_003, req::AOR_OD_6220>();
    EXPECT_EQ(write(0x2242, 1, 2, 1), "");  // inverse: the relay's state is not its command
    EXPECT_EQ(write(0x6220, 3, 1, 1), "");
    pass(50);
    EXPECT_FALSE(relay_is_on());
    EXPECT_EQ(read(0x6220, 3), 1U);
    EXPECT_EQ(write(0x2260, 1, 2, 1), "");  // the relay command instead of message 3: the same object
    EXPECT_EQ(write(0x2261, 1, 1, 1), "");
    pass(50);
    EXPECT_FALSE(relay_is_on());
    EXPECT_EQ(write(0x6220, 3, 0, 1), "");
    pass(50);
    EXPECT_TRUE(relay_is_on());
    EXPECT_EQ(read(0x6220, 3), 0U);
}

TEST_F(Ax130751Sources, AMessageIsInErrorFromTheTimeOutOfItsRpdo) {
    verifies<req::AOR_SRC_004, req::AOR_OD_7341>();
    for (int output = 1; output <= 2; ++output) {
        EXPECT_EQ(write(0x2330, output, 0, 2), "");
        EXPECT_EQ(write(0x7341, output, 1234, 2), "");
    }
    use_extra(0x2340, 2, 1);  // output 2 listens to an extra value, which no RPDO carries
    EXPECT_EQ(write(0x1800, 5, 0, 2), "");
    EXPECT_EQ(write(0x1400, 5, 100, 2), "");
    start();
    send("27F#B80B000000");  // 3000
    pass(90);
    EXPECT_NEAR(volts(1), 3.0, 0.001);
    pass(30);
    EXPECT_NEAR(volts(1), 1.234, 0.001);
    EXPECT_NEAR(volts(2), 0.0, 0.001);
    send("27F#B80B000000");
    pass(10);
    EXPECT_NEAR(volts(1), 3.0, 0.001);
}

TEST_F(Ax130751Sources, EveryMessageIsInErrorWhileAHeartbeatIsLost) {
    verifies<req::AOR_SRC_005>();
    for (int output = 1; output <= 2; ++output) {
        EXPECT_EQ(write(0x2331, output, 0, 2), "");
        EXPECT_EQ(write(0x2330, output, 0, 2), "");
        EXPECT_EQ(write(0x7341, output, 1000 + output, 2), "");
    }
    use_extra(0x2340, 2, 1);
    EXPECT_EQ(write(0x1016, 1, 0x00200064, 4), "");
    send("720#05");
    pass(90);
    EXPECT_NEAR(volts(1), 0.0, 0.001);
    pass(30);
    EXPECT_NEAR(volts(1), 1.001, 0.0001);
    EXPECT_NEAR(volts(2), 1.002, 0.0001);
    send("720#05");
    pass(20);
    EXPECT_NEAR(volts(1), 0.0, 0.001);
    EXPECT_NEAR(volts(2), 0.0, 0.001);
}

TEST_F(Ax130751Sources, AMessageThatNeverCameIsZeroAndValid) {
    verifies<req::AOR_SRC_006>();
    EXPECT_EQ(write(0x7341, 1, 1234, 2), "");  // would show if it were in error
    EXPECT_EQ(write(0x1400, 5, 100, 2), "");
    start();
    pass(1000);
    EXPECT_NEAR(volts(1), 0.0, 0.0001);
    EXPECT_EQ(read(0x7300, 1), 0U);
    EXPECT_EQ(read(0x1003, 0), 0U);
}

// Table 5: a digital input turns on at the upper limit of its source and off at the lower one
TEST_F(Ax130751Sources, DigitalInputsSeeTheLimitsOfTable5) {
    verifies<req::AOR_SRC_007, req::AOR_T05, req::AOR_OD_2520, req::AOR_OD_2522>();
    EXPECT_EQ(write(0x2522, 1, 200, 2), "");  // 10.0 to 20.0
    EXPECT_EQ(write(0x2520, 1, 100, 2), "");
    use_extra(0x2260, 1, 1);
    const std::vector<std::pair<int, bool>> steps{{100, false}, {199, false}, {200, true},
                                                  {101, true},  {100, false}, {150, false}};
    for (const auto& [tenths, on] : steps) {
        receive_extra(1, tenths);
        pass(20);
        EXPECT_EQ(relay_is_on(), on) << tenths;
    }
    // the field value of output 1 runs from 5 V down to 0 V: its lower limit is 0 V, whichever object has it
    EXPECT_EQ(write(0x7321, 1, 5000, 2), "");
    EXPECT_EQ(write(0x7323, 1, 0, 2), "");
    EXPECT_EQ(write(0x2342, 1, 0, 1), "");
    EXPECT_EQ(write(0x2260, 1, 6, 1), "");
    EXPECT_EQ(write(0x2261, 1, 1, 1), "");
    const std::vector<std::pair<int, bool>> values{
        {5000, false}, {1000, false}, {0, true}, {4000, true}, {5000, false}};
    for (const auto& [millivolts, on] : values) {
        EXPECT_EQ(write(0x7300, 1, millivolts, 2), "");
        pass(20);
        EXPECT_EQ(relay_is_on(), on) << millivolts;
    }
}

TEST_F(Ax130751Sources, SupplyAndTemperatureCountInTenthsAndStayValidInAFault) {
    verifies<req::AOR_SRC_008, req::AOR_OD_5020, req::AOR_OD_5030>();
    EXPECT_EQ(write(0x4000, 1, 1, 1), "");
    EXPECT_EQ(write(0x4100, 1, 8, 1), "");
    use_extra(0x4100, 2, 6);  // plus nothing
    inputs.supply = 24.07F;
    inputs.cpu_temperature = 35.04F;
    set_inputs();
    pass(20);
    EXPECT_EQ(read(0x4030, 1), 2410U);
    inputs.supply = 7.5F;  // a fault, not an error of the source
    set_inputs();
    pass(20);
    EXPECT_EQ(read(0x4030, 1), 750U);
    EXPECT_EQ(write(0x4100, 1, 9, 1), "");
    pass(20);
    EXPECT_EQ(read(0x4030, 1), 3500U);
    inputs.cpu_temperature = 90.0F;
    set_inputs();
    pass(20);
    EXPECT_EQ(read(0x4030, 1), 9000U);
}

TEST_F(Ax130751Sources, ABlockHandsOnWhatItsObjectShows) {
    verifies<req::AOR_SRC_009>();
    EXPECT_EQ(write(0x7300, 1, 32767, 2), "");  // 32.767
    EXPECT_EQ(write(0x3020, 0, 1, 1), "");
    EXPECT_EQ(write(0x3021, 0, 1, 1), "");
    EXPECT_EQ(write(0x4000, 1, 1, 1), "");
    EXPECT_EQ(write(0x4100, 1, 3, 1), "");
    EXPECT_EQ(write(0x4101, 1, 2, 1), "");
    use_extra(0x4100, 2, 6);
    pass(20);
    EXPECT_EQ(read(0x3028, 0), 33U);    // whole numbers
    EXPECT_EQ(read(0x4030, 1), 3300U);  // 33.00, not 32.77
}

}  // namespace canproof::test
