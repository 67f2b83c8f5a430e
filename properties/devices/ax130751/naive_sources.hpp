// SPDX-License-Identifier: Apache-2.0
// Naive control sources of the AX130751 with their values, limits and states (manual, 1.3, Tables 4A, 4B and 5),
// written from the sentences of the manual and not from generated tables. Values are in their physical unit.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "properties/devices/ax130751/naive_blocks.hpp"
#include "properties/devices/ax130751/naive_parameters.hpp"

namespace canproof::naive_ax130751 {

using naive_blocks::State;

/// A signal that one block gives to another: its value, the limits of this value, and its state.
struct Signal {
    double value{0.0};
    double lower{0.0};
    double upper{0.0};
    State state{State::unused};

    bool fine() const { return state == State::fine; }
    bool error() const { return state == State::error; }
    bool unused() const { return state == State::unused; }
};

inline double power_of_ten(int digits) {
    double power = 1.0;
    for (int i = 0; i < digits; ++i) {
        power *= 10.0;
    }
    return power;
}

/// Converts an integer to its physical value: 1234 with two digits is 12.34.
inline double physical(int integer, int digits) {
    return integer / power_of_ten(digits);
}

/// Converts a value to the nearest 16-bit integer with `digits` decimal digits. Halves are rounded away from zero.
inline int to_integer(double value, int digits) {
    return static_cast<int>(std::lround(std::clamp(value * power_of_ten(digits), -32768.0, 32767.0)));
}

/// The results of the latest evaluation of the blocks.
struct Shown {
    struct OfTable {
        int output{0};  ///< 3yz8h (Output Y-Axis PV) of table yz (01 to 10)
        State state{State::unused};
        double least{0.0};  ///< lower limit of the output for the blocks that read it
        double greatest{0.0};
    };
    struct OfLogic {
        int selected{0};  ///< 3310h (Logic Block Selected Table)
        int output{0};    ///< 3320h (Logic Block Output PV)
        State state{State::unused};
    };
    std::array<OfTable, 10> tables;
    std::array<OfLogic, 3> logic;
    std::array<int, 4> math{};      ///< 4030h (Math Output Process Value)
    std::array<int, 2> target{};    ///< 7330h (AO Output Field Value)
    std::array<int, 2> feedback{};  ///< 2370h (AO Feedback Field Value)
    float supply{0.0F};             ///< 5020h (Power Supply Field Value)
    float temperature{0.0F};        ///< 5030h (Processor Temperature Field Value)
};

/// Faults of reception.
struct Network {
    std::array<bool, 4> overdue{};  ///< for RPDO1 to RPDO4, whether the RPDO is overdue
    bool silent{false};             ///< whether a heartbeat of a monitored node is missing or life guarding has failed
};

inline bool is_digital(const Output& output) {
    return output.type == 1000 || output.type == 1020;
}

class Sources {
  public:
    Sources(const Parameters& parameters, const Shown& shown, const Network& network)
        : parameters_{parameters}, shown_{shown}, network_{network} {}

    Signal read(const Choice& choice) const {
        const int n = choice.number;
        const auto at = static_cast<std::size_t>(n - 1);
        switch (choice.source) {
            case 1:
                return n >= 1 && n <= 9 ? message(n) : Signal{};
            case 2:
                return n == 1 ? write_state(3) : Signal{};
            case 3:
                return n >= 1 && n <= 10 ? table(n) : Signal{};
            case 4:
                return n >= 1 && n <= 4 ? math(at) : Signal{};
            case 5:
                return n >= 1 && n <= 3
                           ? Signal{shown_.logic.at(at).output / 10.0, 0.0, 100.0, shown_.logic.at(at).state}
                           : Signal{};
            case 6:
                return n == 1 || n == 2 ? field_value(at, shown_.target.at(at)) : Signal{};
            case 7:
                return n == 1 || n == 2 ? field_value(at, shown_.feedback.at(at)) : Signal{};
            case 8:
                return ordered(tenths(shown_.supply), parameters_.diagnostics.under, parameters_.diagnostics.over,
                               measured(shown_.supply));
            case 9:
                return ordered(tenths(shown_.temperature),
                               parameters_.diagnostics.hot - parameters_.diagnostics.heat_hysteresis,
                               parameters_.diagnostics.hot, measured(shown_.temperature));
            default:
                return Signal{};
        }
    }
    /// Returns whether an enable, override or unlatch input has a source that gives no value. A math block that is off
    /// gives none.
    bool lacks(const Choice& choice, const Signal& signal) const {
        const bool is_math = choice.source == 4 && choice.number >= 1 && choice.number <= 4;
        const bool is_off = is_math && parameters_.math.at(static_cast<std::size_t>(choice.number - 1)).enable == 0;
        return choice.source != 0 && (signal.unused() || is_off);
    }
    /// Returns the output of lookup table `number` (1 to 10), as other blocks read it.
    Signal table(int number) const {
        const auto at = static_cast<std::size_t>(number - 1);
        const Shown::OfTable& shown = shown_.tables.at(at);
        return {physical(shown.output, parameters_.tables.at(at).y_digits), shown.least, shown.greatest, shown.state};
    }

  private:
    static double tenths(float measured) {
        return std::isnan(measured) ? 0.0 : std::round(static_cast<double>(measured) * 10.0) / 10.0;
    }
    /// A value that cannot be measured is in error.
    static State measured(float value) { return std::isnan(value) ? State::error : State::fine; }
    static Signal ordered(double value, double one, double other, State state) {
        return {value, std::min(one, other), std::max(one, other), state};
    }
    State reception(int rpdo) const {
        return network_.silent || network_.overdue.at(static_cast<std::size_t>(rpdo - 1)) ? State::error : State::fine;
    }
    /// Returns the state in 6220h:`number` (DO Write State 1 Output Line). RPDO4 sets 6220h:1 and 6220h:2 (outputs),
    /// RPDO1 sets 6220h:3 (relay).
    Signal write_state(int number) const {
        const int written = parameters_.write_states.at(static_cast<std::size_t>(number - 1));
        return {written != 0 ? 1.0 : 0.0, 0.0, 1.0, reception(number == 3 ? 1 : 4)};
    }
    /// Returns received value `number`: 1 and 2 are commands of the outputs, 3 is the command of the relay, 4 to 9 are
    /// the extra received values, which RPDO2 and RPDO3 set.
    Signal message(int number) const {
        if (number == 3) {
            return write_state(3);
        }
        if (number < 3) {
            const Output& output = parameters_.outputs.at(static_cast<std::size_t>(number - 1));
            if (is_digital(output)) {
                return write_state(number);
            }
            const int digits = output.pv_digits;
            return ordered(physical(output.command, digits), physical(output.pv_1, digits),
                           physical(output.pv_2, digits), reception(1));
        }
        const Extra& extra = parameters_.extras.at(static_cast<std::size_t>(number - 4));
        return ordered(physical(extra.value, extra.digits), physical(extra.pv_1, extra.digits),
                       physical(extra.pv_2, extra.digits), reception(number < 7 ? 2 : 3));
    }
    Signal math(std::size_t at) const {
        const MathBlock& block = parameters_.math.at(at);
        return ordered(physical(shown_.math.at(at), block.digits), physical(block.pv_1, block.digits),
                       physical(block.pv_2, block.digits), State::fine);
    }
    /// Returns `integer`, the value of 7330h (AO Output Field Value) or 2370h (AO Feedback Field Value), as a signal.
    /// The signal of a digital output is 0 or 1.
    Signal field_value(std::size_t at, int integer) const {
        const Output& output = parameters_.outputs.at(at);
        if (is_digital(output)) {
            return {static_cast<double>(integer), 0.0, 1.0, State::fine};
        }
        const int digits = output.fv_digits;
        return ordered(physical(integer, digits), physical(output.fv_1, digits), physical(output.fv_2, digits),
                       State::fine);
    }

    const Parameters& parameters_;
    const Shown& shown_;
    const Network& network_;
};

/// A signal read as ON or OFF, with hysteresis between its limits (section 1.2).
class Reading {
  public:
    bool follow(const Signal& signal) {
        if (signal.unused()) {
            on_ = false;
        } else if (signal.fine() && signal.value <= signal.lower) {
            on_ = false;
        } else if (signal.fine() && signal.value >= signal.upper) {
            on_ = true;
        }
        return on_;
    }
    bool on() const { return on_; }

  private:
    bool on_{false};
};

}  // namespace canproof::naive_ax130751
