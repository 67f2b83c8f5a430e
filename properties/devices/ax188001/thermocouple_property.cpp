// SPDX-License-Identifier: Apache-2.0
// Properties of the firmware blocks (conversion, gain, delays) of the thermocouple scanner AX188001 (manual, 1.1 to 1.3
// and appendix A).
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "devices/ax188001/firmware/delayed_fault.hpp"
#include "devices/ax188001/firmware/gain_ranging.hpp"
#include "devices/ax188001/firmware/limit_condition.hpp"
#include "devices/ax188001/firmware/process_value.hpp"
#include "devices/ax188001/firmware/thermocouple_curves.hpp"
#include "generated/ax188001/requirements.hpp"
#include "tests/devices/ax188001/its90.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax188001;

const Its90Type& any_type() {
    return its90_types()[static_cast<std::size_t>(*rc::gen::inRange(0, 8))];
}

const ThermocoupleCurve& curve_of(const Its90Type& type) {
    return thermocouple_curve(static_cast<generated::ax188001::SensorType>(type.number));
}

/// Returns one of 2^30 + 1 equally spaced numbers from `low` to `high`.
double between(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, (1 << 30) + 1) / static_cast<double>(1 << 30);
}

double lowest_rising(const Its90Type& type) {
    return type.letter == 'B' ? 21.1 : static_cast<double>(type.lowest());
}

constexpr ConverterCircuit circuit{{{{128, 19531.25}, {64, 39062.5}, {32, 78125.0}}}, 32768.0, 0.9, 4};

}  // namespace

RC_GTEST_PROP(ThermocoupleLaw, ConversionToVoltageAndBackGivesTheSameTemperature, ()) {
    verifies<req::TCS_CONV_004, req::TCS_CONV_002, req::TCS_CONV_007>("property");
    const auto& type = any_type();
    const double celsius = between(lowest_rising(type), static_cast<double>(type.highest()));
    const double back = exact_celsius(curve_of(type), reference_mv(curve_of(type), celsius));
    RC_ASSERT(std::fabs(back - celsius) < 0.001);
}

RC_GTEST_PROP(ThermocoupleLaw, HigherVoltageNeverGivesALowerTemperature, ()) {
    verifies<req::TCS_CONV_003>("property");
    const auto& type = any_type();
    const double a = between(-12.0, 80.0);
    const double b = *rc::gen::element(between(-12.0, 80.0), a + between(0.0, 0.01));
    const double low = exact_celsius(curve_of(type), std::fmin(a, b));
    const double high = exact_celsius(curve_of(type), std::fmax(a, b));
    RC_ASSERT(low <= high + 1e-9);
}

RC_GTEST_PROP(ThermocoupleLaw, VoltageOfTheComputedTemperatureEqualsTheGivenVoltage, ()) {
    verifies<req::TCS_CONV_002>("property");
    const auto& type = any_type();
    const double low = static_cast<double>(type.mv(static_cast<long double>(lowest_rising(type))));
    const double mv = between(low, static_cast<double>(type.mv(type.highest())));
    const double celsius = exact_celsius(curve_of(type), mv);
    // An error of 5 nV is at most 0.02 degC, which is allowed, for every type; the conversion is far more exact.
    RC_ASSERT(std::fabs(static_cast<double>(type.mv(celsius)) - mv) < 5e-6);
}

RC_GTEST_PROP(GainRangingLaw, EveryVoltageIsReadWithinNineConversions, ()) {
    verifies<req::TCS_IN_005, req::TCS_IN_002>("property");
    GainRanging adc;
    for (int i = *rc::gen::inRange(0, 30); i > 0; --i) {
        adc.convert(between(-100000.0, 100000.0), circuit);
    }
    // The converter settles on an arbitrary voltage, then the voltage jumps.
    const double before = between(-100000.0, 100000.0);
    for (int i = 0; i < 18; ++i) {
        adc.convert(before, circuit);
    }
    const double after = between(-100000.0, 100000.0);
    for (int i = 0; i < 9; ++i) {
        adc.convert(after, circuit);
    }
    if (std::fabs(after) >= 78125.0) {
        RC_ASSERT(adc.is_open());
    } else {
        RC_ASSERT(!adc.is_open());
        RC_ASSERT(std::fabs(adc.microvolts() - after) <= 78125.0 / 32768 / 2 + 1e-9);
    }
}

RC_GTEST_PROP(ProcessValueLaw, ProcessValueIsTheNearestIntegerThatFits, ()) {
    verifies<req::TCS_VAL_001, req::TCS_VAL_004, req::TCS_VAL_007>("property");
    const Scaling scaling{between(-1000.0, 1000.0), between(-10000.0, 10000.0)};
    const double field = between(-273.0, 1820.0);
    const double exact = field * scaling.factor + scaling.offset;
    const std::int16_t value = process_value(field, scaling);
    if (exact >= 32767.0) {
        RC_ASSERT(value == 32767);
    } else if (exact <= -32768.0) {
        RC_ASSERT(value == -32768);
    } else {
        RC_ASSERT(std::fabs(value - exact) <= 0.5);
    }
    const std::int16_t sent = measured_process_value(field, scaling, ReservedValues{-1, -512});
    RC_ASSERT(sent != -1 && sent != -512);
    RC_ASSERT(sent == value || (sent == value + 1 && (value == -1 || value == -512)));
}

RC_GTEST_PROP(AverageLaw, AverageLiesBetweenTheValuesOfTheValidChannels, ()) {
    verifies<req::TCS_AVG_001, req::TCS_AVG_005>("property");
    std::array<Measurement, 2> all{};
    double low = 1e9;
    double high = -1e9;
    for (auto& one : all) {
        one = Measurement{between(-273.0, 1820.0), *rc::gen::arbitrary<bool>()};
        low = one.valid ? std::fmin(low, one.value) : low;
        high = one.valid ? std::fmax(high, one.value) : high;
    }
    const Measurement mean = average(all);
    RC_ASSERT(mean.valid == (all[0].valid || all[1].valid));
    RC_ASSERT(!mean.valid || (mean.value >= low - 1e-9 && mean.value <= high + 1e-9));
}

RC_GTEST_PROP(DelayedFaultLaw, FaultIsReportedAfterTheLimitWasExceededForTheWholeDelay, ()) {
    verifies<req::TCS_LIM_003, req::TCS_LIM_012, req::TCS_LIM_002>("property");
    // The naive model goes through the readings, which are 165 ms apart and in tenths of a degree. The fault begins
    // above 100 degC and ends at 99 degC.
    const auto readings = *rc::gen::container<std::vector<int>>(rc::gen::inRange(980, 1020));
    const std::uint64_t delay_ms = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000));
    DelayedFault fault;
    bool told = false;
    std::uint64_t exceeded_for = 0;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const double celsius = readings[i] / 10.0;
        const Instant now{i * 165000};
        fault.advance(milliseconds(delay_ms), now);
        if (!told && exceeded_for > 0 && exceeded_for * 165 >= delay_ms) {
            told = true;
        }
        if (told) {
            told = celsius > 99.0;
            exceeded_for = 0;
        } else if (celsius > 100.0) {
            told = delay_ms <= exceeded_for * 165;
            exceeded_for = told ? 0 : exceeded_for + 1;
        } else {
            exceeded_for = 0;
        }
        fault.judge(high_limit(celsius, 100.0, 99.0), milliseconds(delay_ms), now);
        RC_ASSERT(fault.told() == told);
    }
}

}  // namespace canproof::test
