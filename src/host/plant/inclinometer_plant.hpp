// The physical world of the AX060805: a unit at rest in some attitude, its sensor's noise, its supply.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "firmware/devices/ax060805.hpp"

namespace canproof::host {

class InclinometerPlant {
  public:
    /// A stimulus was set in `inputs`: what it is the cause of changes there too. Whichever of pitch and roll, the
    /// quaternion and the accelerations came last makes the accelerations.
    void stimulus(const std::string& name, ax060805::Inputs& inputs);
    /// Whether each sample has noise of its own.
    bool is_noisy(const ax060805::Inputs& inputs) const;
    /// The accelerations with noise for one sample; without noise, those of the attitude.
    void add_noise(ax060805::Inputs& inputs);

  private:
    void take_axis(char axis, const ax060805::Inputs& inputs);
    double normal();

    Vector3 rest_{0.0F, 0.0F, -1.0F};  ///< what a sensor without noise feels, in g
    std::mt19937 noise_{1U};
};

/// Root mean square of the noise of one sample on one axis, in g: after the input filter at the rated cut-off frequency
/// the pitch of a level unit scatters by `resolution_deg` / 3.46 (5.1.1). 0 without a resolution.
double sample_noise(double resolution_deg);

}  // namespace canproof::host
