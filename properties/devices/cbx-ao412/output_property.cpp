// SPDX-License-Identifier: Apache-2.0
// Properties of a voltage output of the CAN-CBX-AO412 (manual, 7.10.2.2 and 7.11).
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <cmath>

#include "devices/cbx-ao412/firmware/voltage_output.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace cbx_ao412;

// Full scale is 4.096 V * 30.9 / 12.4 = 10.20697 V, at value 32768. The converter has 4096 steps; one step is 8 units
// of the value.
constexpr VoltageOutputCircuit circuit{4.096F * 30.9F / 12.4F, 4096, 8};

}  // namespace

RC_GTEST_PROP(VoltageOutputLaw, OutputStepIsTheNearestToTheValueWithHalvesRoundedUp, (std::int16_t value)) {
    verifies<req::AO4_AOUT_002>("property");
    const int step = output_step(value, circuit, OutputCalibration{});
    const int unclamped = static_cast<int>(std::floor((value + 4) / 8.0));
    RC_ASSERT(step == std::max(-4095, std::min(4095, unclamped)));
}

RC_GTEST_PROP(VoltageOutputLaw, OutputStaysWithinTheRangeOfTheConverter,
              (std::int16_t value, std::int16_t gain, std::int16_t offset)) {
    verifies<req::AO4_AOUT_003>("property");
    const OutputCalibration calibration{1.0F + static_cast<float>(gain) / 262144.0F,
                                        static_cast<float>(offset) * 312.5e-6F};
    const float volts = step_voltage(output_step(value, circuit, calibration), circuit);
    RC_ASSERT(std::fabs(volts) <= 10.2046F);  // 4095 / 4096 of 10.20697 V
}

RC_GTEST_PROP(VoltageOutputLaw, LargerValueGivesNoLowerOutputStep, (std::int16_t a, std::int16_t b)) {
    verifies<req::AO4_AOUT_003>("property");
    const auto low = std::min(a, b);
    const auto high = std::max(a, b);
    RC_ASSERT(output_step(low, circuit, OutputCalibration{}) <= output_step(high, circuit, OutputCalibration{}));
}

}  // namespace canproof::test
