// Configurations and steps for the AX130751 and its model: few values, so that limits, delays and equal numbers meet,
// and no two channels alike.
#pragma once

#include <rapidcheck.h>

#include <map>
#include <vector>

#include "properties/devices/ax130751/model_pair.hpp"

namespace canproof::test {

using naive_ax130751::Address;

/// Any of what `gen` gives with the same probability in the first case as in the last.
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
    };
    const auto found = values.find(index);
    if (found != values.end()) {
        return one_of(found->second);
    }
    const bool is_number = index % 0x10 == 1;
    return is_number ? some_number() : some_source();
}

/// What a life is about: the groups that are written to now and then, a group as often as it stands here.
using Focus = std::vector<Group>;

/// A write to any parameter of the groups.
inline void write_some(ModelPair& pair, const Focus& focus) {
    static const std::map<Group, std::vector<Address>> addresses = [&pair] {
        std::map<Group, std::vector<Address>> all;
        for (const auto& [address, entry] : pair.model().entries()) {
            all[group_of(address.first)].push_back(address);
        }
        return all;
    }();
    const auto [index, sub] = draw(rc::gen::elementOf(addresses.at(draw(rc::gen::elementOf(focus)))));
    pair.write(index, sub, some_value(index, sub));
}

/// Extra values of different ranges and digits.
inline void wire_extras(ModelPair& pair) {
    for (int n = 1; n <= 6; ++n) {
        pair.write(0x2502, n, n % 3);
        pair.write(0x2522, n, one_of({100, 100, 100, 200, 50 * n}));
        pair.write(0x2520, n, one_of({0, 0, 0, 0, -40, 10}));
    }
}

/// Tables over extra values, with different points.
inline void wire_tables(ModelPair& pair) {
    for (int n = 1; n <= 4; ++n) {
        const int base = naive_ax130751::table_index(n);
        pair.write(base, 0, one_of({1, 1, 1, 1, 3, 5, 0}));
        pair.write(base + 1, 0, one_of({3 + n, 3 + n, 4, 5, 6, 7, 1, 2}));
        pair.write(base + 2, 0, one_of({0, 1}));
        pair.write(base + 5, 1, one_of({0, 0, 1}));
        for (int i = 0; i < 4; ++i) {
            const int point = draw(rc::gen::inRange(2, 12));
            pair.write(base + 7, point, some_value_of_table(base + 7, point));
            pair.write(base + 6, point, some_value_of_table(base + 6, point));
            pair.write(base + 5, point, one_of({0, 1, 1, 2, 2}));
        }
    }
}

/// A source for one input: most often the extra value that is its own, so that inputs move apart from each other.
inline void wire_input(ModelPair& pair, int index, int sub, int own, const std::vector<int>& sources) {
    const int source = one_of(sources);
    pair.write(index, sub, source);
    pair.write(index + 1, sub, source == 1 ? one_of({own, own, own, sub, 3}) : one_of({1, 2, 3, 4}));
}

inline void wire_outputs(ModelPair& pair) {
    for (int n = 1; n <= 2; ++n) {
        pair.write(0x6310, n, one_of({10, 20, 40, 500, 1000, 1020, 1020, 1020}));
        for (const int index : {0x2330, 0x2331, 0x2241, 0x2223, 0x2352, 0x2362, 0x2342, 0x6340, 0x6250, 0x2300}) {
            pair.write(index, n, some_value(index, n));
        }
        const int first = n == 1 ? 4 : 7;
        wire_input(pair, 0x2340, n, first, {1, 1, 1, 1, 3, 4, 5});
        wire_input(pair, 0x2350, n, first + 1, {0, 1, 1, 1, 3, 5});
        wire_input(pair, 0x2360, n, first + 2, {0, 1, 1, 1, 3, 5});
    }
}

inline void wire_relay(ModelPair& pair) {
    for (const int index : {0x2242, 0x2250, 0x2282, 0x2292, 0x2293, 0x22A0, 0x22A1, 0x22A2}) {
        pair.write(index, 1, some_value(index, 1));
    }
    wire_input(pair, 0x2260, 1, 7, {1, 1, 1, 3, 5});
    wire_input(pair, 0x2270, 1, 8, {0, 1, 1, 1, 3});
    wire_input(pair, 0x2280, 1, 9, {0, 1, 1, 3, 5});
    wire_input(pair, 0x2290, 1, 6, {0, 0, 1, 1, 3});
}

/// One logic block that selects by two extra values, and one math block over three.
inline void wire_logic_and_math(ModelPair& pair) {
    const int logic = draw(rc::gen::inRange(1, 4));
    const int base = 0x3300 + 0x100 * logic;
    pair.write(0x3300, logic, 1);
    for (int function = 1; function <= 3; ++function) {
        pair.write(base + 1, function, one_of({1, 2, 3, 4}));
        pair.write(base + 2, function, one_of({0, 1, 1, 2, 3, 4}));
        for (int condition = 1; condition <= 2; ++condition) {
            const int index = base + 0x10 * function + condition;
            pair.write(index, 1, 1);
            pair.write(index, 2, one_of({4, 5, 6}));
            pair.write(index, 3, one_of({1, 1, 3, 0}));
            pair.write(index, 4, one_of({4, 5, 6, 2}));
            pair.write(index, 5, one_of({0, 1, 2, 3, 4, 5}));
        }
    }
    const int math = draw(rc::gen::inRange(1, 5));
    pair.write(0x4000, math, 1);
    for (int input = 1; input <= 4; ++input) {
        pair.write(0x4000 + 0x100 * math, input, one_of({1, 1, 1, 3, 4, 0}));
        pair.write(0x4001 + 0x100 * math, input, one_of({4, 5, 6, 7, math}));
        for (const int place : {0x02, 0x22, 0x40}) {
            pair.write(0x4000 + 0x100 * math + place, input, some_value_of_math(0x4100 + place));
        }
    }
    for (int function = 1; function <= 3; ++function) {
        pair.write(0x4050 + 0x100 * math, function, draw(rc::gen::inRange(0, 18)));
    }
}

inline void wire(ModelPair& pair, const Focus& focus) {
    const auto is_about = [&focus](Group group) { return std::find(focus.begin(), focus.end(), group) != focus.end(); };
    wire_extras(pair);
    if (is_about(Group::table)) {
        wire_tables(pair);
    }
    if (is_about(Group::logic)) {
        wire_logic_and_math(pair);
    }
    if (is_about(Group::output)) {
        wire_outputs(pair);
    }
    if (is_about(Group::relay)) {
        wire_relay(pair);
    }
}

/// TPDOs of short periods, RPDO 2 and 3, a producer of heartbeats; what the model is told of it.
inline void set_up_network(ModelPair& pair) {
    constexpr std::uint32_t no_rtr = 0x40000000;
    const std::vector<std::uint32_t> mapped{0x40300110, 0x33200110, 0x33100108, 0x40300410};
    for (int i = 1; i <= 4; ++i) {
        pair.set_up(0x1A02, i, mapped.at(static_cast<std::size_t>(i - 1)), 4);
    }
    pair.set_up(0x1A02, 0, 4, 1);
    for (int n = 1; n <= 4; ++n) {
        const auto at = static_cast<std::size_t>(n - 1);
        pair.write(0x17FF + n, 5, one_of({0, 5, 7, 11}));
        pair.set_up(0x17FF + n, 1, no_rtr + 0x80 + 0x100 * static_cast<unsigned>(n) + ModelPair::node, 4);
        pair.set_up(0x13FF + n, 1, no_rtr + 0x100 + 0x100 * static_cast<unsigned>(n) + ModelPair::node, 4);
        pair.model().parameters.transmit.at(at).valid = true;
        pair.model().parameters.receive.at(at).valid = true;
        pair.write(0x13FF + n, 5, one_of({0, 0, 10, 25}));
    }
    pair.write(0x1029, 1, one_of({0, 1, 1}));
    pair.set_up(0x1016, 1, 0x00050000 + 20, 4);
    pair.model().parameters.watches_heartbeat = draw(rc::gen::arbitrary<bool>());
    if (!pair.model().parameters.watches_heartbeat) {
        pair.set_up(0x1016, 1, 0, 4);
    }
}

inline void send_some_rpdo(ModelPair& pair) {
    const int number = draw(rc::gen::inRange(1, 5));
    std::vector<int> bytes;
    if (number == 4) {
        bytes = {one_of({0, 1, 2}), one_of({0, 1})};
    } else {
        for (int i = 0; i < (number == 1 ? 2 : 3); ++i) {
            const int value = number == 1 ? some_value(0x7300, 1) : some_value(0x2500, 1);
            bytes.push_back(value & 0xFF);
            bytes.push_back(value >> 8 & 0xFF);
        }
        if (number == 1) {
            bytes.push_back(one_of({0, 1}));
        }
    }
    if (draw(rc::gen::inRange(0, 12)) == 0) {
        bytes.pop_back();
    }
    pair.rpdo(number, bytes);
}

inline void do_something(ModelPair& pair, const Focus& focus) {
    switch (draw(rc::gen::inRange(0, 20))) {
        case 0:
        case 1:
        case 2:
        case 3:
        case 4:
        case 5:
        case 6:
        case 7:
            return pair.write(0x2500, draw(rc::gen::inRange(1, 7)), some_value(0x2500, 1));
        case 8:
        case 9:
            return pair.write(0x6220, draw(rc::gen::inRange(1, 4)), some_value(0x6220, 1));
        case 10:
            return pair.write(0x7300, draw(rc::gen::inRange(1, 3)), some_value(0x7300, 1));
        case 11:
        case 12:
        case 13:
            return send_some_rpdo(pair);
        case 14:
            return pair.inputs(
                draw(rc::gen::element(24.0F, 24.3F, 24.1F, 24.2F, 12.0F, 7.9F, 8.0F, 6.9F, 30.0F, 35.1F, 39.1F)),
                draw(rc::gen::element(35.0F, 35.0F, 35.0F, 60.0F, 85.0F, 85.1F, 50.0F)),
                draw(rc::gen::element(250.0F, 1.0e6F)), draw(rc::gen::element(500.0F, 2000.0F)));
        case 15:
            return pair.heartbeat();
        default:
            return write_some(pair, focus);
    }
}

/// A life of the device and its model, from the set-up to the first difference.
inline void live(ModelPair& pair, const Focus& focus) {
    wire(pair, focus);
    const int changes = draw(rc::gen::inRange(0, 8));
    for (int i = 0; i < changes; ++i) {
        write_some(pair, focus);
    }
    if (draw(rc::gen::arbitrary<bool>())) {
        pair.store();
    }
    pair.command(1);
    const int steps = draw(rc::gen::inRange(20, 150));
    for (int step = 0; step < steps && !pair.differs(); ++step) {
        do_something(pair, focus);
        const int event = draw(rc::gen::inRange(0, 60));
        if (event == 0) {
            pair.command(one_of({128, 129}));
        } else if (event == 1) {
            pair.store();
        }
        if (pair.model().state != naive_ax130751::Nmt::operational) {
            pair.pass(one_of({0, 1, 5}));
            pair.command(1);
        }
        pair.pass(one_of({0, 1, 1, 1, 2, 3, 4, 5, 6, 9, 10, 11, 20, 25}));
    }
    pair.compare_parameters();
}

}  // namespace canproof::test
