// From a 16-bit value to the voltage of a 12-bit-and-sign output (CAN-CBX-AO412, 4.3.1, 7.10.2.2, 7.11).
#pragma once

#include <cstdint>

namespace canproof::cbx_ao412 {

/// What describes the output circuit; the device fills it from the register.
struct VoltageOutputCircuit {
    float full_scale_v{0.0F};        ///< voltage that 32768 would stand for
    std::int32_t steps{0};           ///< steps from 0 to full scale; the largest output is one less
    std::int32_t codes_per_step{0};  ///< input values that fall on one step
};

struct OutputCalibration {
    float gain{1.0F};
    float offset_v{0.0F};
};

/// The converter step, -(steps - 1)…steps - 1: the value corrected by gain and offset, rounded half a step up, clamped.
std::int32_t output_step(std::int16_t value, const VoltageOutputCircuit& circuit,
                         const OutputCalibration& calibration) noexcept;

/// Volts at the terminal for a step.
float step_voltage(std::int32_t step, const VoltageOutputCircuit& circuit) noexcept;

}  // namespace canproof::cbx_ao412
