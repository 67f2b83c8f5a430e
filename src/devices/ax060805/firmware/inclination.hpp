// SPDX-License-Identifier: Apache-2.0
// Converts accelerometer samples to accelerations and angles in the machine's frame of reference (AX060805, 2.1, 3.2 to
// 3.4, 3.7).
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "devices/ax060805/firmware/low_pass.hpp"
#include "devices/ax060805/firmware/tilt.hpp"

namespace canproof::ax060805 {

struct InclinationSettings {
    float filter_share{1.0F};  ///< result of low_pass_coefficient(); 1 switches the filter off
    PitchRoll calibration{};   ///< how the sensor is mounted in the unit, degrees
    PitchRoll installation{};  ///< how the unit is mounted on the machine, degrees
    bool euler{false};         ///< pitch and roll as Euler angles; otherwise as tilt angles
    /// Angle between the X axis and the vertical, in degrees, below which the Euler roll is unreliable.
    float gimbal_lock_cone{0.0F};
    float least_gravity{0.0F};  ///< in g; a smaller acceleration has no measurable direction
};

/// Positions of the three angles in the array that angles() returns.
constexpr std::size_t pitch_angle = 0U;
constexpr std::size_t roll_angle = 1U;
constexpr std::size_t gravity_tilt = 2U;
constexpr std::size_t angle_count = 3U;

class Inclination {
  public:
    /// Clears all measurements, as at power-on.
    void restart() noexcept { *this = Inclination{}; }
    /// Processes one sample, in g, in the sensor's frame of reference.
    void sample(const Vector3& acceleration, const InclinationSettings& settings) noexcept;
    /// Marks the sensor as failed: the measured values stay, and the filter starts again with the next valid sample.
    void fail() noexcept;
    /// Computes acceleration and angles of the last sample again with new settings. Does nothing without a valid
    /// sample.
    void update(const InclinationSettings& settings) noexcept;

    /// Returns whether there was a sample and the sensor has not failed since.
    bool is_measuring() const noexcept { return measuring_; }
    /// Returns whether the latest acceleration is too small to have a direction. The angles are then those of the last
    /// direction.
    bool is_weightless() const noexcept { return weightless_; }
    /// Returns whether the roll is an Euler angle and unreliable because the X axis is too near to the vertical
    /// (2.1.6).
    bool is_roll_unsure() const noexcept { return roll_unsure_; }
    /// Returns the acceleration in g in the machine's frame of reference, after the input filter.
    const Vector3& acceleration() const noexcept { return acceleration_; }
    /// Returns the angles in degrees; see pitch_angle, roll_angle and gravity_tilt.
    const std::array<float, angle_count>& angles() const noexcept { return angles_; }
    /// Returns the installation angles with which pitch and roll are 0 in the present position (3.4). Returns nothing
    /// without a valid direction or in gimbal lock.
    std::optional<PitchRoll> nulling_angles(const InclinationSettings& settings) const noexcept;

  private:
    float last_roll(const InclinationSettings& settings) const noexcept;

    LowPass filter_{};
    Vector3 acceleration_{};
    std::array<float, angle_count> angles_{};
    Vector3 direction_{};  ///< the last acceleration of the unit that was large enough for a direction
    Vector3 rolled_{};     ///< the last of these accelerations whose Euler roll was defined
    bool measuring_{false};
    bool weightless_{false};
    bool roll_unsure_{false};
};

}  // namespace canproof::ax060805
