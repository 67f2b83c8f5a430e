// SPDX-License-Identifier: Apache-2.0
// Runs an AX130751 and its naive model through random steps. Before the steps, both get the same parameters, most of
// which differ from channel to channel.
#pragma once

#include <cmath>

#include "properties/devices/ax130751/model_pair.hpp"
#include "properties/devices/ax130751/some_values.hpp"

namespace canproof::test {

/// The groups of parameters that a run writes to. A group that is listed twice is chosen twice as often.
using Focus = std::vector<Group>;

inline bool is_about(const Focus& focus, Group group) {
    return std::find(focus.begin(), focus.end(), group) != focus.end();
}

/// Returns the number (1 to `count`) of a random block. Blocks that are in use are more frequent.
template <typename IsUsed>
int some_block(int count, const IsUsed& is_used) {
    const int block = draw(rc::gen::inRange(1, count + 1));
    return is_used(block) || one_of({0, 0, 0, 1}) == 1 ? block : draw(rc::gen::inRange(1, count + 1));
}

inline Address some_address_of_math(const naive_ax130751::Parameters& all) {
    const auto is_used = [&all](int block) { return all.math.at(static_cast<std::size_t>(block - 1)).enable != 0; };
    const int block = some_block(4, is_used);
    const int base = 0x4000 + 0x100 * block;
    const int place = one_of({0x00, 0x01, 0x02, 0x03, 0x20, 0x22, 0x40, 0x40, 0x50, -1});
    if (place < 0) {
        return {one_of({0x4000, 0x4021, 0x4023, 0x4032}), block};
    }
    return {base + place, draw(rc::gen::inRange(1, place == 0x50 ? 4 : 5))};
}

inline Address some_address_of_table() {
    const int base = naive_ax130751::table_index(one_of({1, 1, 2, 2, 3, 3, 4, 4, 5, 6, 7, 8, 9, 10}));
    const int place = one_of({0, 1, 2, 3, 4, 5, 6, 7, 5, 6, 7});
    return {base + place, place < 5 ? 0 : draw(rc::gen::inRange(1, 12))};
}

inline Address some_address_of_logic(const naive_ax130751::Parameters& all) {
    const auto is_used = [&all](int block) { return all.logic.at(static_cast<std::size_t>(block - 1)).enable != 0; };
    const int block = some_block(3, is_used);
    const int base = 0x3300 + 0x100 * block;
    switch (draw(rc::gen::inRange(0, 6))) {
        case 0:
            return {0x3300, block};
        case 1:
            return {base + 1, draw(rc::gen::inRange(1, 4))};
        case 2:
            return {base + 2, draw(rc::gen::inRange(1, 4))};
        default:
            return {base + 0x10 * draw(rc::gen::inRange(1, 4)) + draw(rc::gen::inRange(1, 4)),
                    draw(rc::gen::inRange(1, 6))};
    }
}

/// Returns the address of a random parameter of the groups in `focus`.
inline Address some_address(ModelPair& pair, const Focus& focus) {
    static const std::map<Group, std::vector<Address>> addresses = [&pair] {
        std::map<Group, std::vector<Address>> all;
        for (const auto& [address, entry] : pair.model().entries()) {
            all[group_of(address.first)].push_back(address);
        }
        return all;
    }();
    const Group group = draw(rc::gen::elementOf(focus));
    switch (group) {
        case Group::math:
            return some_address_of_math(pair.model().parameters);
        case Group::logic:
            return some_address_of_logic(pair.model().parameters);
        case Group::table:
            return some_address_of_table();
        default:
            return draw(rc::gen::elementOf(addresses.at(group)));
    }
}

inline void write_some(ModelPair& pair, const Focus& focus) {
    const auto [index, sub] = some_address(pair, focus);
    pair.write(index, sub, some_value(index, sub));
}

/// Gives the extra received values (2500h) different ranges and numbers of decimal digits.
inline void wire_extras(ModelPair& pair) {
    for (int n = 1; n <= 6; ++n) {
        pair.write(0x2502, n, n % 3);
        pair.write(0x2522, n, one_of({100, 100, 100, 200, 50 * n}));
        pair.write(0x2520, n, one_of({0, 0, 0, -40, -40, 10}));
    }
}

/// Connects lookup tables to extra received values (2500h), and gives each table its own random points.
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

/// Chooses a random source for one input. If the source is a received value, it is most often number `own`, so that
/// different inputs read different values.
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
        wire_input(pair, 0x2350, n, first + 1, {0, 1, 1, 1, 3, 4, 5});
        wire_input(pair, 0x2360, n, first + 2, {0, 1, 1, 1, 3, 4, 5});
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

/// Connects a logic block so that extra received values (2500h) decide which lookup table it selects.
inline void wire_logic(ModelPair& pair, int logic) {
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
}

/// Connects the inputs of a math block to extra received values (2500h) or to results of this block's own functions
/// (feedback).
inline void wire_math(ModelPair& pair, int math) {
    pair.write(0x4000, math, 1);
    for (int input = 1; input <= 4; ++input) {
        const bool feeds_back = one_of({0, 0, 1}) == 1;
        pair.write(0x4000 + 0x100 * math, input, feeds_back ? 4 : one_of({1, 1, 1, 3, 4, 0}));
        pair.write(0x4001 + 0x100 * math, input, feeds_back ? math : one_of({4, 5, 6, 7}));
        for (const int place : {0x02, 0x22, 0x40}) {
            pair.write(0x4000 + 0x100 * math + place, input, some_value_of_math(0x4100 + place));
        }
    }
    for (int function = 1; function <= 3; ++function) {
        pair.write(0x4050 + 0x100 * math, function, draw(rc::gen::inRange(0, 18)));
    }
}

inline void wire_logic_and_math(ModelPair& pair) {
    const int logic = draw(rc::gen::inRange(1, 4));
    wire_logic(pair, logic);
    wire_logic(pair, logic % 3 + 1);
    const int math = draw(rc::gen::inRange(1, 5));
    wire_math(pair, math);
    wire_math(pair, math % 4 + 1);
}

/// Connects a chain in which each block reads a block that is evaluated later in the cycle, so that a change takes one
/// cycle per block. Table 1 reads logic block 1, which reads logic block 2, which reads logic block 3, which reads
/// extra received values.
inline void wire_against_the_order(ModelPair& pair) {
    pair.write(0x3010, 0, 5);
    pair.write(0x3011, 0, 1);
    pair.write(0x3015, 1, 0);
    for (int block = 1; block <= 3; ++block) {
        const int base = 0x3300 + 0x100 * block;
        pair.write(0x3300, block, 1);
        pair.write(base + 1, 1, 2);
        pair.write(base + 1, 2, 3);
        pair.write(base + 2, 1, 1);
        pair.write(base + 2, 2, 0);
        pair.write(base + 0x11, 1, block == 3 ? 1 : 5);
        pair.write(base + 0x11, 2, block == 3 ? 4 : block + 1);
        pair.write(base + 0x11, 3, 1);
        pair.write(base + 0x11, 4, one_of({5, 7, 8}));
        pair.write(base + 0x11, 5, one_of({0, 2, 3, 4}));
    }
}

inline void wire(ModelPair& pair, const Focus& focus) {
    wire_extras(pair);
    if (is_about(focus, Group::table)) {
        wire_tables(pair);
    }
    if (is_about(focus, Group::logic)) {
        wire_logic_and_math(pair);
    }
    if (is_about(focus, Group::logic) && one_of({0, 0, 1}) == 1) {
        wire_against_the_order(pair);
    }
    if (is_about(focus, Group::output)) {
        wire_outputs(pair);
    }
    if (is_about(focus, Group::relay)) {
        wire_relay(pair);
    }
}

/// Sets up four TPDOs with short periods, four RPDOs and the monitoring of four heartbeat producers, in the device and
/// in its model.
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
        pair.model().parameters.communication.transmit.at(at).valid = true;
        pair.model().parameters.communication.receive.at(at).valid = true;
        pair.write(0x13FF + n, 5, one_of({0, 0, 10, 25}));
    }
    pair.write(0x1029, 1, one_of({0, 1, 1}));
    for (unsigned n = 0; n < 4; ++n) {
        const int time = one_of({0, 15, 20, 30});
        pair.set_up(0x1016, static_cast<int>(n) + 1, ((5 + n) << 16U) + static_cast<unsigned>(time), 4);
        pair.model().parameters.communication.heartbeat_ms.at(n) = time;
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

/// Switches a block off or on, or a lookup table between data and time response. After it is switched on, a block must
/// not show old values. If `focus` does not contain the math blocks, changes the type of an output instead.
inline void switch_a_block(ModelPair& pair, const Focus& focus) {
    if (is_about(focus, Group::math)) {
        const bool is_math = draw(rc::gen::inRange(0, 3)) != 0;
        const int block = draw(rc::gen::inRange(1, is_math ? 5 : 4));
        const Address table{naive_ax130751::table_index(block) + 5, 1};
        const auto [index, sub] = one_of({0, 0, 1}) == 1 ? table : Address{is_math ? 0x4000 : 0x3300, block};
        pair.write(index, sub, 1 - *pair.model().entries().at({index, sub}).value);
    } else {
        const int n = draw(rc::gen::inRange(1, 3));
        pair.write(0x6310, n, some_value(0x6310, n));
    }
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
            return pair.inputs(draw(rc::gen::element(24.0F, 24.3F, 24.1F, 24.2F, 12.0F, 7.9F, 8.0F, 6.9F, 30.0F, 35.1F,
                                                     39.1F, std::nanf(""))),
                               draw(rc::gen::element(35.0F, 35.0F, 35.0F, 60.0F, 85.0F, 85.1F, 50.0F, std::nanf(""))),
                               draw(rc::gen::element(250.0F, 1.0e6F)), draw(rc::gen::element(500.0F, 2000.0F)));
        case 15:
            return pair.heartbeat(draw(rc::gen::inRange(5U, 9U)));
        case 16:
            return switch_a_block(pair, focus);
        default:
            return write_some(pair, focus);
    }
}

/// Sets up the device and its model, then performs 20 to 150 random steps with both. Stops at the first difference.
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
        const int event = draw(rc::gen::inRange(0, 40));
        if (event == 0) {
            pair.command(one_of({128, 129, 129, 130}));
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
