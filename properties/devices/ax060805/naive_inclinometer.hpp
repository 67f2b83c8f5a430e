// SPDX-License-Identifier: Apache-2.0
// Naive model of the whole AX060805 according to its manual and the decisions of the register. It stores the written
// parameters in a map, has a clock in milliseconds, and computes each value again whenever the value is needed.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "properties/devices/ax060805/naive_angles.hpp"
#include "properties/devices/ax060805/naive_functions.hpp"

namespace canproof::test {

/// The physical inputs of the sensor and the board.
struct NaiveFelt {
    NaiveVector acceleration{0.0, 0.0, -1.0};
    bool fault{false};
    double sensor_temperature{25.0};
    double processor_temperature{30.0};
    double supply{static_cast<double>(23.2F)};
};

/// Properties of one device. With range 0, angles are from -180 to 180 degrees, with range 1 from 0 to 360, with range
/// 2 from 0 to 90.
struct NaiveUnit {
    NaiveMount calibration{};
    int range{0};
};

/// The values of the parameters that were written, by index and sub-index.
using NaiveEntries = std::map<std::pair<unsigned, unsigned>, double>;

class NaiveInclinometer {
  public:
    /// Switches the model on at time 0 with the stored parameters, and takes its first sample.
    NaiveInclinometer(const NaiveUnit& unit, const NaiveFelt& felt, const NaiveEntries& stored)
        : unit_{unit}, to_feel_{felt}, entries_{stored} {
        sample();
        restart_filters();
        run_functions();
    }

    /// Returns the value of a parameter: the written value, or the default.
    double entry(unsigned index, unsigned sub = 0) const {
        const auto found = entries_.find({index, sub});
        return found != entries_.end() ? found->second : default_of(index);
    }
    /// Writes a parameter. Returns false if the device must refuse the write.
    bool write(unsigned index, unsigned sub, double value) {
        if (index == 0x2300) {
            return value == 0.0 || null();
        }
        const bool is_received = index == 0x2500;
        entries_[{index, sub}] = value;
        if (is_received) {
            received_[sub - 1U] = true;
        } else if (index == 0x2052) {
            restart_filters();
        } else if (index == 0x2050 || index == 0x2051) {
            restart_filter(sub - 1U);
        } else if (index == 0x2100 || index == 0x2200 || index == 0x2210) {
            find_angles();
            restart_filters();
        }
        return true;
    }
    /// Returns the parameters that 1010h (store parameters) stores: all but the received values.
    NaiveEntries parameters() const {
        NaiveEntries all = entries_;
        for (unsigned sub = 1; sub <= 3; ++sub) {
            all.erase({0x2500, sub});
        }
        return all;
    }
    /// Sets the inputs; they apply from the next sample on.
    void feel(const NaiveFelt& felt) { to_feel_ = felt; }
    /// Clears the received values. Called when their RPDO is late.
    void forget_received() { received_.fill(false); }

    /// Advances the clock to `ms`. Takes each sample that is due on the way.
    void run_to(std::uint64_t ms) {
        while (now_ < ms) {
            ++now_;
            const bool samples = now_ % 5U == 0U;
            const bool averages = now_ == next_average_;
            next_average_ += averages ? static_cast<std::uint64_t>(entry(0x2052)) : 0U;
            const bool came_back = samples && sample();
            for (std::size_t i = 0; i < 3 && measures_; ++i) {
                if (entry(0x2050, place(i)) == 0.0 ? samples : averages) {
                    averages_[i].add(angles_[i]);
                }
            }
            if (came_back) {
                restart_filters();
            }
            if (samples) {
                run_functions();
            }
        }
    }

    // The functions below return the values of readable objects. The values are spans (`low` to `high`) of counts
    // before rounding.
    NaiveSpan acceleration_counts(std::size_t axis) const {
        return counts(given_acceleration(axis), entry(0x2010, place(axis)), entry(0x2020, place(axis)));
    }
    NaiveSpan angle_counts(std::size_t angle) const {
        return counts(given_angle(angle), entry(0x2030, place(angle)), entry(0x2040, place(angle)));
    }
    NaiveSpan function_counts(std::size_t function) const {
        return results_[function] ? *results_[function] : naive_point(0.0);
    }
    double latency() const {
        double slowest = 0.0;
        for (unsigned sub = 1; sub <= 3; ++sub) {
            const double constant = entry(0x2051, sub);
            const double periods = entry(0x2050, sub) == 1.0   ? (constant - 1.0) / 2.0
                                   : entry(0x2050, sub) == 2.0 ? (2.0 * constant - 1.0) / 2.0
                                                               : 0.0;
            slowest = std::max(slowest, periods * entry(0x2052));
        }
        const double low_pass = 1000.0 / (2.0 * std::acos(-1.0) * entry(0x2003));
        return slowest + (entry(0x2002) != 0.0 ? low_pass : 0.0);
    }
    int figure_of_merit() const {
        return !measures_ ? 2 : is_too_warm_or_cold() || is_weightless_ || is_roll_unsure_ ? 1 : 0;
    }
    double sensor_temperature() const { return sensor_temperature_; }
    double supply() const { return supply_; }
    double processor_temperature() const { return processor_temperature_; }
    /// The two functions below return whether the errors 4200h (temperature) and FF00h (sensor) are present. They can
    /// begin and end only with a sample.
    bool has_temperature_error() const { return is_too_warm_or_cold(); }
    bool has_sensor_error() const { return !measures_; }

    /// Returns whether a value is so near to a threshold that the device, which computes in single precision, may
    /// decide differently than this model.
    bool is_doubtful() const {
        bool doubt = doubt_;
        for (const NaiveAverage& one : averages_) {
            doubt = doubt || one.is_doubtful();
        }
        for (std::size_t i = 0; i < 2 && unit_.range == 1; ++i) {
            const NaiveAngle& shown = averages_[i].output();
            doubt = doubt || (shown.tolerance != 0.0 && std::fabs(shown.degrees) < 2.0 * shown.tolerance);
        }
        return doubt;
    }

  private:
    static unsigned place(std::size_t i) { return static_cast<unsigned>(i) + 1U; }

    static double default_of(unsigned index) {
        const bool is_scale = index == 0x300B || (index >= 0x3010 && index % 0x10U == 4U);
        const bool is_one = index == 0x2002 || index == 0x2010 || index == 0x2030 || index == 0x2100 || is_scale;
        return is_one                               ? 1.0
               : index == 0x2003                    ? 5.0
               : index == 0x2051 || index == 0x2052 ? 10.0
               : index == 0x2501                    ? 1000.0
               : index == 0x1800                    ? 250.0
                                                    : 0.0;
    }

    NaiveMount installation() const { return {entry(0x2200), entry(0x2210)}; }
    bool is_turned() const { return !installation().is_level() || !unit_.calibration.is_level(); }
    bool is_too_warm_or_cold() const {
        return !(felt_.sensor_temperature >= -40.0 && felt_.sensor_temperature <= 125.0);
    }

    /// Takes a sample of the sensor. Returns whether it is the first valid sample after an error.
    bool sample() {
        felt_ = to_feel_;
        const NaiveVector& a = felt_.acceleration;
        const bool valid = !felt_.fault && std::fabs(a.x) <= 16.0 && std::fabs(a.y) <= 16.0 && std::fabs(a.z) <= 16.0;
        const bool came_back = valid && !measures_;
        if (valid) {
            const NaiveVector sensed = unit_.calibration.out_of(a);
            const bool follows = is_settled_ && entry(0x2002) != 0.0;
            const double left = follows ? std::exp(-2.0 * std::acos(-1.0) * entry(0x2003) * 0.005) : 0.0;
            unit_frame_ = {sensed.x + (unit_frame_.x - sensed.x) * left, sensed.y + (unit_frame_.y - sensed.y) * left,
                           sensed.z + (unit_frame_.z - sensed.z) * left};
            greatest_ = std::max(greatest_, a.length());
        }
        is_settled_ = valid;
        measures_ = valid;
        find_angles();
        note_board();
        return came_back;
    }
    void note_board() {
        if (!std::isnan(felt_.sensor_temperature)) {
            sensor_temperature_ = felt_.sensor_temperature;
        }
        if (felt_.supply >= 0.0 && felt_.supply <= 70.0) {
            supply_ = felt_.supply;
        }
        if (felt_.processor_temperature >= -50.0 && felt_.processor_temperature <= 150.0) {
            processor_temperature_ = felt_.processor_temperature;
        }
    }

    NaiveDirection direction_of(const NaiveVector& of_unit) const {
        return NaiveDirection{installation().out_of(of_unit), error(), is_turned()};
    }
    double error() const { return 4.0e-7 * std::max(1.0, greatest_); }

    void find_angles() {
        if (!measures_) {
            return;
        }
        machine_ = installation().out_of(unit_frame_);
        is_weightless_ = machine_.length() < 0.1;
        doubt_ = doubt_ || std::fabs(machine_.length() - 0.1) < 4.0 * error();
        last_direction_ = is_weightless_ ? last_direction_ : unit_frame_;
        NaiveDirection gravity = direction_of(last_direction_);
        const bool euler = entry(0x2100) == 0.0;
        is_roll_unsure_ = euler && gravity.is_upright(1.0);
        const bool has_no_roll = gravity.is_upright(0.00005);
        last_rolled_ = has_no_roll ? last_rolled_ : last_direction_;
        NaiveDirection rolled = direction_of(last_rolled_);
        if (!euler) {
            angles_ = {gravity.tilt_pitch(), gravity.tilt_roll(), gravity.gravity_angle()};
        } else if (!has_no_roll) {
            angles_ = {gravity.euler_pitch(), gravity.euler_roll(), gravity.gravity_angle()};
        } else {
            const bool none = rolled.is_upright(0.00005);
            angles_ = {gravity.euler_pitch(), none ? NaiveAngle{} : rolled.euler_roll(), gravity.gravity_angle()};
        }
        doubt_ = doubt_ || gravity.is_doubtful() || rolled.is_doubtful();
    }

    /// Performs Auto-Null: the Euler angles of the unit become the initial angles.
    bool null() {
        NaiveDirection unit{unit_frame_, error(), !unit_.calibration.is_level()};
        const bool refused = !measures_ || is_weightless_ || unit.is_upright(1.0);
        if (!refused) {
            entries_[{0x2200, 0}] = unit.euler_pitch().degrees;
            entries_[{0x2210, 0}] = unit.euler_roll().degrees;
            find_angles();
            restart_filters();
        }
        doubt_ = doubt_ || unit.is_doubtful();
        return !refused;
    }

    void restart_filters() {
        for (std::size_t i = 0; i < 3; ++i) {
            restart_filter(i);
        }
        next_average_ = now_ + static_cast<std::uint64_t>(entry(0x2052));
    }
    void restart_filter(std::size_t i) {
        const bool is_euler = entry(0x2100) == 0.0;
        const bool is_circular = i == 1 || (i == 0 && !is_euler);
        averages_[i].restart(static_cast<int>(entry(0x2050, place(i))), static_cast<int>(entry(0x2051, place(i))),
                             is_circular);
        if (measures_) {
            averages_[i].add(angles_[i]);
        }
    }

    static NaiveSpan between(double value, double tolerance) { return {value - tolerance, value + tolerance}; }
    static NaiveSpan turned_if(bool turned, const NaiveSpan& span) {
        return turned ? NaiveSpan{-span.high, -span.low} : span;
    }
    static NaiveSpan counts(const NaiveSpan& value, double digits, double offset) {
        const double width = std::fabs(offset) * 1.0e-7 + std::fabs(value.high * digits) * 2.0e-7;
        return {value.low * digits + offset - width, value.high * digits + offset + width};
    }
    NaiveSpan given_acceleration(std::size_t axis) const {
        const double value = axis == 0 ? machine_.x : axis == 1 ? machine_.y : machine_.z;
        const bool is_exact = entry(0x2002) == 0.0 && !is_turned();
        return turned_if(entry(0x2011, place(axis)) != 0.0, between(value, is_exact ? 0.0 : 2.0 * error()));
    }
    NaiveSpan given_angle(std::size_t angle) const {
        const NaiveAngle& out = averages_[angle].output();
        double value = out.degrees;
        if (angle < 2 && unit_.range == 1) {
            value += value < 0.0 ? 360.0 : 0.0;
        } else if (angle < 2 && unit_.range == 2) {
            value = std::fabs(value) > 90.0 ? 180.0 - std::fabs(value) : std::fabs(value);
        }
        NaiveSpan span = between(value, out.tolerance);
        span.low = angle < 2 && unit_.range == 2 ? std::max(span.low, 0.0) : span.low;
        return turned_if(entry(0x2031, place(angle)) != 0.0, span);
    }

    void run_functions() {
        for (unsigned n = 0; n < 10; ++n) {
            const unsigned at = 0x3010 + 0x10U * n;
            std::array<NaiveFunction::Input, 2> inputs;
            for (unsigned i = 0; i < 2; ++i) {
                const unsigned sub = i + 1U;
                inputs[i] = {
                    signal(static_cast<unsigned>(entry(at, sub))), entry(at + 1U, sub) != 0.0, entry(at + 2U, sub),
                    static_cast<int>(entry(at + 3U, sub)),         entry(at + 4U, sub),        entry(at + 5U, sub)};
            }
            NaiveFunction function;
            const unsigned sub = n + 1U;
            results_[n] =
                function.result(inputs, static_cast<int>(entry(0x300A, sub)), entry(0x300B, sub), entry(0x300C, sub));
            doubt_ = doubt_ || function.unknown();
        }
    }
    /// Returns the signal of a source of Table 1.
    NaiveSignal signal(unsigned source) const {
        const auto if_measured = [this](const NaiveSpan& span) { return measures_ ? NaiveSignal{span} : std::nullopt; };
        if (source >= 1 && source <= 3) {
            return if_measured(given_acceleration(source - 1U));
        }
        if (source >= 5 && source <= 7) {
            return if_measured(given_angle(source - 5U));
        }
        if (source >= 10 && source <= 19) {
            return results_[source - 10U];
        }
        if (source >= 20 && source <= 22) {
            return received(source - 19U);
        }
        switch (source) {
            case 4:
                return std::isnan(felt_.sensor_temperature) ? NaiveSignal{} : naive_point(felt_.sensor_temperature);
            case 8:
                return naive_rounded(latency());
            case 9:
                return naive_point(figure_of_merit());
            case 23:
                return naive_point(static_cast<double>(static_cast<float>(entry(0x4080))));
            case 24:
                return naive_point(entry(0x4070));
            case 25:
            case 26:
                return naive_point(source - 25.0);
            case 27:
                return naive_point(supply_);
            case 28:
                return naive_point(processor_temperature_);
            default:
                return std::nullopt;
        }
    }
    NaiveSignal received(unsigned sub) const {
        if (!received_[sub - 1U]) {
            return std::nullopt;
        }
        const double counts_of_one = 1000.0 / entry(0x2501, sub);
        return naive_rounded((entry(0x2500, sub) + entry(0x2502, sub)) / counts_of_one);
    }

    NaiveUnit unit_;
    NaiveFelt to_feel_;
    NaiveFelt felt_;
    NaiveEntries entries_;
    std::uint64_t now_{0};
    std::uint64_t next_average_{0};
    bool measures_{false};
    bool is_settled_{false};  ///< whether the input filter has a previous value
    NaiveVector unit_frame_{0.0, 0.0, 0.0};
    NaiveVector machine_{0.0, 0.0, 0.0};
    NaiveVector last_direction_{0.0, 0.0, 0.0};
    NaiveVector last_rolled_{0.0, 0.0, 0.0};
    double greatest_{0.0};
    bool is_weightless_{false};
    bool is_roll_unsure_{false};
    std::array<NaiveAngle, 3> angles_{};
    std::array<NaiveAverage, 3> averages_{};
    std::array<NaiveSignal, 10> results_{};
    std::array<bool, 3> received_{};
    double sensor_temperature_{0.0};
    double supply_{0.0};
    double processor_temperature_{0.0};
    bool doubt_{false};
};

}  // namespace canproof::test
