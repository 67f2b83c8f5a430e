// SPDX-License-Identifier: Apache-2.0
// First-order low-pass filter for the accelerations of three axes (AX060805, 3.2, 4.3.2, 4.3.3, 5.1.2).
#pragma once

#include "devices/ax060805/firmware/tilt.hpp"
#include "firmware/base/time.hpp"

namespace canproof::ax060805 {

/// Returns the filter coefficient 1 - exp(-2 pi f T): with each sample the output covers this fraction of its distance
/// to the input. Here f is the cut-off frequency and T the period; f T is at most 0.5.
float low_pass_coefficient(float cut_off_hz, Duration period) noexcept;

/// Returns the delay, in milliseconds, with which the output follows a slow change of the input: the time constant 1 /
/// (2 pi f).
float low_pass_delay_ms(float cut_off_hz) noexcept;

class LowPass {
  public:
    /// Restarts the filter: the next sample passes unfiltered, so that the output does not ramp up from 0.
    void restart() noexcept { started_ = false; }
    /// Filters a sample. `coefficient` is 0…1; 1 passes samples unfiltered.
    const Vector3& update(const Vector3& sample, float coefficient) noexcept;
    const Vector3& output() const noexcept { return output_; }

  private:
    Vector3 output_{};
    bool started_{false};
};

}  // namespace canproof::ax060805
