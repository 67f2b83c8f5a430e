// SPDX-License-Identifier: Apache-2.0
// Naive universal outputs of the AX130751 (manual, 1.2 and 1.3), written from the sentences of the manual and not from
// generated tables.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "properties/devices/ax130751/naive_sources.hpp"

namespace canproof::naive_ax130751 {

/// The signals at the terminals of one output.
struct Terminals {
    double volts{0.0};
    double milliamperes{0.0};
    double duty{0.0};
    double hertz{0.0};
    double level{0.0};
    bool on{false};
};

/// Conditions of one cycle that apply to all outputs.
struct Circumstances {
    bool shutdown{false};  ///< a diagnostic fault, or the node is not operational
    bool powered{true};    ///< the supply is from 7 V to 39 V
    std::uint64_t now{0};  ///< ms since power-on
};

/// The reasons that can determine the state of an output (sections 1.2, 1.3). An earlier one has priority over later
/// ones.
enum class Decision { off, forced, ramp_off, keep, fault, control };

/// A ramp with constant speed. It crosses the whole span of the output in the ramp time for its direction (up or down).
class NaiveRamp {
  public:
    void jump(double value) {
        from_ = value;
        to_ = value;
    }
    void go(double target, double span, int up, int down, std::uint64_t now) {
        const bool same = !differ(target, to_) && !differ(span, span_) && up == up_ && down == down_;
        if (!same) {
            from_ = at(now);
            to_ = target;
            since_ = now;
            span_ = span;
            up_ = up;
            down_ = down;
        }
    }
    double at(std::uint64_t now) const {
        const double distance = to_ - from_;
        const int time = distance > 0.0 ? up_ : down_;
        if (time == 0 || span_ <= 0.0) {
            return to_;
        }
        const double gone = span_ * static_cast<double>((now - since_) * 1000) / (time * 1000.0);
        if (gone >= std::fabs(distance)) {
            return to_;
        }
        return distance > 0.0 ? from_ + gone : from_ - gone;
    }

  private:
    static bool differ(double a, double b) { return a < b || a > b; }

    double from_{0.0};
    double to_{0.0};
    double span_{0.0};
    int up_{0};
    int down_{0};
    std::uint64_t since_{0};
};

/// Clamps a value to the range of an output type; a frequency is 0 or at least 50 Hz (Table 3, section 3.3.10).
inline double in_range(int type, double value) {
    switch (type) {
        case 10:
            return std::clamp(value, -10.0, 10.0);
        case 20:
            return std::clamp(value, 0.0, 24.0);
        case 40:
            return std::clamp(value, 0.0, 100.0);
        case 500:
            return value <= 0.0 ? 0.0 : std::clamp(value, 50.0, 30000.0);
        default:
            return 0.0;
    }
}

class NaiveOutput {
  public:
    /// Evaluates the output at position `at`, 0 or 1. Sets 7330h (AO Output Field Value), 2370h (AO Feedback Field
    /// Value) and the signals at the terminals of this output.
    void cycle(std::size_t at, const Output& output, const Sources& sources, const Circumstances& now, double load,
               Shown& shown, Terminals& terminals) {
        if (output.type != type_) {
            reset(output.type);
            shown.target.at(at) = 0;
            shown.feedback.at(at) = 0;
        }
        const Signal control = sources.read(output.control);
        const Signal enable = sources.read(output.enable);
        const Signal forced = sources.read(output.override_input);
        control_.follow(control);
        enable_.follow(enable);
        override_.follow(forced);
        terminals = Terminals{};
        const bool has_lack = sources.lacks(output.enable, enable) || sources.lacks(output.override_input, forced);
        const Decision decision = decide(output, control, enable, forced, now.shutdown || has_lack);
        if (is_digital(output)) {
            if (!was_fine_) {
                before_ = control_.on();  // a change while the control was in error or absent does not count
            }
            was_fine_ = control.fine();
            switch_by(decision, output, now.now);
            terminals.on = drive_;
            terminals.level = output.range == 1 ? 12.0 : 5.0;
            terminals.volts = drive_ ? terminals.level : 0.0;
            shown.target.at(at) = logic_ ? 1 : 0;
            shown.feedback.at(at) = drive_ ? 1 : 0;
            return;
        }
        const double target = move_by(decision, output, control, now.now);
        const double value = at_terminals(output, in_range(output.type, ramp_.at(now.now)), load);
        shown.target.at(at) = to_integer(target, output.fv_digits);
        shown.feedback.at(at) = to_integer(value, output.fv_digits);
        drive(output, value, terminals);
    }
    void reset(int type) {
        *this = NaiveOutput{};
        type_ = type;
    }

  private:
    Decision decide(const Output& output, const Signal& control, const Signal& enable, const Signal& forced,
                    bool shutdown) const {
        if (shutdown) {
            return Decision::off;
        }
        const bool overrides_when_on = output.override_response == 0;
        if (forced.fine() && override_.on() == overrides_when_on) {
            return Decision::forced;
        }
        const bool enables_when_on = output.enable_response < 3;
        if (enable.fine() && enable_.on() != enables_when_on) {
            switch (output.enable_response % 3) {
                case 0:
                    return Decision::off;
                case 1:
                    return Decision::ramp_off;
                default:
                    return Decision::keep;
            }
        }
        if (control.error() || enable.error() || forced.error()) {
            const int mode = is_digital(output) ? output.digital_fault_mode : output.fault_mode;
            return mode == 0 ? Decision::keep : Decision::fault;
        }
        return control.unused() ? Decision::off : Decision::control;
    }

    /// Applies the profile of Figure 3 to the control signal. Returns a value in the unit of the output.
    static double profile(const Output& output, const Signal& control) {
        const double x1 = physical(output.pv_1, output.pv_digits);
        const double x2 = physical(output.pv_2, output.pv_digits);
        const double y1 = physical(output.fv_1, output.fv_digits);
        const double y2 = physical(output.fv_2, output.fv_digits);
        const double x = control.value;
        if ((output.control_response == 1 && x < x1) || (output.control_response == 2 && x > x2)) {
            return 0.0;
        }
        if (x <= x1) {
            return y1;
        }
        return x >= x2 ? y2 : y1 + (x - x1) * (y2 - y1) / (x2 - x1);
    }

    /// Moves the ramp as `decision` requires. Returns the target of the ramp.
    double move_by(Decision decision, const Output& output, const Signal& control, std::uint64_t now) {
        const double span =
            std::fabs(physical(output.fv_2, output.fv_digits) - physical(output.fv_1, output.fv_digits));
        double target = 0.0;
        switch (decision) {
            case Decision::control:
                target = in_range(output.type, profile(output, control));
                ramp_.go(target, span, output.ramp_up, output.ramp_down, now);
                return target;
            case Decision::ramp_off:
                ramp_.go(0.0, span, output.ramp_up, output.ramp_down, now);
                return 0.0;
            case Decision::keep:
                ramp_.jump(ramp_.at(now));
                return in_range(output.type, ramp_.at(now));
            case Decision::forced:
                target = in_range(output.type, physical(output.override_value, output.fv_digits));
                break;
            case Decision::fault:
                target = in_range(output.type, physical(output.fault_value, output.fv_digits));
                break;
            default:
                break;
        }
        ramp_.jump(target);
        return target;
    }

    /// Returns the value that appears at the terminals. A current is at most what 14 V drive through the load. A duty
    /// cycle is 0 when the frequency is 0.
    static double at_terminals(const Output& output, double value, double load) {
        if (output.type == 20 && load * value > 14000.0) {
            return 14000.0 / load;
        }
        return output.type == 40 && output.frequency == 0 ? 0.0 : value;
    }

    static void drive(const Output& output, double value, Terminals& terminals) {
        const double level = output.range == 1 ? 12.0 : 5.0;
        if (output.type == 10) {
            terminals.volts = value;
        } else if (output.type == 20) {
            terminals.milliamperes = value;
        } else if (output.type == 40) {
            terminals.duty = value;
            terminals.hertz = output.frequency;
            terminals.level = level;
        } else if (output.type == 500) {
            terminals.duty = value > 0.0 ? 50.0 : 0.0;
            terminals.hertz = value;
            terminals.level = level;
        }
    }

    /// Computes the logic state and the drive state of a digital output (section 1.2).
    void switch_by(Decision decision, const Output& output, std::uint64_t now) {
        const bool control = control_.on();
        switch (decision) {
            case Decision::control:
                follow(output, control, now);
                logic_ = control;
                drive_ = memory_;
                break;
            case Decision::keep:
                break;
            case Decision::forced:
                logic_ = output.override_value != 0;
                drive_ = logic_;
                break;
            case Decision::fault:
                logic_ = output.fault_state != 0;
                drive_ = logic_;
                break;
            default:
                logic_ = false;
                drive_ = false;
                break;
        }
        blinks_ = blinks_ && decision == Decision::control;
        before_ = control;
    }

    /// Computes the drive state of a digital output from its control input and its polarity (Table 1).
    void follow(const Output& output, bool control, std::uint64_t now) {
        const bool blinks = output.polarity == 3 && control;
        if (blinks && !blinks_) {
            since_ = now;
        }
        blinks_ = blinks;
        if (output.polarity == 2) {
            memory_ = memory_ != (control && !before_);
        } else if (blinks) {
            const auto half = static_cast<std::uint64_t>(output.blink);
            memory_ = half == 0 || (now - since_) / half % 2 == 0;
        } else {
            memory_ = output.polarity == 1 ? !control : control;
        }
    }

    int type_{0};
    Reading control_;
    Reading enable_;
    Reading override_;
    NaiveRamp ramp_;
    bool logic_{false};
    bool drive_{false};
    bool memory_{false};  ///< drive state after the last cycle in which the control input determined it
    bool before_{false};
    bool was_fine_{true};  ///< the control had a value, and was not in error, in the last cycle
    bool blinks_{false};
    std::uint64_t since_{0};
};

}  // namespace canproof::naive_ax130751
