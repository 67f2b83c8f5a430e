// SPDX-License-Identifier: Apache-2.0
// Fault detections FD1 to FD3 of the AX188001: temperature of the processor, high and low supply voltage (manual, 1.4,
// 3.4.19 to 3.4.21).
#include "generated/ax188001/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Ax188001FaultDetection = TcsTest;

}  // namespace

TEST_F(Ax188001FaultDetection, TemperatureAndSupplyFieldValuesAreInTenthsOfADegreeAndOfAVolt) {
    verifies<req::TCS_FD_001, req::TCS_OD_5040, req::TCS_K_FD_RESOLUTION, req::TCS_S_CPU_TEMPERATURE,
             req::TCS_S_SUPPLY>();
    EXPECT_EQ(read(0x5040, 1).real(), 350.0F);
    EXPECT_EQ(read(0x5040, 2).real(), 240.0F);
    inputs.cpu_temperature = -12.34F;
    inputs.supply = 13.16F;
    set_inputs();
    EXPECT_EQ(read(0x5040, 2).real(), 240.0F);
    read_once();
    EXPECT_EQ(read(0x5040, 1).real(), -123.0F);
    EXPECT_EQ(read(0x5040, 2).real(), 132.0F);
    inputs.supply = 60.0F;
    set_inputs();
    read_once();
    EXPECT_EQ(read(0x5040, 2).real(), 600.0F);
}

TEST_F(Ax188001FaultDetection, FaultsBeginBeyondTheirSetThresholdAndClearAtTheirClearThreshold) {
    verifies<req::TCS_FD_002, req::TCS_FD_008, req::TCS_FD_009, req::TCS_FD_003, req::TCS_FD_010, req::TCS_FD_011,
             req::TCS_FD_012, req::TCS_OD_5041, req::TCS_OD_5042>();
    write(0x5051, 1, 2, 0);
    write(0x5051, 2, 2, 0);
    const auto with = [&](float cpu, float supply) {
        inputs.cpu_temperature = cpu;
        inputs.supply = supply;
        set_inputs();
        return read_once();
    };
    EXPECT_EQ(with(110.0F, 24.0F).size(), 0U);
    EXPECT_EQ(with(110.1F, 24.0F), (Frames{"165:0FF#0042010110000000"}));
    EXPECT_EQ(with(85.1F, 24.0F).size(), 0U);
    EXPECT_EQ(with(85.0F, 24.0F), (Frames{"165:0FF#0000000000000000"}));
    EXPECT_EQ(with(85.0F, 50.0F).size(), 0U);
    EXPECT_EQ(with(85.0F, 50.1F), (Frames{"165:0FF#0031010210000000"}));
    EXPECT_EQ(with(85.0F, 48.1F).size(), 0U);
    EXPECT_EQ(with(85.0F, 48.0F), (Frames{"165:0FF#0000000000000000"}));
    EXPECT_EQ(with(85.0F, 9.0F).size(), 0U);
    EXPECT_EQ(with(85.0F, 8.9F), (Frames{"165:0FF#0031010320000000"}));
    EXPECT_EQ(with(85.0F, 11.9F).size(), 0U);
    EXPECT_EQ(with(85.0F, 12.0F), (Frames{"165:0FF#0000000000000000"}));
}

/// 5040h (FD Field Value) is in tenths: 110.04 degrees are measured as 110.0, and 110.06 degrees as 110.1.
TEST_F(Ax188001FaultDetection, ThresholdsAreComparedWithTheRoundedMeasurement) {
    verifies<req::TCS_FD_001, req::TCS_FD_002, req::TCS_FD_008, req::TCS_FD_009>();
    write(0x5051, 1, 2, 0);
    write(0x5051, 2, 2, 0);
    const auto with = [&](float cpu, float supply) {
        inputs.cpu_temperature = cpu;
        inputs.supply = supply;
        set_inputs();
        return read_once();
    };
    EXPECT_EQ(with(110.04F, 24.0F), Frames{});
    EXPECT_EQ(with(110.06F, 24.0F), (Frames{"165:0FF#0042010110000000"}));
    EXPECT_EQ(with(85.06F, 24.0F), Frames{});
    EXPECT_EQ(with(85.04F, 24.0F), (Frames{"165:0FF#0000000000000000"}));
    EXPECT_EQ(with(85.0F, 50.04F), Frames{});
    EXPECT_EQ(with(85.0F, 50.06F), (Frames{"165:0FF#0031010210000000"}));
    EXPECT_EQ(with(85.0F, 48.06F), Frames{});
    EXPECT_EQ(with(85.0F, 48.04F), (Frames{"165:0FF#0000000000000000"}));
    EXPECT_EQ(with(85.0F, 8.96F), Frames{});
    EXPECT_EQ(with(85.0F, 8.94F), (Frames{"165:0FF#0031010320000000"}));
    EXPECT_EQ(with(85.0F, 11.94F), Frames{});
    EXPECT_EQ(with(85.0F, 11.96F), (Frames{"165:0FF#0000000000000000"}));
}

TEST_F(Ax188001FaultDetection, UnderVoltageBeginsBelow9VoltsAsShipped) {
    verifies<req::TCS_FD_007>();
    inputs.supply = 9.0F;
    set_inputs();
    EXPECT_EQ(pass(7000), Frames{});
    inputs.supply = 8.9F;  // 0.1 V below the set threshold of 9.0 V
    set_inputs();
    const Frames told = pass(7000);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].substr(told[0].find(':') + 1), "0FF#0031010320000000");
}

TEST_F(Ax188001FaultDetection, UnderVoltageClearsAt12VoltsAsShipped) {
    verifies<req::TCS_FD_007, req::TCS_FD_004>();
    inputs.supply = 12.0F;
    set_inputs();
    EXPECT_EQ(pass(1000), Frames{});
    inputs.supply = 8.5F;
    set_inputs();  // the supply changes at 1000 ms and is read at 1155 ms
    EXPECT_EQ(pass(6000), (Frames{"5155:0FF#0031010320000000"}));
    inputs.supply = 11.9F;
    set_inputs();
    EXPECT_EQ(pass(1000), Frames{});
    inputs.supply = 12.0F;
    set_inputs();
    EXPECT_EQ(pass(1000).size(), 1U);
}

TEST_F(Ax188001FaultDetection, TemperatureAndSupplyFaultsHaveTheirOwnDelays) {
    verifies<req::TCS_FD_004, req::TCS_OD_5051>();
    EXPECT_EQ(read(0x5051, 1).value, 5000U);
    EXPECT_EQ(read(0x5051, 2).value, 5000U);
    EXPECT_EQ(write(0x5051, 1, 2, 10001), too_high);
    EXPECT_EQ(write(0x5051, 1, 2, 10000), 0U);
    EXPECT_EQ(write(0x5051, 2, 2, 1000), 0U);
    inputs.cpu_temperature = 120.0F;
    inputs.supply = 55.0F;
    set_inputs();
    EXPECT_EQ(pass(12000), (Frames{"1165:0FF#0031010210000000", "10165:0FF#0042010110000000"}));
}

TEST_F(Ax188001FaultDetection, UnderVoltageIsReportedAfterTheSupplyFaultDelay) {
    verifies<req::TCS_FD_004>();
    EXPECT_EQ(write(0x5051, 1, 2, 10000), 0U);
    EXPECT_EQ(write(0x5051, 2, 2, 1000), 0U);
    inputs.supply = 8.5F;
    set_inputs();  // the inputs change at 0 ms and are read at 165 ms
    EXPECT_EQ(pass(12000), (Frames{"1165:0FF#0031010320000000"}));
}

TEST_F(Ax188001FaultDetection, FaultsThatEndDuringTheirDelayAreNotReported) {
    verifies<req::TCS_FD_004, req::TCS_FD_012, req::TCS_FD_016>();
    // Section 3.4.18: the set thresholds are 110 degrees, 50 V and 9 V. The second value of each row is at the set
    // threshold, or between it and the clear threshold of 85 degrees, 48 V or 12 V.
    struct Row {
        float ax188001::Inputs::*input;
        float fault;
        float ended;
    };
    for (const Row& row : {Row{&ax188001::Inputs::cpu_temperature, 120.0F, 110.0F},
                           {&ax188001::Inputs::cpu_temperature, 120.0F, 100.0F},
                           {&ax188001::Inputs::supply, 55.0F, 50.0F},
                           {&ax188001::Inputs::supply, 55.0F, 49.0F},
                           {&ax188001::Inputs::supply, 8.5F, 9.0F},
                           {&ax188001::Inputs::supply, 8.5F, 11.0F}}) {
        inputs.*row.input = row.fault;
        set_inputs();
        EXPECT_EQ(pass(4000), Frames{}) << row.fault;
        inputs.*row.input = row.ended;
        set_inputs();
        EXPECT_EQ(pass(10000), Frames{}) << row.fault << ", then " << row.ended;
    }
}

TEST_F(Ax188001FaultDetection, FaultDetectionCanBeSwitchedOff) {
    verifies<req::TCS_FD_005, req::TCS_FD_013, req::TCS_FD_014, req::TCS_FD_015, req::TCS_OD_5050>();
    EXPECT_EQ(read(0x5050, 1).value, 1U);
    EXPECT_EQ(write(0x5050, 1, 1, 2), too_high);
    write(0x5051, 1, 2, 0);
    write(0x5051, 2, 2, 0);
    inputs.cpu_temperature = 120.0F;
    inputs.supply = 8.0F;
    set_inputs();
    EXPECT_EQ(read_once(), (Frames{"165:0FF#0042010110000000", "165:0FF#0031010320000000"}));
    EXPECT_EQ(send("67F#2F50500100000000"), (Frames{"0FF#0000010000000000", "5FF#6050500100000000"}));
    EXPECT_EQ(send("67F#2F50500200000000"), (Frames{"0FF#0000000000000000", "5FF#6050500200000000"}));
    inputs.supply = 60.0F;
    set_inputs();
    EXPECT_EQ(pass(1000), Frames{});
    EXPECT_EQ(read(0x5040, 2).real(), 600.0F);
    write(0x5050, 2, 1, 1);
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x10023100}));
}

TEST_F(Ax188001FaultDetection, ThresholdsToSetAndToClearAFaultLimitEachOther) {
    verifies<req::TCS_FD_006, req::TCS_OD_5041, req::TCS_OD_5042, req::CO_SDO_062>();
    EXPECT_EQ(read(0x5041, 0).value, 3U);
    const std::vector<std::uint32_t> set{1100, 500, 90};
    const std::vector<std::uint32_t> clear{850, 480, 120};
    for (int sub = 1; sub <= 3; ++sub) {
        EXPECT_EQ(read(0x5041, sub).value, set[static_cast<std::size_t>(sub - 1)]);
        EXPECT_EQ(read(0x5041, sub).size, 2);
        EXPECT_EQ(read(0x5042, sub).value, clear[static_cast<std::size_t>(sub - 1)]);
    }
    EXPECT_EQ(write(0x5041, 1, 2, 849), too_low);
    EXPECT_EQ(write(0x5041, 1, 2, 1251), too_high);
    EXPECT_EQ(write(0x5041, 1, 2, 1250), 0U);
    EXPECT_EQ(write(0x5042, 1, 2, 499), too_low);
    EXPECT_EQ(write(0x5042, 1, 2, 1251), too_high);
    EXPECT_EQ(write(0x5042, 1, 2, 500), 0U);
    EXPECT_EQ(write(0x5041, 2, 2, 479), too_low);
    EXPECT_EQ(write(0x5041, 2, 2, 1001), too_high);
    EXPECT_EQ(write(0x5041, 2, 2, 1000), 0U);
    EXPECT_EQ(write(0x5042, 2, 2, 119), too_low);  // 5042h:3
    EXPECT_EQ(write(0x5042, 2, 2, 1001), too_high);
    EXPECT_EQ(write(0x5042, 2, 2, 120), 0U);
    EXPECT_EQ(write(0x5042, 3, 2, 121), too_high);  // 5042h:2 (FD Clear Threshold) is 120 now
    EXPECT_EQ(write(0x5042, 3, 2, 89), too_low);
    EXPECT_EQ(write(0x5042, 3, 2, 90), 0U);
    EXPECT_EQ(write(0x5041, 3, 2, 79), too_low);
    EXPECT_EQ(write(0x5041, 3, 2, 91), too_high);
    EXPECT_EQ(write(0x5041, 3, 2, 80), 0U);
}

}  // namespace canproof::test
