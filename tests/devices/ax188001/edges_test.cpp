// SPDX-License-Identifier: Apache-2.0
// Checks the constants of the AX188001 (manual, 1.1, 3.3, 3.4, appendix A) by the behaviour of the device just below
// and just above each constant, much closer than 1 %.
#include <gtest/gtest.h>

#include "generated/ax188001/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr double finest_step_uv = 19531.25 / 32768.0;  // 2.5 V / 128 on 15 bits

/// A voltage that is a step of the converter at gain 128, and its temperature rounded to tenths of a degree.
struct Reading {
    double uv;
    int tenths;
};

/// Returns the temperature of a type J voltage, with the cold junction at 0 degC.
double celsius_of(double uv) {
    const Its90Type& type = its90_types().front();
    double low = 0.0;
    double high = 300.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2.0;
        (static_cast<double>(type.mv(static_cast<long double>(middle))) * 1000.0 < uv ? low : high) = middle;
    }
    return low;
}

/// Of all readings between 60 and 200 degC, returns the one whose temperature is least above (or below) a tenth of a
/// degree.
Reading closest(bool above) {
    Reading best{0.0, 0};
    double distance = 1.0;
    for (int tenths = 600; tenths < 2000; ++tenths) {
        const double at = tenths / 10.0;
        const auto uv = static_cast<double>(its90_types().front().mv(static_cast<long double>(at))) * 1000.0;
        const double code = std::floor(uv / finest_step_uv) + (above ? 1.0 : 0.0);
        const double away = std::fabs(celsius_of(code * finest_step_uv) - at);
        if (away < distance && away > 1e-5) {
            distance = away;
            best = {code * finest_step_uv, tenths};
        }
    }
    EXPECT_LT(distance, 1e-3);  // the distance is in degC: less than a thousandth of the hysteresis of 1 degC
    return best;
}

/// Fixture whose channel 1 has a type J thermocouple, no cold junction compensation, no fault delay, and wide limits.
class Ax188001Edges : public TcsTest {
  protected:
    void SetUp() override {
        TcsTest::SetUp();
        EXPECT_EQ(write(0x2000, 1, 1, 0), 0U);
        EXPECT_EQ(write(0x4030, 1, 2, 0), 0U);
        EXPECT_EQ(write(0x4020, 1, 2, 17350), 0U);
    }
    void show(double uv) {
        microvolts(1, uv);
        settle();
    }
    void show_high_limit(int tenths) { EXPECT_EQ(write(0x4010, 1, 2, static_cast<std::uint32_t>(tenths)), 0U); }
    int gain() const { return device->outputs().tc_gain[0]; }
};

}  // namespace

TEST_F(Ax188001Edges, LimitIsExceededJustAboveItsValue) {
    verifies<req::TCS_K_LIMIT_RESOLUTION, req::TCS_LIM_016>();
    const Reading above = closest(true);
    const Reading below = closest(false);
    show(above.uv);
    show_high_limit(above.tenths);
    EXPECT_EQ(status(1), 2);
    show_high_limit(5000);
    EXPECT_EQ(status(1), 0);
    show(below.uv);
    show_high_limit(below.tenths);
    EXPECT_EQ(status(1), 0);
    show_high_limit(below.tenths - 1);
    EXPECT_EQ(status(1), 2);
}

TEST_F(Ax188001Edges, HysteresisOfAHighLimitIsOneDegree) {
    verifies<req::TCS_LIM_002, req::TCS_K_HYSTERESIS>();
    for (const bool above : {true, false}) {
        const Reading reading = closest(above);
        show(finest_step_uv * 25000.0);  // 268 degC is above all limits
        show_high_limit(reading.tenths + 10);
        EXPECT_EQ(status(1), 2);
        show(reading.uv);
        EXPECT_EQ(status(1), above ? 2 : 0);
        show_high_limit(5000);
    }
}

TEST_F(Ax188001Edges, HysteresisOfALowLimitIsOneDegree) {
    verifies<req::TCS_LIM_002, req::TCS_K_HYSTERESIS>();
    show_high_limit(5000);
    for (const bool above : {true, false}) {
        const Reading reading = closest(above);
        show(0.0);
        EXPECT_EQ(write(0x4000, 1, 2, static_cast<std::uint32_t>(reading.tenths - 10)), 0U);
        EXPECT_EQ(status(1), 4);
        show(reading.uv);
        EXPECT_EQ(status(1), above ? 0 : 4);
    }
}

TEST_F(Ax188001Edges, EachConverterGainIsUsedOnlyBelowItsFullScale) {
    verifies<req::TCS_IN_003, req::TCS_T_GAIN>();
    const std::vector<std::pair<double, int>> cases{{19531.0, 128}, {19531.25, 64},  {39062.0, 64},
                                                    {39062.5, 32},  {-19531.25, 64}, {-39062.5, 32}};
    for (const auto& [uv, expected] : cases) {
        show(0.0);
        EXPECT_EQ(gain(), 128);
        show(uv);
        EXPECT_EQ(gain(), expected) << uv;
    }
    show(78124.9);
    EXPECT_NE(process_value(1), -512);
    show(78125.0);
    EXPECT_EQ(process_value(1), -512);
}

TEST_F(Ax188001Edges, GainRisesAt90PercentOfFullScale) {
    verifies<req::TCS_IN_004, req::TCS_K_GAIN_BACK>();
    // 90 % of the full scales of gain 128 and 64: 0.9 * 19531.25 uV = 17578.1 uV, 0.9 * 39062.5 uV = 35156.2 uV
    const std::vector<std::pair<double, int>> cases{{17578.0, 128}, {17579.0, 64}, {35156.0, 64}, {35157.0, 32}};
    for (const auto& [uv, expected] : cases) {
        show(60000.0);
        EXPECT_EQ(gain(), 32);
        show(uv);
        EXPECT_EQ(gain(), expected) << uv;
    }
}

TEST_F(Ax188001Edges, RangeOfThermocoupleTypeTEnds10MicrovoltsBeyondThePrintedRange) {
    verifies<req::TCS_CONV_011, req::TCS_K_RANGE_MARGIN, req::TCS_T1, req::TCS_CONV_013>();
    // The range of type T is -6.258 to 20.872 mV. The converter reads 20 mV in steps of 1.192 uV, 6 mV in steps of
    // 0.596 uV.
    EXPECT_EQ(write(0x6110, 1, 2, 7), 0U);
    show_high_limit(17250);
    EXPECT_EQ(write(0x4000, 1, 2, static_cast<std::uint16_t>(-2730)), 0U);
    const double coarse = 2.0 * finest_step_uv;
    const std::vector<std::pair<double, int>> cases{{std::floor(20882.0 / coarse) * coarse, 0},
                                                    {std::ceil(20882.0 / coarse) * coarse, 3},
                                                    {std::ceil(-6268.0 / finest_step_uv) * finest_step_uv, 0},
                                                    {std::floor(-6268.0 / finest_step_uv) * finest_step_uv, 4}};
    for (const auto& [uv, expected] : cases) {
        show(uv);
        EXPECT_EQ(status(1), expected) << uv;
    }
}

/// The compensation of the cold junction adds a small voltage to a reading. The test chooses it so that the sum is 0.05
/// uV below or above the end of the margin.
TEST_F(Ax188001Edges, MarginBeyondAnInputRangeIsExactToHalfAPercent) {
    verifies<req::TCS_CONV_011, req::TCS_K_RANGE_MARGIN>();
    const Its90Type& type = its90_types()[5];  // type T: the range ends at 20.872 mV, with a margin of 10 uV
    EXPECT_EQ(write(0x6110, 1, 2, 7), 0U);
    EXPECT_EQ(write(0x2000, 1, 1, 1), 0U);
    show_high_limit(17250);
    const double measured = 2.0 * finest_step_uv * 16650.0;  // 19848 uV at gain 64
    for (const double beyond : {9.95, 10.05}) {
        double low = 20.0;
        double high = 35.0;
        for (int i = 0; i < 60; ++i) {
            const double middle = (low + high) / 2.0;
            const double uv = measured + static_cast<double>(type.mv(static_cast<long double>(middle))) * 1000.0;
            (uv < 20872.0 + beyond ? low : high) = middle;
        }
        inputs.cold_junction = static_cast<float>(low);
        show(measured);
        EXPECT_EQ(status(1), beyond > 10.0 ? 3 : 0) << beyond;
    }
}

TEST_F(Ax188001Edges, ColdJunctionIsReadFromMinus40To110Degrees) {
    verifies<req::TCS_CJ_006, req::TCS_K_CJ_LOWEST, req::TCS_K_CJ_HIGHEST>();
    const std::vector<std::pair<float, float>> cases{
        {-39.9F, -39.9F}, {-40.1F, -40.0F}, {109.9F, 109.9F}, {110.1F, 110.0F}};
    for (const auto& [celsius, shown] : cases) {
        inputs.cold_junction = celsius;
        set_inputs();
        read_once();
        EXPECT_EQ(read(0x3100).real(), shown);
    }
}

TEST_F(Ax188001Edges, RemainingMainsHumFollowsTheRejectionOfTheFilter) {
    verifies<req::TCS_IN_007, req::TCS_T_REJECTION, req::TCS_IN_023>();
    // Of 1 V of hum at the selected frequency, 110 dB leave 3.16 uV. At the other frequency the filter leaves 1330 uV
    // (60 Hz selected) or 590 uV (50 Hz selected).
    struct Case {
        std::uint32_t filter;
        std::uint8_t mains;
        double left_uv;
    };
    inputs.tc_hum[0] = 1e6F;
    for (const Case& one : {Case{60, 60, 3.1623}, Case{60, 50, 1330.0}, Case{50, 50, 3.1623}, Case{50, 60, 590.0}}) {
        EXPECT_EQ(write(0x2020, 0, 1, one.filter), 0U);
        inputs.mains_frequency = one.mains;
        show(5000.0);
        const auto first = static_cast<std::int32_t>(read(0x2010, 1).value);
        read_once();
        const auto second = static_cast<std::int32_t>(read(0x2010, 1).value);
        EXPECT_NEAR(std::abs(first - second), 2.0 * one.left_uv,
                    2.0);  // hum is added to one reading and subtracted from the other; the tolerance covers steps of
                           // 0.6 uV
    }
}

TEST_F(Ax188001Edges, ProcessorTemperatureIsRoundedToTenths) {
    verifies<req::TCS_FD_001, req::TCS_FD_002, req::TCS_K_FD_RESOLUTION>();
    EXPECT_EQ(write(0x5051, 1, 2, 0), 0U);
    const std::vector<std::pair<float, unsigned>> cases{{110.04F, 0}, {110.06F, 1}};  // 5041h:1 is 110.0 degC
    for (const auto& [celsius, expected] : cases) {
        inputs.cpu_temperature = celsius;
        set_inputs();
        read_once();
        EXPECT_EQ(read(0x1001).value, expected) << celsius;
    }
    inputs.cpu_temperature = 85.06F;  // 5042h:1 (FD Clear Threshold) is 85.0 degC
    set_inputs();
    read_once();
    EXPECT_EQ(read(0x1001).value, 1U);
    inputs.cpu_temperature = 85.04F;
    set_inputs();
    read_once();
    EXPECT_EQ(read(0x1001).value, 0U);
}

TEST_F(Ax188001Edges, LongestDelaysAreExactToAMillisecond) {
    verifies<req::TCS_FD_004, req::TCS_LIM_003>();
    EXPECT_EQ(write(0x5051, 2, 2, 10000), 0U);
    inputs.supply = 8.0F;  // an under-voltage, read at 165 ms
    set_inputs();
    EXPECT_EQ(pass(10164), Frames{});
    EXPECT_EQ(pass(1).size(), 1U);
    EXPECT_EQ(write(0x4030, 1, 2, 60000), 0U);
    EXPECT_EQ(write(0x4000, 1, 2, 100), 0U);  // 4000h:1: low warning below 10.0 degC; channel 1 reads 0 degC
    EXPECT_EQ(pass(59999), Frames{});
    EXPECT_EQ(pass(1).size(), 1U);
}

TEST_F(Ax188001Edges, LimitsOfAParameterAreAcceptedAndValuesJustBeyondAreRefused) {
    verifies<req::TCS_VAL_009, req::TCS_LIM_011, req::TCS_START_004>();
    for (const int index : {0x6126, 0x6127}) {
        const float end = index == 0x6126 ? 1000.0F : 10000.0F;
        for (const float sign : {1.0F, -1.0F}) {
            EXPECT_EQ(write_real(index, 1, sign * end), 0U);
            EXPECT_EQ(write_real(index, 1, sign * std::nextafter(end, 20000.0F)), sign > 0 ? too_high : too_low);
        }
    }
    EXPECT_EQ(write(0x4030, 2, 2, 60000), 0U);
    EXPECT_EQ(write(0x4030, 2, 2, 60001), too_high);
    EXPECT_EQ(write(0x5051, 2, 2, 10000), 0U);
    EXPECT_EQ(write(0x5051, 2, 2, 10001), too_high);
    EXPECT_EQ(write(0x5556, 0, 2, 65000), 0U);
    EXPECT_EQ(write(0x5556, 0, 2, 65001), too_high);
    EXPECT_EQ(write(0x4000, 2, 2, static_cast<std::uint16_t>(-2730)), 0U);
    EXPECT_EQ(write(0x4000, 2, 2, static_cast<std::uint16_t>(-2731)), too_low);
    EXPECT_EQ(write(0x4020, 2, 2, 17350), 0U);
    EXPECT_EQ(write(0x4020, 2, 2, 17351), too_high);
}

}  // namespace canproof::test
