// SPDX-License-Identifier: Apache-2.0
// The naive outputs of the CAN-CBX-AO412: voltage from 6411h (Write Analogue Output 16-Bit), calibration and error mode
// (manual, 4.3.1, 7.10, 7.11). Shares no code with the firmware.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace canproof::naive_ao4 {

struct OutputSettings {
    int command{0};               ///< 6411h (Write Analogue Output 16-Bit)
    unsigned error_mode{1};       ///< 6443h (Analogue Output Error Mode)
    std::int32_t error_value{0};  ///< 6444h (Analogue Output Error Value)
    int offset{0};                ///< 2404h (Calibration Offset Value)
    int gain{0};                  ///< 2405h (Calibration Gain Value)
};

/// The range of D/A converter steps that are correct for an output: `low` to `high`, both included.
struct Steps {
    int low;
    int high;
};

/// Returns the D/A converter steps that are correct for `value` (sections 7.10.2.2, 7.11). Applies gain and offset to
/// the value and takes the nearest step; one step is eight units of the value, and halves are rounded up. Clamps the
/// step to ±4095. Near the border of two steps a calibrated output may show either step, because the precision of its
/// calculation is not specified.
inline Steps steps_of(const OutputSettings& set, int value) {
    const double full_scale_v = 4.096 * 30.9 / 12.4;
    const double gain = 1.0 + set.gain / 262144.0;
    const double offset_v = set.offset * (10.24 / 32768.0);
    const double code = value * gain + offset_v / full_scale_v * 32768.0;
    const double unsure = set.gain == 0 && set.offset == 0 ? 0.0 : 0.01;
    const auto step = [](double of) {
        return static_cast<int>(std::fmin(std::fmax(std::floor((of + 4.0) / 8.0), -4095.0), 4095.0));
    };
    return {step(code - unsure), step(code + unsure)};
}

class Output {
  public:
    void command(int value) {
        driven_ = true;
        held_ = value;
    }
    /// Sets the output to what the error mode requires: 0 V, the error value, or the present value (section 7.10.3).
    void fail(const OutputSettings& set) {
        if (set.error_mode == 0) {
            driven_ = false;
        } else if (set.error_mode == 1) {
            command(set.error_value >> 16);
        }
    }
    Steps shown(const OutputSettings& set) const { return driven_ ? steps_of(set, held_) : Steps{0, 0}; }

  private:
    bool driven_{false};
    int held_{0};
};

}  // namespace canproof::naive_ao4
