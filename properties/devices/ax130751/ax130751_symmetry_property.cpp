// SPDX-License-Identifier: Apache-2.0
// Checks that both outputs of the AX130751 work alike, and so do all blocks of one kind (such as lookup tables). If the
// parameters and inputs of two are exchanged, their results must be exchanged too.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <utility>

#include "generated/ax130751/requirements.hpp"
#include "properties/devices/ax130751/symmetry.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// Returns the numbers from `first` to `last` in any order.
std::vector<int> some_order(int first, int last) {
    std::vector<int> rest;
    for (int n = first; n <= last; ++n) {
        rest.push_back(n);
    }
    std::vector<int> order;
    while (!rest.empty()) {
        const auto at = static_cast<std::ptrdiff_t>(draw(rc::gen::inRange(0, static_cast<int>(rest.size()))));
        order.push_back(*(rest.begin() + at));
        rest.erase(rest.begin() + at);
    }
    return order;
}

/// Returns a random order of outputs and blocks. Extra received values (2500h) change places only with values of their
/// own RPDO: 1 to 3, or 4 to 6.
Order some_order() {
    Order order;
    order.extras = some_order(1, 3);
    const std::vector<int> others = some_order(4, 6);
    order.extras.insert(order.extras.end(), others.begin(), others.end());
    order.tables = some_order(1, 10);
    order.logic = some_order(1, 3);
    order.math = some_order(1, 4);
    return order;
}

/// Returns two different values of a parameter: one for sub-index 1 and one for sub-index 2 of the object `index`.
std::pair<int, int> two_values(int index) {
    const int one = some_value(index, 1);
    for (int attempt = 0; attempt < 10; ++attempt) {
        const int other = some_value(index, 2);
        if (other != one) {
            return {one, other};
        }
    }
    return {one, one == 0 ? 1 : 0};
}

/// Chooses a source that is a block of another kind. The source must not be a block of the same kind. Blocks of one
/// kind are evaluated in the order of their numbers, so the result would depend on the numbers.
void choose_some(Mirrored& pair, int index, int sub, const std::vector<int>& sources) {
    const int source = one_of(sources);
    pair.choose(index, sub, source, source == 1 ? one_of({1, 2, 4, 5, 6, 7, 8, 9, 3}) : one_of({1, 2, 3, 4, 5}));
}

void set_up_outputs(Mirrored& pair) {
    for (const int index : {0x6310, 0x2330, 0x2331, 0x2342, 0x2352, 0x2362, 0x2380, 0x6340, 0x2223, 0x2240, 0x2241,
                            0x6250, 0x6260, 0x7322, 0x7320, 0x7323, 0x7321, 0x2300, 0x7341, 0x6332, 0x6302}) {
        const bool is_kept = index >= 0x6302 && draw(rc::gen::arbitrary<bool>());
        const auto [one, other] = two_values(index);
        if (index == 0x6310 || !is_kept) {
            pair.write(index, 1, one);
            pair.write(index, 2, other);
        }
    }
    for (int n = 1; n <= 2; ++n) {
        pair.choose(0x2340, n, 1, one_of({n, n, 3 + n, 6 + n}));
        choose_some(pair, 0x2350, n, {0, 0, 1, 1, 3, 4, 5});
        choose_some(pair, 0x2360, n, {0, 0, 1, 1, 3, 4, 5});
    }
    for (const int index : {0x2260, 0x2270, 0x2280, 0x2290}) {
        choose_some(pair, index, 1, {0, 1, 1, 1, 3, 4, 5, 6, 7});
    }
}

void set_up_blocks(Mirrored& pair) {
    for (int n = 1; n <= 6; ++n) {
        pair.write(0x2502, n, n % 3);
        pair.write(0x2522, n, 40 * n + 10);
        pair.write(0x2520, n, n == 3 ? -40 : n);
    }
    for (int n = 1; n <= 10; ++n) {
        const int base = naive_ax130751::table_index(n);
        choose_some(pair, base, 0, {0, 1, 1, 1, 1, 4, 5, 6, 7});
        pair.write(base + 2, 0, n % 2);
        for (int i = 0; i < 3; ++i) {
            const int point = draw(rc::gen::inRange(1, 12));
            for (const int place : {5, 6, 7}) {
                pair.write(base + place, point, some_value_of_table(base + place, point));
            }
        }
    }
    for (int block = 1; block <= 3; ++block) {
        pair.write(0x3300, block, one_of({0, 1, 1}));
        for (int place = 1; place <= 3; ++place) {
            pair.choose_table(block, place, draw(rc::gen::inRange(1, 11)));
            pair.write(0x3302 + 0x100 * block, place, one_of({0, 1, 2, 3, 4}));
            const int index = 0x3300 + 0x100 * block + 0x10 * place + draw(rc::gen::inRange(1, 4));
            choose_some(pair, index, 1, {1, 1, 3, 4, 7});
            choose_some(pair, index, 3, {1, 1, 3, 4, 6});
            pair.write(index, 5, draw(rc::gen::inRange(0, 6)));
        }
    }
    for (int block = 1; block <= 4; ++block) {
        pair.write(0x4000, block, one_of({0, 1, 1}));
        pair.write(0x4023, block, 1000 * block);
        for (int input = 1; input <= 4; ++input) {
            choose_some(pair, 0x4000 + 0x100 * block, input, {0, 1, 1, 1, 3, 5, 6, 7});
            for (const int place : {0x03, 0x20, 0x22, 0x40}) {
                pair.write(0x4000 + 0x100 * block + place, input, some_value_of_math(0x4100 + place));
            }
        }
        for (int function = 1; function <= 3; ++function) {
            pair.write(0x4050 + 0x100 * block, function, draw(rc::gen::inRange(0, 18)));
        }
    }
}

void set_up_pdos(Mirrored& pair, const Order& order) {
    constexpr std::uint32_t no_rtr = 0x40000000;
    const auto math = [](int block) { return 0x40300010 + 0x100 * static_cast<std::uint32_t>(block); };
    pair.set_up(0x1A02, 1, math(2), math(Order::of(order.math, 2)), 4);
    pair.set_up(0x1A02, 2, math(3), math(Order::of(order.math, 3)), 4);
    pair.set_up(0x1A02, 0, 2, 2, 1);
    for (unsigned n = 0; n < 4; ++n) {
        const auto index = static_cast<int>(n);
        pair.set_up(0x1800 + index, 5, 5 + n, 5 + n, 2);
        pair.set_up(0x1800 + index, 1, no_rtr + 0x1FF + 0x100 * n, no_rtr + 0x1FF + 0x100 * n, 4);
        const auto timer = static_cast<std::uint32_t>(one_of({0, 20 + 5 * index}));
        pair.set_up(0x1400 + index, 1, no_rtr + 0x27F + 0x100 * n, no_rtr + 0x27F + 0x100 * n, 4);
        pair.set_up(0x1400 + index, 5, timer, timer, 2);
    }
}

void do_something(Mirrored& pair) {
    switch (draw(rc::gen::inRange(0, 12))) {
        case 0:
        case 1:
            return pair.rpdo(1, {some_value(0x7300, 1), some_value(0x7300, 1), one_of({0, 1})});
        case 2:
        case 3:
            return pair.rpdo(2, {some_value(0x2500, 1), some_value(0x2500, 1), some_value(0x2500, 1)});
        case 4:
        case 5:
            return pair.rpdo(3, {some_value(0x2500, 1), some_value(0x2500, 1), some_value(0x2500, 1)});
        case 6:
        case 7:
            return pair.rpdo(4, {one_of({0, 1}), one_of({0, 1})});
        case 8:
            return pair.inputs(draw(rc::gen::element(24.0F, 24.1F, 12.0F, 35.1F)),
                               draw(rc::gen::element(35.0F, 85.1F, 60.0F)), draw(rc::gen::element(250.0F, 1.0e6F)),
                               draw(rc::gen::element(500.0F, 2000.0F)));
        case 9: {
            const int index = one_of({0x6310, 0x2330, 0x2352, 0x2362, 0x2241, 0x2223, 0x7322, 0x6332, 0x2300});
            return pair.write(index, one_of({1, 2}), some_value(index, 1));
        }
        default:
            return pair.write(0x2500, draw(rc::gen::inRange(1, 7)), some_value(0x2500, 1));
    }
}

}  // namespace

RC_GTEST_PROP(Ax130751Symmetry, ReorderedOutputsAndBlocksBehaveTheSame, ()) {
    verifies<req::AOR_T4B, req::AOR_OUT_003, req::AOR_OUT_012, req::AOR_OUT_019, req::AOR_LOGIC_006, req::AOR_PDO_004>(
        "property");
    const Order order = some_order();
    Mirrored pair{order};
    set_up_pdos(pair, order);
    set_up_blocks(pair);
    set_up_outputs(pair);
    pair.command(1);
    const int steps = draw(rc::gen::inRange(10, 60));
    for (int step = 0; step < steps && pair.difference().empty(); ++step) {
        do_something(pair);
        pair.pass(one_of({1, 1, 2, 5, 10, 20}));
    }
    pair.compare_parameters();
    if (!pair.difference().empty()) {
        RC_FAIL(pair.story() + pair.difference());
    }
}

}  // namespace canproof::test
