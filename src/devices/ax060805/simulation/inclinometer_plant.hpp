// The physical world of the AX060805: a unit at rest in some attitude, its sensor's noise, its supply.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "devices/ax060805/firmware/ax060805.hpp"
#include "devices/ax060805/simulation/sensor_errors.hpp"

namespace canproof::host {

class InclinometerPlant {
  public:
    InclinometerPlant() = default;
    explicit InclinometerPlant(const SensorErrors& errors) : errors_{errors} {}

    /// A stimulus was set in `inputs`: what it is the cause of changes there too. Whichever of pitch and roll, the
    /// quaternion and the accelerations came last makes the accelerations.
    void stimulus(const std::string& name, ax060805::Inputs& inputs);
    /// Whether each sample has noise of its own.
    bool is_noisy(const ax060805::Inputs& inputs) const;
    /// The accelerations for one sample: those of the attitude, with the sensor's errors and its noise.
    void add_noise(ax060805::Inputs& inputs);

  private:
    void take_axis(char axis, const ax060805::Inputs& inputs);
    double normal();

    SensorErrors errors_{};
    ax060805::Vector3 rest_{0.0F, 0.0F, -1.0F};  ///< what a sensor without noise and errors feels, in g
    std::mt19937 noise_{1U};
};

/// Root mean square of the noise of one sample on one axis, in g: after the input filter at the rated cut-off frequency
/// the pitch of a level unit scatters by `resolution_deg` / 3.46 (5.1.1). 0 without a resolution.
double sample_noise(double resolution_deg);

}  // namespace canproof::host
