// SPDX-License-Identifier: Apache-2.0
// Tests the programmable logic of the AX130751 (manual, 1.6): Tables 16 to 19, field by field.
#include "devices/ax130751/firmware/logic_block.hpp"

#include "generated/ax130751/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax130751;

constexpr auto no = ConditionResult::not_fulfilled;
constexpr auto yes = ConditionResult::fulfilled;
constexpr auto err = ConditionResult::error;
constexpr auto na = ConditionResult::not_applicable;
constexpr std::array<ConditionResult, 4> all{no, yes, err, na};

BlockSignal value(double v) {
    return {v, 0.0, 100.0, SignalState::valid};
}
constexpr BlockSignal failed{50.0, 0.0, 100.0, SignalState::error};
constexpr BlockSignal unused{};

ConditionResult compare(double a, std::uint8_t comparison, double b) {
    return evaluate(LogicCondition{value(a), value(b), comparison});
}

/// Returns a function whose first condition has the given result; its other conditions are not used.
LogicFunction function(std::uint8_t logical, ConditionResult first) {
    LogicFunction made;
    made.logical = logical;
    if (first != na) {
        made.conditions[0] = {first == err ? failed : value(1.0), value(first == yes ? 1.0 : 2.0), 0};
    }
    return made;
}

/// Returns the index of the function (A, B or C) whose table the block selects.
std::size_t chosen(const std::array<LogicFunction, logic_functions>& functions) {
    return select_function([&](std::size_t number) { return functions[number]; });
}

}  // namespace

TEST(LogicBlock, ComparisonDoesNotDependOnTheLimitsOfTheSignals) {
    verifies<req::AOR_T16>();
    const BlockSignal below_its_limits{0.0, 2.0, 3.0, SignalState::valid};
    EXPECT_EQ(evaluate(LogicCondition{value(1.0), below_its_limits, 0}), no) << "1 = 0";
    EXPECT_EQ(evaluate(LogicCondition{value(1.0), below_its_limits, 1}), yes) << "1 is not 0";
}

TEST(LogicBlock, ComparisonsFollowTable16) {
    verifies<req::AOR_T16, req::AOR_LOGIC_001>();
    //              <    =    >
    const std::array<std::array<ConditionResult, 3>, 6> expected{{
        {no, yes, no},   // operator 0: =
        {yes, no, yes},  // operator 1: !=
        {no, no, yes},   // operator 2: >
        {no, yes, yes},  // operator 3: >=
        {yes, no, no},   // operator 4: <
        {yes, yes, no},  // operator 5: <=
    }};
    for (std::uint8_t comparison = 0; comparison < 6; ++comparison) {
        EXPECT_EQ(compare(1.0, comparison, 1.1), expected[comparison][0]) << int{comparison};
        EXPECT_EQ(compare(1.1, comparison, 1.1), expected[comparison][1]) << int{comparison};
        EXPECT_EQ(compare(1.1, comparison, 1.0), expected[comparison][2]) << int{comparison};
    }
}

TEST(LogicBlock, PositiveAndNegativeZeroCompareEqual) {
    verifies<req::AOR_T16, req::AOR_LOGIC_001>();
    EXPECT_EQ(compare(0.0, 0, -0.0), yes);  // operator 0: =
    EXPECT_EQ(compare(-0.0, 4, 0.0), no);   // operator 4: <
    EXPECT_EQ(compare(0.0, 2, -0.0), no);   // operator 2: >
}

TEST(LogicBlock, ConditionResultsFollowTable17) {
    verifies<req::AOR_T17, req::AOR_E_CONDITION, req::AOR_LOGIC_002>();
    EXPECT_EQ(evaluate({value(1), value(2), 0}), no);
    EXPECT_EQ(evaluate({value(2), value(2), 0}), yes);
    EXPECT_EQ(evaluate({failed, value(50), 0}), err);
    EXPECT_EQ(evaluate({value(50), failed, 0}), err);
    EXPECT_EQ(evaluate({unused, value(0), 0}), na);
    EXPECT_EQ(evaluate({value(0), unused, 0}), na);
    EXPECT_EQ(evaluate({unused, unused, 0}), na);
    EXPECT_EQ(evaluate({failed, unused, 0}), err) << "an error comes first";
    EXPECT_EQ(evaluate({unused, failed, 0}), err);
    EXPECT_EQ(static_cast<int>(no), 0);
    EXPECT_EQ(static_cast<int>(yes), 1);
    EXPECT_EQ(static_cast<int>(err), 2);
    EXPECT_EQ(static_cast<int>(na), 3);
}

TEST(LogicBlock, OperatorsFollowTables18And19) {
    verifies<req::AOR_T18, req::AOR_T19, req::AOR_LOGIC_004, req::AOR_LOGIC_011>();
    for (const auto a : all) {
        for (const auto b : all) {
            for (const auto c : all) {
                SCOPED_TRACE(testing::Message() << static_cast<int>(a) << static_cast<int>(b) << static_cast<int>(c));
                EXPECT_TRUE(selects(0, {a, b, c})) << "default table";
                const bool none_bad = a != no && a != err && b != no && b != err && c != no && c != err;
                EXPECT_EQ(selects(1, {a, b, c}), none_bad) << "and: not applicable is like true";
                EXPECT_EQ(selects(2, {a, b, c}), a == yes || b == yes || c == yes);
                EXPECT_EQ(selects(3, {a, b, c}), (a == yes && b == yes) || c == yes);
                EXPECT_EQ(selects(4, {a, b, c}), (a == yes || b == yes) && c == yes);
            }
        }
    }
}

TEST(LogicBlock, FirstTrueFunctionSelectsTheTable) {
    verifies<req::AOR_LOGIC_003, req::AOR_LOGIC_010>();
    EXPECT_EQ(chosen({function(1, yes), function(1, yes), function(0, na)}), 0U);
    EXPECT_EQ(chosen({function(1, no), function(1, yes), function(0, na)}), 1U);
    EXPECT_EQ(chosen({function(1, no), function(1, err), function(0, na)}), 2U);
    EXPECT_EQ(chosen({function(1, no), function(0, na), function(1, yes)}), 1U)
        << "a default is taken as soon as it is reached";
    std::size_t looked_at = 0;
    select_function([&](std::size_t number) {
        ++looked_at;
        return number == 1 ? function(1, yes) : function(1, no);
    });
    EXPECT_EQ(looked_at, 2U) << "C has no turn";
}

TEST(LogicBlock, AndOperatorWithoutConditionsGivesTrue) {
    verifies<req::AOR_LOGIC_004>();
    EXPECT_EQ(chosen({function(1, na), function(1, yes), function(0, na)}), 0U);
    EXPECT_EQ(chosen({function(2, na), function(2, yes), function(0, na)}), 1U);
}

TEST(LogicBlock, TableAIsChosenWhenNoFunctionSelectsItsTable) {
    verifies<req::AOR_LOGIC_005>();
    EXPECT_EQ(chosen({function(1, no), function(1, no), function(1, no)}), 0U);
}

TEST(LogicBlock, OutputIsTheTableValueAsPercentageOfTheRangeOfTheTable) {
    verifies<req::AOR_LOGIC_007, req::AOR_LOGIC_012>();
    EXPECT_DOUBLE_EQ(percentage_of_limits({30.0, 0.0, 100.0, SignalState::valid}), 30.0);
    EXPECT_DOUBLE_EQ(percentage_of_limits({-50.0, -200.0, 400.0, SignalState::valid}), 25.0);
    EXPECT_DOUBLE_EQ(percentage_of_limits({400.0, -200.0, 400.0, SignalState::valid}), 100.0);
    EXPECT_DOUBLE_EQ(percentage_of_limits({7.0, 7.0, 7.0, SignalState::valid}), 0.0);
    EXPECT_DOUBLE_EQ(percentage_of_limits({9.0, 7.0, 7.0, SignalState::valid}), 0.0) << "also above them";
}

}  // namespace canproof::test
