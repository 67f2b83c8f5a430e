// SPDX-License-Identifier: Apache-2.0
#include "devices/cbx-ao412/firmware/voltage_output.hpp"

#include <cmath>

#include "firmware/base/requirement.hpp"
#include "generated/cbx_ao412/requirements.hpp"

namespace canproof::cbx_ao412 {

namespace {

constexpr float codes_at_full_scale = 32768.0F;

}  // namespace

static_assert(implements<req::AO4_AOUT_002> && implements<req::AO4_AOUT_003>);
std::int32_t output_step(const std::int16_t value, const VoltageOutputCircuit& circuit,
                         const OutputCalibration& calibration) noexcept {
    const float offset_codes = (calibration.offset_v / circuit.full_scale_v) * codes_at_full_scale;
    const float code = (static_cast<float>(value) * calibration.gain) + offset_codes;
    const float codes_per_step = static_cast<float>(circuit.codes_per_step);
    // Half a step is four codes: FFFCh (-4) to 0003h are step 0, 0004h is step 1 (7.10.2.2).
    const float step = std::floor((code + (codes_per_step / 2.0F)) / codes_per_step);
    const float largest = static_cast<float>(circuit.steps - 1);
    const float clamped = std::fmin(std::fmax(step, -largest), largest);
    return static_cast<std::int32_t>(clamped);
}

static_assert(implements<req::AO4_AOUT_001>);
float step_voltage(const std::int32_t step, const VoltageOutputCircuit& circuit) noexcept {
    return (static_cast<float>(step) / static_cast<float>(circuit.steps)) * circuit.full_scale_v;
}

}  // namespace canproof::cbx_ao412
