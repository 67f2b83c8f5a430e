// SPDX-License-Identifier: Apache-2.0
// Converts a 16-bit value to the voltage of an output with 12 bits and sign (CAN-CBX-AO412, 4.3.1, 7.10.2.2, 7.11).
#pragma once

#include <cstdint>

namespace canproof::cbx_ao412 {

/// The parameters of the output circuit; the device takes them from the requirements register.
struct VoltageOutputCircuit {
    float full_scale_v{0.0F};        ///< voltage of the value 32768, which no output reaches
    std::int32_t steps{0};           ///< steps from 0 to full scale; the largest output step is one less
    std::int32_t codes_per_step{0};  ///< number of input values that give the same step
};

struct OutputCalibration {
    float gain{1.0F};
    float offset_v{0.0F};
};

/// Returns the converter step, -(steps - 1)…steps - 1: the value corrected by gain and offset, rounded to nearest
/// (halves up) and clamped.
std::int32_t output_step(std::int16_t value, const VoltageOutputCircuit& circuit,
                         const OutputCalibration& calibration) noexcept;

/// Returns the voltage at the terminal for a step, in V.
float step_voltage(std::int32_t step, const VoltageOutputCircuit& circuit) noexcept;

}  // namespace canproof::cbx_ao412
