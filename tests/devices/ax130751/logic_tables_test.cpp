// SPDX-License-Identifier: Apache-2.0
// Compares the generated Tables 16 to 19 of the AX130751 with the expressions that the manual prints. Also checks that
// no two rows match the same inputs.
#include <gtest/gtest.h>

#include <algorithm>

#include "generated/ax130751/requirements.hpp"
#include "generated/ax130751/tables.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

namespace own = generated::ax130751;
using Result = own::ConditionResult;

constexpr std::array<Result, 4> results{Result::not_fulfilled, Result::fulfilled, Result::error,
                                        Result::not_applicable};

}  // namespace

TEST(Ax130751LogicTables, OperatorsFollowTable16) {
    verifies<req::AOR_T16>();
    namespace t = own::condition_operator;
    for (int argument = -1; argument <= 1; ++argument) {
        const t::Relation relation = argument < 0    ? t::Relation::less
                                     : argument == 0 ? t::Relation::equal
                                                     : t::Relation::greater;
        const std::array<bool, 6> holds{argument == 0, argument != 0, argument > 0,
                                        argument >= 0, argument < 0,  argument <= 0};
        for (std::uint8_t comparison = 0; comparison < 6; ++comparison) {
            const auto* row = t::find(comparison, relation);
            ASSERT_NE(row, nullptr) << int{comparison} << ' ' << argument;
            EXPECT_EQ(row->holds, holds[comparison]) << int{comparison} << ' ' << argument;
        }
    }
    EXPECT_EQ(t::rows.size(), 6U * 3U);
}

TEST(Ax130751LogicTables, ConditionResultsFollowTable17) {
    verifies<req::AOR_T17>();
    namespace t = own::condition_result;
    for (const bool in_error : {false, true}) {
        for (const bool unavailable : {false, true}) {
            for (const bool holds : {false, true}) {
                const auto* row = t::find(in_error, unavailable, holds);
                ASSERT_NE(row, nullptr);
                EXPECT_EQ(row->result, in_error      ? Result::error
                                       : unavailable ? Result::not_applicable
                                       : holds       ? Result::fulfilled
                                                     : Result::not_fulfilled);
            }
        }
    }
    EXPECT_EQ(t::rows.size(), 8U);
}

TEST(Ax130751LogicTables, LogicalOperatorsFollowTable18) {
    verifies<req::AOR_T18>();
    namespace t = own::table_selection;
    for (const bool a : {false, true}) {
        for (const bool b : {false, true}) {
            for (const bool c : {false, true}) {
                const std::array<bool, 5> selects{true, a && b && c, a || b || c, (a && b) || c, (a || b) && c};
                for (std::uint8_t logical = 0; logical < 5; ++logical) {
                    const auto* row = t::find(logical, a, b, c);
                    ASSERT_NE(row, nullptr) << int{logical} << a << b << c;
                    EXPECT_EQ(row->selects, selects[logical]) << int{logical} << a << b << c;
                }
            }
        }
    }
    EXPECT_EQ(t::rows.size(), 5U * 8U);
}

// A condition that is not applicable counts as true if the operator needs all conditions to be true, otherwise as
// false. A condition in error counts as false everywhere except in the default table, which has no condition.
TEST(Ax130751LogicTables, ConditionsThatCountForALogicalOperatorFollowTable19) {
    verifies<req::AOR_T19>();
    namespace t = own::condition_count;
    for (std::uint8_t logical = 0; logical <= 5; ++logical) {
        for (const Result result : results) {
            const auto rows = std::count_if(t::rows.begin(), t::rows.end(), [&](const t::Row& one) {
                return one.logical_first <= logical && logical <= one.logical_last && one.result == result;
            });
            EXPECT_EQ(rows, logical < 5 ? 1 : 0) << int{logical} << ' ' << static_cast<int>(result);
            const auto* row = t::find(logical, result);
            ASSERT_EQ(row != nullptr, logical < 5);
            if (row != nullptr) {
                const bool counts =
                    logical == 0 || result == Result::fulfilled || (logical == 1 && result == Result::not_applicable);
                EXPECT_EQ(row->counts, counts) << int{logical} << ' ' << static_cast<int>(result);
            }
        }
    }
}

TEST(Ax130751LogicTables, Table4BHasOneRowForEachSourceAndNumber) {
    verifies<req::AOR_T4B>();
    namespace t = own::control_number;
    for (int source = 0; source <= 9; ++source) {
        for (int number = 0; number <= 255; ++number) {
            EXPECT_EQ(std::count_if(t::rows.begin(), t::rows.end(),
                                    [&](const t::Row& one) {
                                        return one.source == source && one.number_first <= number &&
                                               number <= one.number_last;
                                    }),
                      1)
                << source << ' ' << number;
        }
    }
}

}  // namespace canproof::test
