// SPDX-License-Identifier: Apache-2.0
// Swaps the parameters and inputs of two channels of the AX060805 and checks that the results are swapped too. The
// channels are pitch and roll, received values, or function blocks.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

struct Write {
    std::uint16_t index{0};
    std::uint8_t sub{0};
    std::uint32_t value{0};
    int bytes{1};
};

int between(int low, int high) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high));
}
std::uint32_t bits_of_any_real() {
    return InclinometerBench::bits_of(static_cast<float>(between(-40, 41)) / 4.0F);
}

/// Returns writes of the parameters that exist separately for pitch and roll, or for the axes X and Y.
std::vector<Write> any_angle_writes() {
    std::vector<Write> writes;
    for (const std::uint8_t sub : {std::uint8_t{1}, std::uint8_t{2}}) {
        writes.push_back({0x2030, sub, static_cast<std::uint32_t>(between(1, 1000)), 2});
        writes.push_back({0x2031, sub, static_cast<std::uint32_t>(between(0, 2)), 1});
        writes.push_back({0x2040, sub, bits_of_any_real(), 4});
        writes.push_back({0x2050, sub, static_cast<std::uint32_t>(between(0, 3)), 1});
        writes.push_back({0x2051, sub, static_cast<std::uint32_t>(between(1, 6)), 2});
        writes.push_back({0x2010, sub, static_cast<std::uint32_t>(between(1, 1000)), 2});
        writes.push_back({0x2020, sub, bits_of_any_real(), 4});
    }
    return writes;
}

/// Returns writes that set up function block `number`. Neither of its two sources is a function block. Its scales and
/// its operation are arbitrary.
std::vector<Write> any_function(unsigned number) {
    const auto at = static_cast<std::uint16_t>(0x3010U + 0x10U * number);
    const auto plus = [at](unsigned more) { return static_cast<std::uint16_t>(at + more); };
    std::vector<Write> writes;
    for (const std::uint8_t sub : {std::uint8_t{1}, std::uint8_t{2}}) {
        const int source = between(0, 19);  // sources 0 to 9 and 20 to 28, which are not functions
        writes.push_back({at, sub, static_cast<std::uint32_t>(source < 10 ? source : source + 10), 1});
        writes.push_back({plus(1), sub, static_cast<std::uint32_t>(between(0, 2)), 1});
        writes.push_back({plus(2), sub, bits_of_any_real(), 4});
        writes.push_back({plus(3), sub, static_cast<std::uint32_t>(between(0, 4)), 1});
        writes.push_back({plus(4), sub, bits_of_any_real(), 4});
        writes.push_back({plus(5), sub, bits_of_any_real(), 4});
    }
    const auto of_function = static_cast<std::uint8_t>(number + 1U);
    writes.push_back({0x300A, of_function, static_cast<std::uint32_t>(between(1, 21)), 1});
    writes.push_back({0x300B, of_function, bits_of_any_real(), 4});
    writes.push_back({0x300C, of_function, bits_of_any_real(), 4});
    return writes;
}

Write moved_to(Write write, unsigned from, unsigned to) {
    if (write.index <= 0x300C) {
        write.sub = static_cast<std::uint8_t>(to + 1U);
    } else {
        write.index = static_cast<std::uint16_t>(write.index + 0x10U * to - 0x10U * from);
    }
    return write;
}

void write_all(InclinometerBench& bench, const std::vector<Write>& writes) {
    for (const Write& one : writes) {
        bench.write(one.index, one.sub, one.value, one.bytes);
    }
}

std::string rpdo(const std::array<int, 3>& values) {
    std::string text = "27F#";
    for (const int value : values) {
        text += hex_le(static_cast<std::uint32_t>(value) & 0xFFFFU, 2);
    }
    return text;
}

}  // namespace

/// The unit `other` is turned so that X and Y exchange their places: x' = -y, y' = -x. Its pitch then equals the
/// roll of the unit `one`, and its roll equals the pitch of `one`.
RC_GTEST_PROP(InclinometerSwapLaw, ExchangedAxesAndParametersGiveExchangedPitchAndRoll, ()) {
    verifies<req::INC_AVG_005, req::INC_FV_004, req::INC_FV_008>("property");
    InclinometerBench one;
    InclinometerBench other;
    one.power_on();
    other.power_on();
    for (const Write& write : any_angle_writes()) {
        one.write(write.index, write.sub, write.value, write.bytes);
        other.write(write.index, 3U - write.sub, write.value, write.bytes);
    }
    for (const std::uint8_t sub : {std::uint8_t{1}, std::uint8_t{2}}) {
        other.write(0x2011, sub, 1, 1);  // 2011h reverses the sign of the acceleration, as x' = -y requires
    }
    for (int steps = between(1, 8); steps > 0; --steps) {
        const double x = between(-100, 101) / 100.0;
        const double y = between(-100, 101) / 100.0;
        const double z = between(-100, 101) / 100.0 + 0.003;
        one.feel(x, y, z);
        other.feel(-y, -x, z);
        const auto ms = static_cast<std::uint64_t>(between(1, 60));
        one.pass(ms);
        other.pass(ms);
        RC_ASSERT(one.pitch() == other.roll());
        RC_ASSERT(one.roll() == other.pitch());
        RC_ASSERT(one.gravity_angle() == other.gravity_angle());
        RC_ASSERT(one.value(0x4000, 1) == other.value(0x4000, 2));
        RC_ASSERT(one.value(0x4000, 2) == other.value(0x4000, 1));
        RC_ASSERT(one.value(0x4010) == other.value(0x4010));
    }
}

RC_GTEST_PROP(InclinometerSwapLaw, FunctionMovedToAnotherOfTheTenBlocksGivesTheSameResult, ()) {
    verifies<req::INC_BIN_012, req::INC_BIN_013, req::INC_BIN_011>("property");
    const auto from = static_cast<unsigned>(between(0, 10));
    const auto to = static_cast<unsigned>(between(0, 10));
    const std::vector<Write> function = any_function(from);
    InclinometerBench one;
    InclinometerBench other;
    one.power_on();
    other.power_on();
    one.write_real(0x4070, 0, 2.5F);
    other.write_real(0x4070, 0, 2.5F);
    write_all(one, function);
    for (const Write& write : function) {
        const Write moved = moved_to(write, from, to);
        other.write(moved.index, moved.sub, moved.value, moved.bytes);
    }
    for (InclinometerBench* bench : {&one, &other}) {
        bench->send("000#0100");
        bench->send(rpdo({5, -3, 700}));
        bench->turn(12.0, -34.0);
        bench->pass(40);
    }
    RC_ASSERT(one.value(0x3000, static_cast<std::uint8_t>(from + 1U)) ==
              other.value(0x3000, static_cast<std::uint8_t>(to + 1U)));
}

/// Function blocks 1 to 3 each add 0 to one received value, so their results are the received values.
RC_GTEST_PROP(InclinometerSwapLaw, ExchangedParametersOfReceivedValuesGiveExchangedResults, ()) {
    verifies<req::INC_RPDO_001>("property");
    const auto prepared = [](InclinometerBench& bench) {
        bench.power_on();
        for (unsigned i = 0; i < 3; ++i) {
            const auto at = static_cast<std::uint16_t>(0x3010U + 0x10U * i);
            bench.write(at, 1, 20U + i, 1);
            bench.write(at, 2, 25, 1);
            bench.write(0x300A, static_cast<std::uint8_t>(i + 1U), 1, 1);
        }
        bench.send("000#0100");
    };
    const auto order = *rc::gen::element(std::array<std::uint8_t, 3>{1, 0, 2}, std::array<std::uint8_t, 3>{2, 1, 0},
                                         std::array<std::uint8_t, 3>{1, 2, 0});
    InclinometerBench one;
    InclinometerBench other;
    prepared(one);
    prepared(other);
    std::array<int, 3> values{};
    std::array<int, 3> moved{};
    for (std::uint8_t i = 0; i < 3; ++i) {
        const auto digits = static_cast<std::uint32_t>(between(10, 1001));
        const std::uint32_t offset = bits_of_any_real();
        values[i] = between(-2000, 2001);
        moved[order[i]] = values[i];
        one.write(0x2501, static_cast<std::uint8_t>(i + 1U), digits, 2);
        one.write(0x2502, static_cast<std::uint8_t>(i + 1U), offset, 4);
        other.write(0x2501, static_cast<std::uint8_t>(order[i] + 1U), digits, 2);
        other.write(0x2502, static_cast<std::uint8_t>(order[i] + 1U), offset, 4);
    }
    one.send(rpdo(values));
    other.send(rpdo(moved));
    one.pass(5);
    other.pass(5);
    for (std::uint8_t i = 0; i < 3; ++i) {
        RC_ASSERT(one.value(0x3000, static_cast<std::uint8_t>(i + 1U)) ==
                  other.value(0x3000, static_cast<std::uint8_t>(order[i] + 1U)));
    }
}

}  // namespace canproof::test
