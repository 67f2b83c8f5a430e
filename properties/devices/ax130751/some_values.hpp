// SPDX-License-Identifier: Apache-2.0
// Values for the parameters of an AX130751. Each parameter has only a few possible values, so that equal values and
// values at a limit occur often.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <vector>

#include "properties/devices/ax130751/naive_parameters.hpp"

namespace canproof::test {

using naive_ax130751::Address;

/// Draws a value of `gen` with the same distribution in every test case. Without resize(), RapidCheck begins with small
/// values.
template <typename T>
T draw(const rc::Gen<T>& gen) {
    return *rc::gen::resize(rc::kNominalSize, gen);
}

inline int one_of(const std::vector<int>& values) {
    return draw(rc::gen::elementOf(values));
}

enum class Group { output, relay, extra, table, logic, math, diagnostics, none };

inline Group group_of(int index) {
    const std::vector<int> of_relay{0x2242, 0x2250, 0x2260, 0x2261, 0x2270, 0x2271, 0x2280, 0x2281,
                                    0x2282, 0x2290, 0x2291, 0x2292, 0x2293, 0x22A0, 0x22A1, 0x22A2};
    if (std::find(of_relay.begin(), of_relay.end(), index) != of_relay.end()) {
        return Group::relay;
    }
    switch (index >> 8U) {
        case 0x22:
        case 0x23:
        case 0x62:
        case 0x63:
        case 0x73:
            return Group::output;
        case 0x25:
            return Group::extra;
        case 0x30:
        case 0x31:
            return Group::table;
        case 0x33:
        case 0x34:
        case 0x35:
        case 0x36:
            return Group::logic;
        case 0x40:
        case 0x41:
        case 0x42:
        case 0x43:
        case 0x44:
            return Group::math;
        case 0x50:
        case 0x55:
            return Group::diagnostics;
        default:
            return Group::none;
    }
}

inline int some_source() {
    return draw(rc::gen::weightedElement<int>(
        {{2, 0}, {8, 1}, {1, 2}, {3, 3}, {3, 4}, {3, 5}, {1, 6}, {1, 7}, {1, 8}, {1, 9}}));
}
inline int some_number() {
    return draw(rc::gen::weightedElement<int>(
        {{1, 0}, {4, 1}, {4, 2}, {3, 3}, {3, 4}, {2, 5}, {2, 6}, {1, 7}, {1, 8}, {1, 9}, {1, 10}}));
}

inline int some_value_of_table(int index, int sub) {
    switch (index % 0x10) {
        case 0:
            return some_source();
        case 1:
            return some_number();
        case 2:
            return one_of({0, 1});
        case 5:
            return sub == 1 ? one_of({0, 0, 1}) : one_of({0, 1, 1, 1, 2, 2});
        case 6:
            return one_of({-40, 0, 1, 2, 5, 10 * (sub - 1), 10 * (sub - 1) + 3, 10 * (sub - 1) - 5, 200});
        case 7:
            return one_of({-300, -40, 0, 10, 25, 30, 50, 100, 101, 300, 1000});
        default:
            return one_of({0, 0, 1, 2});
    }
}

inline int some_value_of_logic(int index, int sub) {
    if (index == 0x3300) {
        return one_of({0, 1, 1});
    }
    const int place = index % 0x100;
    if (place == 1) {
        return one_of({1, 2, 3, 4, 5, 10});
    }
    if (place == 2) {
        return one_of({0, 1, 2, 3, 4});
    }
    return sub == 5 ? one_of({0, 1, 2, 3, 4, 5}) : sub % 2 == 1 ? some_source() : some_number();
}

inline int some_value_of_math(int index) {
    switch (index >= 0x4100 ? index % 0x100 : index) {
        case 0x4000:
            return one_of({0, 1, 1});
        case 0x4021:
        case 0x4023:
            return one_of({-1000, 0, 0, 100, 1000, 10000});
        case 0x00:
            return one_of({1, 1, 1, 3, 4, 4, 5, 0, 7});
        case 0x01:
            return some_number();
        case 0x02:
            return one_of({0, 0, 1, 2, 3});
        case 0x20:
        case 0x22:
            return one_of({0, 0, 100, 1000, 5000, 10000, -1000});
        case 0x40:
            return one_of({100, 100, 50, 75, 0, -100, -50, -1});
        case 0x50:
            return draw(rc::gen::inRange(0, 18));
        default:
            return one_of({0, 1, 2, 3});
    }
}

inline int some_value(int index, int sub) {
    switch (group_of(index)) {
        case Group::table:
            return some_value_of_table(index, sub);
        case Group::logic:
            return some_value_of_logic(index, sub);
        case Group::math:
            return some_value_of_math(index);
        default:
            break;
    }
    static const std::map<int, std::vector<int>> values{
        {0x6310, {0, 10, 10, 20, 40, 500, 1000, 1020, 1020}},
        {0x2342, {0, 1, 2}},
        {0x2352, {0, 1, 2, 3, 4, 5}},
        {0x2362, {0, 1}},
        {0x2300, {0, 1, 50, 1000, 4000, -2000}},
        {0x7341, {0, 1, 60, 1500, 3000, -1000}},
        {0x7321, {0, 0, 1000, 5000, -5000, 50}},
        {0x7323, {0, 1, 2500, 5000, 10000, 3000}},
        {0x7320, {-1000, 0, 0, 1000}},
        {0x7322, {100, 1000, 1001, 5000}},
        {0x7300, {-1000, 0, 50, 500, 1000, 2500, 5000, 6000}},
        {0x2330, {0, 0, 10, 20, 40}},
        {0x2331, {0, 0, 8, 20, 50}},
        {0x2380, {0, 100, 25000}},
        {0x6302, {0, 1, 2, 3}},
        {0x6332, {0, 1, 2, 3}},
        {0x6340, {0, 1}},
        {0x2223, {0, 2, 5, 7}},
        {0x2240, {0, 1}},
        {0x2241, {0, 1, 2, 2, 3, 3}},
        {0x6250, {0, 1}},
        {0x6260, {0, 1}},
        {0x6220, {0, 0, 1, 1, 2, 255}},
        {0x2242, {0, 1, 2, 3, 3, 4, 4, 5, 5}},
        {0x2250, {0, 2, 3, 7}},
        {0x2282, {0, 1, 2, 3, 4, 5}},
        {0x2292, {0, 1}},
        {0x2293, {0, 1}},
        {0x22A0, {0, 1, 1}},
        {0x22A1, {0, 3, 5, 10, 20}},
        {0x22A2, {0, 2, 5, 10, 20}},
        {0x2500, {-50, 0, 0, 0, 0, 10, 50, 100, 100, 101, 300, 300, 300, 300}},
        {0x2502, {0, 1, 2}},
        {0x2520, {-40, 0, 0, 10}},
        {0x2522, {0, 100, 100, 200, 300}},
        {0x5021, {0, 1, 1}},
        {0x5022, {0, 8, 12, 20}},
        {0x5023, {20, 30, 35, 36}},
        {0x5024, {1, 5, 10}},
        {0x5025, {0, 1}},
        {0x5031, {0, 1, 1}},
        {0x5032, {50, 85, 100}},
        {0x5033, {0, 10, 25, 100}},
        {0x5034, {0, 1}},
        {0x5550, {0, 1}},
        {0x5555, {0, 1}},
    };
    const auto found = values.find(index);
    if (found != values.end()) {
        return one_of(found->second);
    }
    const bool is_number = index % 0x10 == 1;
    return is_number ? some_number() : some_source();
}

}  // namespace canproof::test
