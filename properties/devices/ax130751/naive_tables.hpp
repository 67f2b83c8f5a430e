// SPDX-License-Identifier: Apache-2.0
// Naive lookup tables, logic and math blocks of the AX130751 (manual, 1.5 to 1.7), written from the sentences of the
// manual and not from generated tables.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "properties/devices/ax130751/naive_sources.hpp"

namespace canproof::naive_ax130751 {

inline bool is_over_time(const Table& table) {
    return table.response.at(0) == 1;
}

/// Returns Y of a point. In a time profile, Y of point 1 counts as 0, whatever value was written (section 1.5.4).
inline double y_of(const Table& table, std::size_t point) {
    return point == 0 && is_over_time(table) ? 0.0 : physical(table.y.at(point), table.y_digits);
}

/// Evaluates a table by the steps of section 1.5.3. `xs` are the X values of its points, in ascending order.
inline double y_at(double x, const std::array<double, 11>& xs, const Table& table) {
    std::size_t reached = 0;
    while (x > xs.at(reached)) {
        const std::size_t next = reached + 1;
        if (next == 11 || table.response.at(next) == 0) {
            return y_of(table, reached);
        }
        if (x <= xs.at(next)) {
            const double from = y_of(table, reached);
            const double to = y_of(table, next);
            const double ramp = from + (x - xs.at(reached)) * (to - from) / (xs.at(next) - xs.at(reached));
            return table.response.at(next) == 2 || x >= xs.at(next) ? to : ramp;
        }
        reached = next;
    }
    return y_of(table, reached);
}

/// One lookup table.
class NaiveTable {
  public:
    /// Evaluates the table `now` milliseconds after power-on.
    void cycle(const Table& table, const Signal& input, std::uint64_t now, Shown::OfTable& shown) {
        shown.state = input.state;
        if (input.unused()) {
            *this = NaiveTable{};
            shown.output = 0;
            return;
        }
        if (is_over_time(table)) {
            value_ = profile(table, input, now);
        } else {
            start_ = Reading{};
            runs_ = false;
            value_ = input.fine() ? y_at(input.value, xs_of(table), table) : value_;
        }
        shown.output = to_integer(value_, table.y_digits);
        limits(table, shown);
    }

  private:
    static std::array<double, 11> xs_of(const Table& table) {
        std::array<double, 11> xs{};
        std::transform(table.x.begin(), table.x.end(), xs.begin(), [&](int x) { return physical(x, table.x_digits); });
        return xs;
    }
    /// Evaluates a time profile, in which each X is an interval in milliseconds (section 1.5.4).
    double profile(const Table& table, const Signal& input, std::uint64_t now) {
        const bool on = start_.follow(input) && input.fine();
        if (!on) {
            runs_ = false;
            return 0.0;
        }
        if (!runs_) {
            runs_ = true;
            since_ = now;
        }
        std::array<double, 11> xs{};
        double length = 0.0;
        bool counts = true;
        for (std::size_t point = 1; point < 11; ++point) {
            xs.at(point) = xs.at(point - 1) + 1000.0 * std::clamp(table.x.at(point), 1, 86'400'000);
            counts = counts && table.response.at(point) != 0;
            length = counts ? xs.at(point) : length;
        }
        double at = 1000.0 * static_cast<double>(now - since_);  // the time since the start of the profile in µs, in
                                                                 // which the device counts
        while (table.repeat != 0 && length > 0.0 && at > length) {
            at -= length;
        }
        return y_at(at, xs, table);
    }
    /// Computes the limits of the output for other blocks: the least and greatest Y, or 0 and 100 (section 1.5.2).
    static void limits(const Table& table, Shown::OfTable& shown) {
        shown.least = y_of(table, 0);
        shown.greatest = y_of(table, 0);
        for (std::size_t point = 1; point < 11; ++point) {
            shown.least = std::min(shown.least, y_of(table, point));
            shown.greatest = std::max(shown.greatest, y_of(table, point));
        }
        if (shown.least >= 0.0 && shown.greatest <= 100.0) {
            shown.least = 0.0;
            shown.greatest = 100.0;
        }
    }

    Reading start_;
    double value_{0.0};
    bool runs_{false};
    std::uint64_t since_{0};
};

/// Evaluates one logic block, which keeps no state between cycles (section 1.6). `sources` has the present results of
/// other blocks. Lookup tables and logic blocks with a lower number have results of this cycle, other blocks those of
/// the last cycle.
inline Shown::OfLogic evaluate(const Logic& logic, const Sources& sources) {
    Shown::OfLogic shown;
    if (logic.enable == 0) {
        return shown;
    }
    std::array<naive_blocks::Function, 3> functions;
    for (std::size_t f = 0; f < 3; ++f) {
        functions.at(f).logical = logic.operators.at(f);
        for (std::size_t c = 0; c < 3; ++c) {
            const ConditionChoice& choice = logic.conditions.at(f).at(c);
            const Signal one = sources.read(choice.one);
            const Signal other = sources.read(choice.other);
            functions.at(f).conditions.at(c) = {{one.value, one.state}, {other.value, other.state}, choice.comparison};
        }
    }
    shown.selected = logic.tables.at(naive_blocks::selected(functions));
    const Signal table = sources.table(shown.selected);
    shown.state = table.state;
    if (!table.unused() && table.upper > table.lower) {
        const double share = (table.value - table.lower) * 100.0 / (table.upper - table.lower);
        shown.output = to_integer(std::clamp(share, 0.0, 100.0), 1);
    }
    return shown;
}

/// One math block (section 1.7).
class NaiveMath {
  public:
    /// Evaluates math block `number` (1 to 4).
    int cycle(int number, const MathBlock& block, const Sources& sources) {
        if (block.enable == 0) {
            math_ = naive_blocks::Math{};
            return 0;
        }
        std::array<naive_blocks::Input, 4> inputs;
        for (std::size_t i = 0; i < 4; ++i) {
            const MathChoice& choice = block.inputs.at(i);
            const Signal signal = sources.read(choice.source);
            const bool own = choice.source.source == 4 && choice.source.number == number;
            inputs.at(i) = {in_ten_thousandths(signal.value),
                            signal.state,
                            in_ten_thousandths(physical(choice.scaling_1, choice.digits)),
                            in_ten_thousandths(physical(choice.scaling_2, choice.digits)),
                            choice.gain,
                            own ? choice.function : 0};
        }
        const bool does_nothing = inputs.at(0).state == State::unused || inputs.at(1).state == State::unused;
        const double result = std::clamp(math_.cycle(inputs, block.operators), 0.0, 1.0);
        const double one = physical(block.pv_1, block.digits);
        const double other = physical(block.pv_2, block.digits);
        return does_nothing ? 0 : to_integer(one + result * (other - one), block.digits);
    }

  private:
    /// Returns `value` in ten-thousandths, rounded. That is exact, because no value has more than four decimal digits.
    static int in_ten_thousandths(double value) { return static_cast<int>(std::lround(value * 1.0e4)); }

    naive_blocks::Math math_;
};

}  // namespace canproof::naive_ax130751
