// From samples of the accelerometer to accelerations and angles in the machine's frame (AX060805, 2.1, 3.2
// to 3.4, 3.7).
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "devices/ax060805/firmware/low_pass.hpp"
#include "devices/ax060805/firmware/tilt.hpp"

namespace canproof::ax060805 {

struct InclinationSettings {
    float filter_share{1.0F};      ///< of low_pass_coefficient(); 1 switches the filter off
    PitchRoll calibration{};       ///< of the sensor in the unit, degrees
    PitchRoll installation{};      ///< of the unit on the machine, degrees
    bool euler{false};             ///< pitch and roll as Euler angles; otherwise as tilt angles
    float gimbal_lock_cone{0.0F};  ///< degrees; within it the Euler roll cannot be trusted
    float least_gravity{0.0F};     ///< g; below it there is no direction to measure
};

/// Positions of the angles in what angles() gives.
constexpr std::size_t pitch_angle = 0U;
constexpr std::size_t roll_angle = 1U;
constexpr std::size_t gravity_tilt = 2U;
constexpr std::size_t angle_count = 3U;

class Inclination {
  public:
    /// Power-on: nothing measured yet.
    void restart() noexcept { *this = Inclination{}; }
    /// One sample, in g, in the sensor's frame.
    void sample(const Vector3& acceleration, const InclinationSettings& settings) noexcept;
    /// The sensor gives no valid sample: what was measured stays, and the filter starts anew afterwards.
    void fail() noexcept;
    /// The settings are others: angles of the last direction by them.
    void update(const InclinationSettings& settings) noexcept;

    /// There was a sample, and the sensor has not failed since.
    bool is_measuring() const noexcept { return measuring_; }
    /// The latest sample is too small to have a direction: angles are those of the last one that had.
    bool is_weightless() const noexcept { return weightless_; }
    /// The roll is an Euler angle, and the X axis too near to the vertical for it (2.1.6).
    bool is_roll_unsure() const noexcept { return roll_unsure_; }
    /// Of the machine's frame, in g, behind the input filter.
    const Vector3& acceleration() const noexcept { return acceleration_; }
    /// Degrees; see pitch_angle, roll_angle and gravity_tilt.
    const std::array<float, angle_count>& angles() const noexcept { return angles_; }
    /// The installation angles for which the present position reads 0 (3.4); none without a valid direction and in
    /// gimbal lock.
    std::optional<PitchRoll> nulling_angles(const InclinationSettings& settings) const noexcept;

  private:
    float last_roll(const InclinationSettings& settings) const noexcept;

    LowPass filter_{};
    Vector3 acceleration_{};
    std::array<float, angle_count> angles_{};
    Vector3 direction_{};  ///< the last acceleration of the unit that was no weightlessness
    Vector3 rolled_{};     ///< the last one of these that had an Euler roll
    bool measuring_{false};
    bool weightless_{false};
    bool roll_unsure_{false};
};

}  // namespace canproof::ax060805
