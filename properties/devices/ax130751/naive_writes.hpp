// SPDX-License-Identifier: Apache-2.0
// Naive rules and effects of writes to parameters of the AX130751 (manual, 1.3, 1.5.1, 1.5.4, 1.8, 3.3.5, 3.3.9 to
// 3.3.14, 3.4.44), written from the sentences of the manual and not from generated tables.
#pragma once

#include <algorithm>
#include <cmath>

#include "properties/devices/ax130751/naive_outputs.hpp"
#include "properties/devices/ax130751/naive_tables.hpp"

namespace canproof::naive_ax130751 {

constexpr std::uint32_t too_high = 0x06090031;
constexpr std::uint32_t too_low = 0x06090032;

inline std::uint32_t within(double value, double least, double greatest) {
    return value > greatest ? too_high : value < least ? too_low : 0;
}

/// Returns the number of the lookup table that has an object with this `index`, or 0.
inline int table_of(int index) {
    const int number = index >= 0x3100 && index <= 0x3108   ? 10
                       : index >= 0x3010 && index <= 0x3098 ? index / 0x10 % 0x10
                                                            : 0;
    return number;
}

/// Returns the abort code for a new X of a point of a lookup table, or 0 when X is allowed (sections 1.5.1, 1.5.4,
/// 3.4.44).
inline std::uint32_t refusal_of_point(const Table& table, const Sources& sources, int point, int x) {
    if (is_over_time(table)) {
        return point == 1 ? within(x, 0, 0) : within(x, 1, 86'400'000);
    }
    const auto at = static_cast<std::size_t>(point - 1);
    const int least = point == 1 ? -32768 : std::max(-32768, table.x.at(at - 1));
    const int greatest = point == 11 ? 32767 : std::min(32767, table.x.at(at + 1));
    const std::uint32_t by_order = within(x, least, greatest);
    const Signal source = sources.read(table.source);
    if (by_order != 0 || source.unused() || source.lower >= source.upper) {
        return by_order;
    }
    return within(physical(x, table.x_digits), source.lower, source.upper);
}

/// Returns 0 if a field value is OFF (0) or within the range of the output type, else the abort code. An output without
/// a type accepts every value.
inline std::uint32_t refusal_of_field_value(const Output& output, int value) {
    const double volts = physical(value, output.fv_digits);
    if (value == 0) {
        return 0;
    }
    switch (output.type) {
        case 0:
            return 0;
        case 10:
            return within(volts, -10, 10);
        case 20:
            return within(volts, 0, 24);
        case 40:
            return within(volts, 0, 100);
        case 500:
            return within(volts, 50, 30000);
        default:
            return within(volts, 0, 1);
    }
}

/// Returns the abort code of a write, or 0 when the write is accepted. The caller passes only values within the range
/// that the manual prints for the entry. This function checks all other rules.
inline std::uint32_t refusal_of(const Parameters& all, const Entries& entries, const Sources& sources,
                                const Address& address, int value) {
    const auto [index, sub] = address;
    const auto other = [&entries, at = sub](int of) { return *entries.at({of, at}).value; };
    switch (index) {
        case 0x7320:
            return value >= other(0x7322) ? too_high : 0;
        case 0x7322:
            return value <= other(0x7320) ? too_low : 0;
        case 0x2520:
            return value > other(0x2522) ? too_high : 0;
        case 0x2522:
            return value < other(0x2520) ? too_low : 0;
        case 0x5022:
            return value > other(0x5023) ? too_high : 0;
        case 0x5023:
            return value < other(0x5022) ? too_low : 0;
        case 0x2300:
        case 0x7321:
        case 0x7323:
        case 0x7341:
            return refusal_of_field_value(all.outputs.at(static_cast<std::size_t>(sub - 1)), value);
        default:
            break;
    }
    const int table = table_of(index);
    return table != 0 && index % 0x10 == 6
               ? refusal_of_point(all.tables.at(static_cast<std::size_t>(table - 1)), sources, sub, value)
               : 0;
}

/// Sets an output to the defaults of its type (sections 1.3, 1.8): the scaling of Table 3 and of the object pages, and
/// OFF as override value and fault value.
inline void take_type_defaults(Output& output) {
    const auto set = [&output](int digits, int one, int two) {
        output.pv_digits = digits;
        output.fv_digits = digits;
        output.pv_1 = one;
        output.fv_1 = one;
        output.pv_2 = two;
        output.fv_2 = two;
        output.override_value = 0;
        output.fault_value = 0;
    };
    switch (output.type) {
        case 10:
            return set(3, 0, 5000);
        case 20:
            return set(3, 0, 20000);
        case 40:
            return set(1, 0, 1000);
        case 500:
            return set(0, 50, 30000);
        case 1000:
        case 1020:
            return set(0, 0, 1);
        default:
            return;
    }
}

/// Applies the effects of an accepted write on other entries. FirstPoints applies those on point 1 of lookup tables.
inline void follow_write(Parameters& all, const Address& address, int before) {
    const auto [index, sub] = address;
    const int number = table_of(index);
    if (index == 0x6310) {
        Output& output = all.outputs.at(static_cast<std::size_t>(sub - 1));
        if (output.type != before && all.diagnostics.updates != 0) {
            take_type_defaults(output);
        }
    } else if (number != 0 && index % 0x10 == 5 && sub == 1) {
        Table& table = all.tables.at(static_cast<std::size_t>(number - 1));
        if (is_over_time(table)) {
            table.x[0] = 0;
            table.y[0] = 0;
            table.x_digits = 0;
        }
    }
}

/// While the minimum of a lookup table's source is below 0 and the table has data response, keeps X of point 1 at this
/// minimum (section 1.5.1).
class FirstPoints {
  public:
    void begin(const Parameters& all) {
        const Shown nothing;
        const Network network;
        const Sources sources{all, nothing, network};
        for (std::size_t n = 0; n < 10; ++n) {
            put_.at(n) = place(all, all.tables.at(n), sources);
        }
    }
    /// Updates X of point 1 of all tables after a write to any entry.
    void follow(Parameters& all, const Sources& sources) {
        for (std::size_t n = 0; n < 10; ++n) {
            Table& table = all.tables.at(n);
            const int wanted = place(all, table, sources);
            if (table.x[0] != put_.at(n)) {
                put_.at(n) = wanted;  // a client has written X of this point
            } else if (wanted <= table.x[1]) {
                table.x[0] = wanted;
                put_.at(n) = wanted;
            }
        }
    }

  private:
    static int place(const Parameters& all, const Table& table, const Sources& sources) {
        const int of = table.source.source == 3 ? table.source.number : 0;
        double minimum = 0.0;
        if (of >= 1 && of <= 10) {
            const Table& other = all.tables.at(static_cast<std::size_t>(of - 1));
            minimum = y_of(other, 0);
            for (std::size_t point = 1; point < 11; ++point) {
                minimum = std::min(minimum, y_of(other, point));
            }
        } else {
            minimum = sources.read(table.source).lower;
        }
        if (is_over_time(table) || minimum >= 0.0) {
            return 0;
        }
        const int nearest = to_integer(minimum, table.x_digits);
        return physical(nearest, table.x_digits) < minimum ? nearest + 1 : nearest;
    }

    std::array<int, 10> put_{};
};

}  // namespace canproof::naive_ax130751
