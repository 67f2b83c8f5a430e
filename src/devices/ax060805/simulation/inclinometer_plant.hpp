// SPDX-License-Identifier: Apache-2.0
// The plant (simulated surroundings) of the AX060805: the attitude of a unit at rest, the noise of its sensor, its
// supply.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "devices/ax060805/firmware/ax060805.hpp"
#include "devices/ax060805/simulation/sensor_errors.hpp"

namespace canproof::ax060805 {

class InclinometerPlant {
  public:
    InclinometerPlant() = default;
    explicit InclinometerPlant(const SensorErrors& errors) : errors_{errors} {}

    /// Changes the inputs that depend on the stimulus `name`, which was set in `inputs` before. The accelerations
    /// follow from the stimulus that was set last: pitch and roll, the quaternion, or the accelerations.
    void stimulus(const std::string& name, Inputs& inputs);
    /// Returns whether the samples have noise.
    bool is_noisy(const Inputs& inputs) const;
    /// Sets the accelerations for one sample: those of the attitude with the errors and the noise of the sensor.
    void add_noise(Inputs& inputs);

  private:
    void take_axis(char axis, const Inputs& inputs);
    double normal();

    SensorErrors errors_{};
    /// The acceleration that a sensor without noise and errors measures, in g.
    Vector3 rest_{0.0F, 0.0F, -1.0F};
    std::mt19937 noise_{1U};
};

/// Returns the root mean square of the noise of one sample on one axis, in g. With this noise, the pitch of a level
/// unit scatters by `resolution_deg` / 3.46 after the input filter at the rated cut-off frequency (5.1.1). Returns 0
/// for a resolution of 0.
double sample_noise(double resolution_deg);

}  // namespace canproof::ax060805
