// SPDX-License-Identifier: Apache-2.0
// Directions and angles as in sections 2.1 and 3.2 to 3.5 of the AX060805 manual, in double precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <vector>

namespace canproof::test {

inline double naive_degrees(double radians) {
    return radians * 180.0 / std::acos(-1.0);
}
inline double naive_radians(double degrees) {
    return degrees * std::acos(-1.0) / 180.0;
}

/// A vector in g along X, Y and Z.
struct NaiveVector {
    double x{0.0};
    double y{0.0};
    double z{0.0};

    double length() const { return std::sqrt(x * x + y * y + z * z); }
};

/// The orientation of a part in its holder (sensor in the unit, or unit in the machine): it is turned by `pitch`
/// degrees about Y, then by `roll` degrees about X.
struct NaiveMount {
    double pitch{0.0};
    double roll{0.0};

    bool is_level() const { return pitch == 0.0 && roll == 0.0; }
    /// Converts a vector from the axes of the part to the axes of the holder.
    NaiveVector out_of(const NaiveVector& v) const {
        const double phi = naive_radians(roll);
        const double theta = naive_radians(pitch);
        const NaiveVector upright{v.x, v.y * std::cos(phi) - v.z * std::sin(phi),
                                  v.y * std::sin(phi) + v.z * std::cos(phi)};
        return {upright.x * std::cos(theta) + upright.z * std::sin(theta), upright.y,
                upright.z * std::cos(theta) - upright.x * std::sin(theta)};
    }
};

/// An angle in degrees, and the most by which the angle that the device computes in single precision may differ from
/// it.
struct NaiveAngle {
    double degrees{0.0};
    double tolerance{0.0};
};

/// Computes the angles of sections 2.1.4 to 2.1.6 for one direction of gravity. `error` is the largest error of a
/// component of the acceleration, in g.
class NaiveDirection {
  public:
    NaiveDirection(const NaiveVector& acceleration, double error, bool is_turned)
        : g_{-acceleration.x, -acceleration.y, -acceleration.z}, error_{error}, is_turned_{is_turned} {}

    bool is_nothing() const { return g_.length() == 0.0; }
    NaiveAngle tilt_pitch() { return tilt(-g_.x, std::hypot(g_.y, g_.z)); }
    NaiveAngle tilt_roll() { return tilt(g_.y, std::hypot(g_.x, g_.z)); }
    NaiveAngle gravity_angle() { return whole(std::hypot(g_.x, g_.y), g_.z); }
    NaiveAngle euler_pitch() { return whole(-g_.x, std::hypot(g_.y, g_.z)); }
    NaiveAngle euler_roll() { return rolled_over(g_.y, g_.z); }
    /// Returns whether the angle between the X axis and the vertical is below `degrees`.
    bool is_upright(double degrees) {
        if (is_nothing()) {
            return false;
        }
        const double from_vertical = std::hypot(g_.y, g_.z) / g_.length();
        const double limit = std::sin(naive_radians(degrees));
        doubt_ = doubt_ || (from_vertical != 0.0 && std::fabs(from_vertical - limit) < 3.0 * error_ / g_.length()) ||
                 (from_vertical < 1.0e-5 && is_turned_);
        return from_vertical < limit;
    }
    /// Returns whether a comparison was so close that rounding in single precision may change its result.
    bool is_doubtful() const { return doubt_; }

  private:
    NaiveAngle tilt(double opposite, double adjacent) {
        const bool is_overhead = g_.z < 0.0;
        doubt_ =
            doubt_ || (g_.z != 0.0 && std::fabs(g_.z) < 8.0 * error_) || (g_.z == 0.0 && is_turned_ && !is_nothing());
        return rolled_over(opposite, is_overhead ? -adjacent : adjacent);
    }
    NaiveAngle whole(double y, double x) const {
        if (is_nothing()) {
            return {};
        }
        return {naive_degrees(std::atan2(y, x)), 1.2e-4 + naive_degrees(2.0 * error_ / g_.length())};
    }
    /// Returns the angle of (x, y) from -180 to +180 degrees. Half a turn always gives +180, even when a rounding error
    /// would give -180.
    NaiveAngle rolled_over(double y, double x) {
        if (y == 0.0 && x == 0.0) {
            return {};
        }
        const double angle = naive_degrees(std::atan2(y, x));
        const double left = 180.0 - std::fabs(angle);
        const double tolerance = 1.2e-4 + naive_degrees(2.0 * error_ / std::hypot(y, x));
        doubt_ = doubt_ || (left < 1.0e-4 + tolerance && (left != 0.0 || is_turned_));
        return {left <= 0.00005 ? 180.0 : angle, tolerance};
    }

    NaiveVector g_;
    double error_;
    bool is_turned_;
    bool doubt_{false};
};

/// One additional filter of section 3.3. Type 0 is no filter, 1 the moving average, 2 the repeating filter. Stores
/// every sample.
class NaiveAverage {
  public:
    /// An angle whose whole range is half a turn is not circular: its samples are averaged as numbers.
    void restart(int type, int constant, bool is_circular) {
        type_ = type;
        constant_ = constant;
        is_circular_ = is_circular;
        samples_.clear();
        block_is_whole_ = false;
        tolerance_ = 0.0;
    }
    void add(const NaiveAngle& angle) {
        tolerance_ = std::max(tolerance_, angle.tolerance);
        if (type_ == 0) {
            output_ = angle;
            return;
        }
        samples_.push_back(nearest_turn(angle.degrees));
        if (type_ == 1) {
            put_out(window_mean());
        } else {
            take_block();
        }
    }
    const NaiveAngle& output() const { return output_; }
    bool is_doubtful() const { return doubt_; }

  private:
    /// Returns the sample, plus or minus whole turns, so that it is as near as possible to the previous sample.
    double nearest_turn(double degrees) {
        const double before = samples_.empty() ? last_of_block_ : samples_.back();
        const bool is_first = samples_.empty() && !block_is_whole_;
        if (is_first || !is_circular_) {
            return degrees;
        }
        double turned = degrees;
        while (turned - before > 180.0) {
            turned -= 360.0;
        }
        while (turned - before <= -180.0) {
            turned += 360.0;
        }
        doubt_ = doubt_ || std::fabs(std::fabs(turned - before) - 180.0) < 0.01;
        return turned;
    }
    /// Returns the mean of the latest `constant` samples. If `constant` is more than 64, the device stores only sums of
    /// runs of samples; all runs have the same length. Of the oldest run, it then counts the share that is in the
    /// window.
    double window_mean() const {
        const int count = static_cast<int>(samples_.size());
        const int seen = std::min(count, constant_);
        const int run = (constant_ + 63) / 64;
        const int open = count % run;
        double sum = 0.0;
        for (int i = count - open; i < count; ++i) {
            sum += samples_[static_cast<std::size_t>(i)];
        }
        int end = count - open;
        for (int missing = seen - open; missing > 0; missing -= run) {
            double of_run = 0.0;
            for (int i = end - run; i < end; ++i) {
                of_run += samples_[static_cast<std::size_t>(i)];
            }
            sum += of_run * std::min(missing, run) / run;
            end -= run;
        }
        return sum / seen;
    }
    void take_block() {
        const bool is_whole = static_cast<int>(samples_.size()) == constant_;
        if (is_whole || !block_is_whole_) {
            double sum = 0.0;
            for (const double one : samples_) {
                sum += one;
            }
            put_out(sum / static_cast<double>(samples_.size()));
        }
        if (is_whole) {
            block_is_whole_ = true;
            last_of_block_ = samples_.back();
            samples_.clear();
        }
    }
    void put_out(double mean) {
        double turned = std::fmod(mean, 360.0);
        turned = turned > 180.0 ? turned - 360.0 : turned <= -180.0 ? turned + 360.0 : turned;
        output_ = {turned, tolerance_ + 1.0e-5};
        doubt_ = doubt_ || 180.0 - std::fabs(turned) < 2.0 * output_.tolerance;
    }

    int type_{0};
    int constant_{10};
    bool is_circular_{true};
    std::vector<double> samples_;
    bool block_is_whole_{false};
    double last_of_block_{0.0};
    double tolerance_{0.0};
    NaiveAngle output_{};
    bool doubt_{false};
};

}  // namespace canproof::test
