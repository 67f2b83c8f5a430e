// SPDX-License-Identifier: Apache-2.0
// Properties of the lookup tables, logic and math blocks of the AX130751 (manual, 1.5 to 1.7).
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "devices/ax130751/firmware/logic_block.hpp"
#include "devices/ax130751/firmware/lookup_table.hpp"
#include "devices/ax130751/firmware/math_block.hpp"
#include "generated/ax130751/requirements.hpp"
#include "properties/devices/ax130751/naive_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax130751;

PointResponse some_response() {
    return *rc::gen::weightedElement<PointResponse>(
        {{1, PointResponse::ignore}, {6, PointResponse::ramp}, {6, PointResponse::jump}});
}

/// Returns points of a lookup table whose X ascend; some neighbouring X are equal.
LookupPoints some_points() {
    LookupPoints points;
    double x = *rc::gen::inRange(-32768, 30000);
    for (std::size_t i = 0; i < lookup_points; ++i) {
        points.x[i] = x;
        points.y[i] = *rc::gen::inRange(-32768, 32768);
        points.response[i] = some_response();
        x += *rc::gen::inRange(0, 300);
    }
    return points;
}

/// Returns a time profile: points of a lookup table whose X are intervals of 1 ms to 24 h.
LookupPoints some_profile() {
    LookupPoints profile = some_points();
    profile.x[0] = 0.0;
    profile.y[0] = 0.0;
    for (std::size_t i = 1; i < lookup_points; ++i) {
        profile.x[i] =
            1e3 * *rc::gen::weightedOneOf<int>({{3, rc::gen::inRange(1, 1000)}, {1, rc::gen::inRange(1, 86'400'001)}});
    }
    return profile_of(profile);
}

bool is_between_its_limits(double y, const LookupPoints& points) {
    const auto [least, greatest] = std::minmax_element(points.y.begin(), points.y.end());
    return y >= *least - 1e-9 && y <= *greatest + 1e-9;
}

BlockSignal some_signal() {
    return {static_cast<double>(*rc::gen::inRange(-200, 201)), -100.0, 100.0,
            static_cast<SignalState>(*rc::gen::inRange(0, 3))};
}

MathInput some_input() {
    const std::uint8_t own =
        static_cast<std::uint8_t>(*rc::gen::weightedElement<int>({{6, 0}, {1, 1}, {1, 2}, {1, 3}}));
    return {some_signal(), static_cast<double>(*rc::gen::inRange(-100, 101)),
            static_cast<double>(*rc::gen::inRange(-100, 101)), *rc::gen::inRange(-100, 101) / 100.0, own};
}

naive_blocks::State some_state() {
    return *rc::gen::weightedElement<naive_blocks::State>(
        {{6, naive_blocks::State::fine}, {1, naive_blocks::State::error}, {1, naive_blocks::State::unused}});
}

/// Returns an argument of a condition. It has one of only a few values, so that two arguments are often equal.
naive_blocks::Argument some_argument() {
    return {*rc::gen::inRange(-3, 4) / 2.0, some_state()};
}

naive_blocks::Input some_naive_input() {
    naive_blocks::Input input;
    input.own_function = *rc::gen::weightedElement<int>({{6, 0}, {1, 1}, {1, 2}, {1, 3}});
    input.state = input.own_function == 0 ? some_state() : naive_blocks::State::fine;
    input.value = *rc::gen::inRange(-120, 121);
    input.scaling_1 = *rc::gen::weightedOneOf<int>({{1, rc::gen::just(0)}, {1, rc::gen::inRange(-100, 101)}});
    input.scaling_2 = *rc::gen::weightedOneOf<int>({{1, rc::gen::just(100)}, {1, rc::gen::inRange(-100, 101)}});
    input.gain = *rc::gen::weightedOneOf<int>(
        {{2, rc::gen::just(100)}, {1, rc::gen::just(-100)}, {1, rc::gen::inRange(-100, 101)}});
    return input;
}

BlockSignal signal_of(double value, naive_blocks::State state) {
    const SignalState own = state == naive_blocks::State::fine    ? SignalState::valid
                            : state == naive_blocks::State::error ? SignalState::error
                                                                  : SignalState::not_available;
    return {value, -100.0, 100.0, own};
}

LogicFunction logic_function_of(const naive_blocks::Function& naive) {
    LogicFunction function;
    function.logical = static_cast<std::uint8_t>(naive.logical);
    for (std::size_t c = 0; c < logic_conditions; ++c) {
        const auto& one = naive.conditions.at(c);
        function.conditions[c] = {signal_of(one.one.value, one.one.state), signal_of(one.other.value, one.other.state),
                                  static_cast<std::uint8_t>(one.comparison)};
    }
    return function;
}

MathInput math_input_of(const naive_blocks::Input& naive) {
    return {signal_of(naive.value, naive.state), static_cast<double>(naive.scaling_1),
            static_cast<double>(naive.scaling_2), naive.gain / 100.0, static_cast<std::uint8_t>(naive.own_function)};
}

}  // namespace

RC_GTEST_PROP(LookupLaw, OutputStaysBetweenTheLowestAndTheHighestY, ()) {
    verifies<req::AOR_LT_006, req::AOR_LT_001>("property");
    const LookupPoints points = some_points();
    RC_ASSERT(is_between_its_limits(lookup(*rc::gen::inRange(-40000, 40000), points), points));
}

RC_GTEST_PROP(LookupLaw, TimeProfileOutputStaysBetweenTheLowestAndTheHighestY, ()) {
    verifies<req::AOR_LT_006, req::AOR_LT_011>("property");
    const LookupPoints profile = some_profile();
    const auto running = microseconds(*rc::gen::inRange<std::uint64_t>(0, 3'000'000'000'000));
    RC_ASSERT(is_between_its_limits(lookup_in_time(running, profile, *rc::gen::arbitrary<bool>()), profile));
}

RC_GTEST_PROP(LookupLaw, RepeatedTimeProfileGivesTheSameOutputInEachRepetition, ()) {
    verifies<req::AOR_LT_011>("property");
    const LookupPoints profile = some_profile();
    const std::uint64_t length = profile_length(profile).us;
    RC_PRE(length != 0);
    const auto position = *rc::gen::inRange<std::uint64_t>(1, length + 1);
    const auto rounds = *rc::gen::inRange<std::uint64_t>(0, 1000);
    const double first = lookup_in_time(microseconds(position), profile, false);
    RC_ASSERT(std::fabs(lookup_in_time(microseconds(position + rounds * length), profile, true) - first) <= 0.0);
}

RC_GTEST_PROP(LookupLaw, DisabledTableGivesZeroWhateverItsPoints, ()) {
    verifies<req::AOR_LT_015>("property");
    LookupTable table;
    const LookupConfig config{*rc::gen::arbitrary<bool>() ? LookupAxis::data : LookupAxis::time,
                              *rc::gen::arbitrary<bool>(), some_profile()};
    for (int step = 0; step < 5; ++step) {
        table.advance(some_signal(), config, Instant{static_cast<std::uint64_t>(step)});
    }
    const auto output = table.advance(BlockSignal{}, config, Instant{10});
    RC_ASSERT(std::fabs(output.value) <= 0.0);
    RC_ASSERT(output.state == SignalState::not_available);
}

RC_GTEST_PROP(LogicLaw, FirstTrueFunctionOfALogicBlockSelectsItsTable, ()) {
    verifies<req::AOR_LOGIC_003>("property");
    std::array<LogicFunction, logic_functions> functions;
    std::array<bool, logic_functions> holds{};
    for (std::size_t f = 0; f < logic_functions; ++f) {
        functions[f].logical = static_cast<std::uint8_t>(*rc::gen::inRange(0, 5));
        std::array<ConditionResult, logic_conditions> results{};
        for (std::size_t c = 0; c < logic_conditions; ++c) {
            functions[f].conditions[c] = {some_signal(), some_signal(),
                                          static_cast<std::uint8_t>(*rc::gen::inRange(0, 6))};
            results[c] = evaluate(functions[f].conditions[c]);
        }
        holds[f] = selects(functions[f].logical, results);
    }
    const auto first = std::find(holds.begin(), holds.end(), true);
    const auto expected = first == holds.end() ? 0 : first - holds.begin();
    RC_ASSERT(select_function([&](std::size_t number) { return functions[number]; }) ==
              static_cast<std::size_t>(expected));
}

RC_GTEST_PROP(LogicLaw, LogicBlockSelectsTheSameTableAsTheNaiveModel, ()) {
    verifies<req::AOR_LOGIC_001, req::AOR_LOGIC_002, req::AOR_LOGIC_003, req::AOR_LOGIC_004, req::AOR_LOGIC_011,
             req::AOR_LOGIC_005, req::AOR_T16, req::AOR_T17, req::AOR_T18, req::AOR_T19>("property");
    std::array<naive_blocks::Function, logic_functions> naive;
    std::array<LogicFunction, logic_functions> functions;
    for (std::size_t f = 0; f < logic_functions; ++f) {
        naive[f].logical = *rc::gen::inRange(0, 5);
        for (auto& condition : naive[f].conditions) {
            condition = {some_argument(), some_argument(), *rc::gen::inRange(0, 6)};
        }
        functions[f] = logic_function_of(naive[f]);
        RC_ASSERT(selects(functions[f]) == naive_blocks::selects(naive[f]));
    }
    RC_ASSERT(select_function([&](std::size_t number) { return functions[number]; }) == naive_blocks::selected(naive));
}

RC_GTEST_PROP(LogicLaw, LogicBlockOutputLiesBetween0And100Percent,
              (std::int16_t value, std::int16_t a, std::int16_t b)) {
    verifies<req::AOR_LOGIC_007, req::AOR_LOGIC_012>("property");
    const double percentage = percentage_of_limits({static_cast<double>(value), static_cast<double>(std::min(a, b)),
                                                    static_cast<double>(std::max(a, b)), SignalState::valid});
    RC_ASSERT(percentage >= 0.0 && percentage <= 100.0);
}

RC_GTEST_PROP(MathLaw, MathBlockOutputStaysBetweenOutputScaling1And2ForEveryInput, ()) {
    verifies<req::AOR_MATH_008, req::AOR_MATH_004, req::AOR_MATH_024>("property");
    MathBlock block;
    const double scaling_1 = *rc::gen::inRange(-32768, 32768);
    const double scaling_2 = *rc::gen::inRange(-32768, 32768);
    for (int cycle = 0; cycle < 20; ++cycle) {
        MathConfig config;
        for (auto& input : config.inputs) {
            input = some_input();
        }
        for (auto& number : config.operators) {
            number = static_cast<std::uint8_t>(*rc::gen::inRange(0, 18));
        }
        const double output = math_output(block.advance(config).value, scaling_1, scaling_2);
        RC_ASSERT(std::isfinite(output));
        RC_ASSERT(output >= std::min(scaling_1, scaling_2) - 1e-9);
        RC_ASSERT(output <= std::max(scaling_1, scaling_2) + 1e-9);
    }
}

RC_GTEST_PROP(MathLaw, MathBlockGivesTheSameResultAsTheNaiveModel, ()) {
    verifies<req::AOR_MATH_001, req::AOR_MATH_002, req::AOR_MATH_003, req::AOR_MATH_012, req::AOR_MATH_004,
             req::AOR_MATH_005, req::AOR_MATH_013, req::AOR_MATH_006, req::AOR_MATH_007, req::AOR_MATH_009,
             req::AOR_MATH_015, req::AOR_T21, req::AOR_MATH_017, req::AOR_MATH_018, req::AOR_MATH_019,
             req::AOR_MATH_021, req::AOR_MATH_022, req::AOR_MATH_023, req::AOR_MATH_026>("property");
    std::array<naive_blocks::Input, math_inputs> inputs;
    std::array<int, math_functions> operators{};
    MathConfig config;
    MathBlock block;
    naive_blocks::Math naive;
    for (int cycle = 0; cycle < 10; ++cycle) {
        if (cycle == 0 ||
            // the settings stay for several cycles, so that feedback can take effect
            *rc::gen::inRange(0, 3) == 0) {
            for (std::size_t i = 0; i < math_inputs; ++i) {
                inputs[i] = some_naive_input();
                config.inputs[i] = math_input_of(inputs[i]);
            }
            for (std::size_t f = 0; f < math_functions; ++f) {
                operators[f] = *rc::gen::inRange(0, 18);
                config.operators[f] = static_cast<std::uint8_t>(operators[f]);
            }
        }
        RC_ASSERT(std::fabs(block.advance(config).value - naive.cycle(inputs, operators)) <= 0.0);
    }
}

RC_GTEST_PROP(MathLaw, DivisionByZeroGivesZeroForEveryDividend, ()) {
    verifies<req::AOR_MATH_004>("property");
    constexpr std::uint8_t divided_by = 15;
    const double dividend = *rc::gen::inRange(-1000000, 1000001) / 1000.0;
    RC_ASSERT(std::fabs(apply_operator(divided_by, dividend, 0.0)) <= 0.0);
}

RC_GTEST_PROP(MathLaw, MathBlockWithoutInput1OrInput2IsNotCalculatedAndGivesZero, ()) {
    verifies<req::AOR_MATH_011>("property");
    MathConfig config;
    for (auto& input : config.inputs) {
        input = some_input();
    }
    config.inputs[static_cast<std::size_t>(*rc::gen::inRange(0, 2))].signal.state = SignalState::not_available;
    const auto result = MathBlock{}.advance(config);
    RC_ASSERT(!result.done);
    RC_ASSERT(std::fabs(result.value) <= 0.0);
}

}  // namespace canproof::test
