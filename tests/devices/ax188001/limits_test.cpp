// SPDX-License-Identifier: Apache-2.0
// Tests the limits of the channels, and their status and delays (AX188001 manual, 1.1, 3.3.6, 3.4.13 to 3.4.18).
#include "generated/ax188001/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Ax188001Limits = TcsTest;

}  // namespace

// One step of the converter is 0.012 degC here, so the test uses values one step below and above each threshold.
TEST_F(Ax188001Limits, ThresholdsAreInTenthsOfADegree) {
    verifies<req::TCS_LIM_001, req::TCS_LIM_015, req::TCS_K_LIMIT_RESOLUTION, req::TCS_OD_4000, req::TCS_OD_4010,
             req::TCS_OD_4020, req::TCS_OD_4030, req::TCS_LIM_016, req::TCS_LIM_017>();
    write(0x4030, 1, 2, 0);
    const auto status_at = [&](double celsius) {
        heat(1, celsius);
        settle();
        return status(1);
    };
    EXPECT_EQ(status_at(124.988), 0);  // 4010h (TC High Temperature Warning Threshold) is 125.0
    EXPECT_EQ(status_at(125.012), 0x02);
    EXPECT_EQ(status_at(249.988), 0x02);  // 4020h (TC High Temperature Shutdown Threshold) is 250.0
    EXPECT_EQ(status_at(250.012), 0x03);
    EXPECT_EQ(status_at(20.0), 0);
    EXPECT_EQ(status_at(-19.988), 0);  // 4000h (TC Low Temperature Warning Threshold) is -20.0
    EXPECT_EQ(status_at(-20.012), 0x04);
}

TEST_F(Ax188001Limits, LimitFaultsClearOneDegreeInsideTheLimit) {
    verifies<req::TCS_LIM_002, req::TCS_K_HYSTERESIS, req::TCS_LIM_004>();
    write(0x4030, 1, 2, 0);
    const auto status_at = [&](double celsius) {
        heat(1, celsius);
        read_once();
        return status(1);
    };
    EXPECT_EQ(status_at(126.0), 0x02);
    EXPECT_EQ(status_at(124.012), 0x02);
    EXPECT_EQ(status_at(123.988), 0x00);
    EXPECT_EQ(status_at(251.0), 0x03);
    EXPECT_EQ(status_at(249.012), 0x03);
    EXPECT_EQ(status_at(248.988), 0x02);  // the warning is still active
    EXPECT_EQ(status_at(20.0), 0x00);
    EXPECT_EQ(status_at(-21.0), 0x04);
    EXPECT_EQ(status_at(-19.012), 0x04);
    EXPECT_EQ(status_at(-18.988), 0x00);
}

TEST_F(Ax188001Limits, ResetNodeClearsLimitFaults) {
    verifies<req::TCS_LIM_002, req::CO_NMT_005>();
    write(0x4030, 1, 2, 0);
    heat(1, 126.0);
    read_once();
    heat(1, 124.5);
    read_once();
    EXPECT_EQ(status(1), 0x02);  // within the hysteresis of 1 degC below the limit of 125.0
    EXPECT_EQ(send("000#817F"), (Frames{"77F#00"}));
    EXPECT_EQ(status(1), 0x00);  // the temperature was not above 125.0 since the reset
}

TEST_F(Ax188001Limits, LimitFaultsAreReportedAfterTheirDelay) {
    verifies<req::TCS_LIM_003, req::TCS_OD_4030, req::TCS_OD_6150>();
    EXPECT_EQ(read(0x4030, 1).value, 5000U);
    heat(1, 130.0);
    // The reading at 165 ms shows the limit fault, which is reported 5000 ms later.
    EXPECT_EQ(pass(5164), Frames{});
    EXPECT_EQ(status(1), 0);
    EXPECT_EQ(pass(1), (Frames{"1:0FF#11F0010110000000"}));
    EXPECT_EQ(status(1), 0x02);
}

TEST_F(Ax188001Limits, ReadingInsideTheLimitRestartsTheDelayOfALimitFault) {
    verifies<req::TCS_LIM_003, req::TCS_LIM_012>();
    heat(1, 130.0);
    pass(3000);  // the reading at 165 ms was the first above the limit
    heat(1, 124.9);
    pass(1000);
    heat(1, 130.0);  // applied at 4000 ms, read at 4125 ms
    EXPECT_EQ(pass(5124), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:0FF#11F0010110000000"}));
}

TEST_F(Ax188001Limits, LimitFaultClearsWithTheFirstReadingInsideTheLimit) {
    verifies<req::TCS_LIM_004>();
    heat(1, 130.0);
    pass(5165);  // it is 5165 ms now, between the readings at 5115 and 5280 ms
    ASSERT_EQ(status(1), 0x02);
    heat(1, 20.0);
    EXPECT_EQ(pass(200), (Frames{"115:0FF#0000000000000000"}));
    EXPECT_EQ(status(1), 0x00);
}

TEST_F(Ax188001Limits, WarningAndShutdownLimitsHaveTheirOwnDelays) {
    verifies<req::TCS_LIM_009, req::TCS_LIM_019>();
    heat(1, 130.0);  // 130 degC (warning) is read at 165 ms
    pass(2000);
    heat(1, 260.0);  // 260 degC (shutdown) is read at 2145 ms
    EXPECT_EQ(pass(3000 + 2300), (Frames{"3165:0FF#11F0010110000000", "5145:0FF#11F0010140000000"}));
    EXPECT_EQ(status(1), 0x03);
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x4001F011, 0x1001F011}));
    heat(1, 200.0);
    read_once();
    EXPECT_EQ(status(1), 0x02);
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x1001F011}));
}

TEST_F(Ax188001Limits, OpenCircuitPrecedesLimitFaultsInTheStatus) {
    verifies<req::TCS_LIM_005, req::TCS_T7, req::TCS_LIM_007>();
    write(0x4030, 1, 2, 0);
    heat(1, 260.0);
    read_once();
    EXPECT_EQ(status(1), 0x03);
    cut(1);
    settle();
    EXPECT_EQ(status(1), 0x05);
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x0001F001, 0x4001F011, 0x1001F011}));
    cut(1, false);
    read_once();
    EXPECT_EQ(status(1), 0x03);
    heat(1, -30.0);
    settle();
    EXPECT_EQ(status(1), 0x04);
    cut(1);
    settle();
    EXPECT_EQ(status(1), 0x05);
}

TEST_F(Ax188001Limits, OpenCircuitDropsPendingLimitFaults) {
    verifies<req::TCS_LIM_018>();
    heat(1, 130.0);
    pass(4000);  // the delay of the limit fault runs since 165 ms
    cut(1);      // the cut at 4000 ms is read at 4125 ms and known as an open circuit at 4125 + 1320 = 5445 ms
    EXPECT_EQ(pass(1164), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:0FF#11F0010110000000"}));  // sent at 5165 ms, before the open circuit is detected
    cut(1, false);
    heat(1, 20.0);
    pass(2000);
    ASSERT_EQ(status(1), 0);
    heat(1, 130.0);
    pass(1000);
    cut(1);
    settle();
    EXPECT_EQ(process_value(1), -512);
    cut(1, false);
    // The delay of the warning restarts with the first reading after the open circuit.
    const Frames frames = pass(165 + 5000);
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].substr(frames[0].find(':')), ":0FF#11F0010110000000");
    EXPECT_GT(std::stoi(frames[0]), 5000);
}

TEST_F(Ax188001Limits, OpenCircuitIsReportedAfterItsDelay) {
    verifies<req::TCS_LIM_003, req::TCS_VAL_006, req::TCS_S_OPEN>();
    cut(2);
    // The voltage is read at 165 ms, the open circuit is detected at 165 + 1320 = 1485 ms and reported at 6485 ms.
    EXPECT_EQ(pass(6484), Frames{});
    EXPECT_EQ(process_value(2), -512);
    EXPECT_EQ(status(2), 0);
    EXPECT_EQ(pass(1), (Frames{"1:0FF#01F0010200000000"}));
    EXPECT_EQ(status(2), 0x05);
    cut(2, false);  // it is 6485 ms now; the next reading is at 6600 ms
    EXPECT_EQ(pass(165), (Frames{"115:0FF#0000000000000000"}));
    EXPECT_EQ(status(2), 0);
}

TEST_F(Ax188001Limits, DisablingAChannelClearsItsFaultsAtOnce) {
    verifies<req::TCS_LIM_006, req::TCS_LIM_013, req::TCS_VAL_005>();
    heat(1, 300.0);
    heat(2, 130.0);
    pass(5165);
    ASSERT_EQ(status(1), 0x03);
    EXPECT_EQ(send("67F#2F12610100000000"),
              (Frames{"0FF#0000010000000000", "0FF#0000010000000000", "5FF#6012610100000000"}));
    EXPECT_EQ(status(1), 0);
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x1002F011}));
    EXPECT_EQ(status(2), 0x02);
    write(0x6112, 1, 1, 1);  // the last reading is evaluated at once: the delays begin now, at 5165 ms
    EXPECT_EQ(pass(4999), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:0FF#11F0010110000000", "1:0FF#11F0010140000000"}));
}

TEST_F(Ax188001Limits, DisablingAChannelDropsPendingFaults) {
    verifies<req::TCS_LIM_020>();
    heat(1, 130.0);
    pass(3000);
    write(0x6112, 1, 1, 0);
    EXPECT_EQ(pass(5000), Frames{});
}

TEST_F(Ax188001Limits, NewLimitIsEvaluatedAtOnce) {
    verifies<req::TCS_LIM_010>();
    heat(1, 100.0);
    pass(1000);
    write(0x4030, 1, 2, 0);
    // 4010h:1 (TC High Temperature Warning Threshold) = 90.0 degC
    EXPECT_EQ(send("67F#2B10400184030000"), (Frames{"0FF#11F0010110000000", "5FF#6010400100000000"}));
    // 4010h:1 (TC High Temperature Warning Threshold) = 125.0 degC
    EXPECT_EQ(send("67F#2B104001E2040000"), (Frames{"0FF#0000000000000000", "5FF#6010400100000000"}));
}

TEST_F(Ax188001Limits, DelayWrittenDuringAFaultCountsFromTheStartOfTheFault) {
    verifies<req::TCS_LIM_014>();
    heat(1, 130.0);  // the voltage is read at 165 ms
    pass(1000);
    write(0x4030, 1, 2, 2000);
    EXPECT_EQ(pass(1164), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:0FF#11F0010110000000"}));  // at 2165 ms: 2000 ms after the reading at 165 ms
}

TEST_F(Ax188001Limits, LimitFaultDelayIsAtMostOneMinute) {
    verifies<req::TCS_LIM_011, req::TCS_OD_4030>();
    EXPECT_EQ(write(0x4030, 2, 2, 60001), too_high);
    EXPECT_EQ(write(0x4030, 2, 2, 60000), 0U);
    EXPECT_EQ(write(0x4030, 3, 2, 0), no_subindex);
    heat(2, 130.0);
    EXPECT_EQ(pass(60164), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:0FF#11F0010210000000"}));
}

TEST_F(Ax188001Limits, LimitThresholdsOfAChannelStayTenDegreesApart) {
    verifies<req::TCS_LIM_008, req::TCS_OD_4000, req::TCS_OD_4010, req::TCS_OD_4020>();
    const auto word = [](int value) { return static_cast<std::uint32_t>(value) & 0xFFFFU; };
    EXPECT_EQ(read(0x4000, 1).word(), -200);
    EXPECT_EQ(read(0x4010, 1).word(), 1250);
    EXPECT_EQ(read(0x4020, 1).word(), 2500);
    EXPECT_EQ(write(0x4000, 1, 2, word(-2731)), too_low);
    EXPECT_EQ(write(0x4000, 1, 2, word(-2730)), 0U);
    EXPECT_EQ(write(0x4000, 1, 2, word(1151)), too_high);  // at most 1250 - 100 = 1150
    EXPECT_EQ(write(0x4000, 1, 2, word(1150)), 0U);
    EXPECT_EQ(write(0x4010, 1, 2, word(1249)), too_low);  // at least 1150 + 100 = 1250
    EXPECT_EQ(write(0x4010, 1, 2, word(2401)), too_high);
    EXPECT_EQ(write(0x4010, 1, 2, word(2400)), 0U);
    EXPECT_EQ(write(0x4020, 1, 2, word(2499)), too_low);
    EXPECT_EQ(write(0x4020, 1, 2, word(17351)), too_high);
    EXPECT_EQ(write(0x4020, 1, 2, word(17350)), 0U);
    // the limits of channel 2 do not depend on those of channel 1
    EXPECT_EQ(write(0x4010, 2, 2, word(2401)), too_high);
    for (const int index : {0x4000, 0x4010, 0x4020}) {
        EXPECT_EQ(read(index, 0).value, 2U);
        EXPECT_EQ(write(index, 3, 2, 0), no_subindex);
    }
}

TEST_F(Ax188001Limits, VoltageBeyondTheRangeOfTheThermocoupleTypeIsAFault) {
    verifies<req::TCS_CONV_006, req::TCS_CONV_011, req::TCS_K_RANGE_MARGIN, req::TCS_T1, req::TCS_CONV_013>();
    write(0x2000, 1, 1, 0);
    write(0x4020, 1, 2, 17350);
    write(0x4010, 1, 2, 17000);
    write(0x4030, 1, 2, 0);
    const auto status_at = [&](double uv) {
        microvolts(1, uv);
        settle();
        return status(1);
    };
    write(0x6110, 1, 2, 7);  // T: -6258 to 20872 uV
    EXPECT_EQ(status_at(20880.0), 0);
    EXPECT_EQ(process_value(1), 400 * 16 + 4368);
    EXPECT_EQ(status_at(20884.0), 0x03);
    read_once();
    EXPECT_EQ(status(1), 0x03);  // the shutdown is still active, although 400 degC is far from the limit
    EXPECT_EQ(process_value(1), 400 * 16 + 4368);
    EXPECT_EQ(status_at(20000.0), 0);
    write(0x4000, 1, 2, static_cast<std::uint32_t>(-2730) & 0xFFFFU);
    EXPECT_EQ(status_at(-6266.0), 0);
    EXPECT_EQ(status_at(-6267.7), 0);     // step -10515: -6267.45, 9.45 uV beyond
    EXPECT_EQ(status_at(-6268.3), 0x04);  // step -10516: -6268.05, 10.05 uV beyond
    read_once();
    EXPECT_EQ(status(1), 0x04);
    EXPECT_EQ(process_value(1), -270 * 16 + 4368);
}

TEST_F(Ax188001Limits, InputRangesOfAllThermocoupleTypesFollowTheManual) {
    verifies<req::TCS_T1, req::TCS_CONV_011, req::TCS_CONV_013>();
    struct Range {
        std::uint32_t type;
        double lowest;
        double highest;
    };
    const std::vector<Range> ranges{{1, -8095, 69553}, {2, -6458, 54886}, {4, -4345, 47513}, {5, -226, 21101},
                                    {6, -236, 18693},  {7, -6258, 20872}, {9, -9835, 76373}, {10, 0, 13820}};
    write(0x2000, 1, 1, 0);
    write(0x4030, 1, 2, 0);
    write(0x4020, 1, 2, 17350);
    write(0x4010, 1, 2, 17250);
    write(0x4000, 1, 2, static_cast<std::uint32_t>(-2730) & 0xFFFFU);
    for (const Range& range : ranges) {
        write(0x6110, 1, 2, range.type);
        const bool hot = range.type == 5 || range.type == 6 || range.type == 10;  // these exceed 1735 degC
        microvolts(1, range.highest + 6.0);
        settle();
        EXPECT_EQ(status(1), hot ? 0x03 : 0) << range.type;
        microvolts(1, range.highest + 14.0);
        settle();
        EXPECT_EQ(status(1), 0x03) << range.type;
        microvolts(1, range.lowest - 6.0);
        settle();
        EXPECT_EQ(status(1), 0) << range.type;
        microvolts(1, range.lowest - 14.0);
        settle();
        EXPECT_EQ(status(1), 0x04) << range.type;
    }
}

}  // namespace canproof::test
