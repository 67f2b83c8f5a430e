// SPDX-License-Identifier: Apache-2.0
// A converter for small voltages that selects its own gain (AX188001, 1.1): the highest one that the voltage does not
// overdrive, which gives the finest resolution. After each change of the gain, the converter's filter must settle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace canproof::ax188001 {

struct ConverterGain {
    std::uint8_t gain{1U};
    double full_scale_uv{0.0};
};

/// The parameters of the converter; the device takes them from the requirements register.
struct ConverterCircuit {
    static constexpr std::size_t gain_count = 3U;
    std::array<ConverterGain, gain_count> gains{};  ///< highest gain first
    double codes{1.0};                              ///< converter steps from 0 V to full scale, for each polarity
    /// Fraction of the full scale of a higher gain: at or below this voltage the converter returns to that gain.
    double raise_fraction{1.0};
    std::uint8_t settling_conversions{0U};
};

class GainRanging {
  public:
    /// Resets to the highest gain, settled, with a reading of 0 V.
    void reset() noexcept { *this = GainRanging{}; }
    /// Restarts the filter, as a change of the filter frequency does.
    void unsettle(const ConverterCircuit& circuit) noexcept { settling_left_ = circuit.settling_conversions; }
    /// Converts `input_uv` once; a conversion takes one update period.
    void convert(double input_uv, const ConverterCircuit& circuit) noexcept;

    /// Returns the last voltage read while the filter was settled and the converter not overdriven.
    double microvolts() const noexcept { return microvolts_; }
    /// Returns whether the last settled conversion overdrove the converter at the lowest gain. This counts as an open
    /// circuit, because a thermocouple hardly ever gives such a voltage (TCS-D-093).
    bool is_open() const noexcept { return open_; }
    std::uint8_t gain(const ConverterCircuit& circuit) const noexcept { return circuit.gains[step_].gain; }

  private:
    void choose(std::size_t step, const ConverterCircuit& circuit) noexcept;

    double microvolts_{0.0};
    std::size_t step_{0U};
    std::uint8_t settling_left_{0U};
    bool open_{false};
};

}  // namespace canproof::ax188001
