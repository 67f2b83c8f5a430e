// SPDX-License-Identifier: Apache-2.0
// Compares the places at which an AX130751 looks up rows of its tables with the search of all rows.
#include <gtest/gtest.h>

#include <array>

#include "devices/ax130751/firmware/ax130751_sources.hpp"
#include "devices/ax130751/firmware/logic_block.hpp"
#include "generated/ax130751/tables.hpp"
#include "tests/support/shows_rule.hpp"

namespace canproof::test {

namespace {

namespace own = generated::ax130751;
using ax130751::ConditionResult;

void shows_search_rule() {
    shows_rule("a row is found at its place as by a search of the whole table");
}

bool counts(std::uint8_t logical, ConditionResult result) {
    const auto* const row = own::condition_count::find(logical, result);
    return row != nullptr && row->counts;
}

}  // namespace

TEST(Ax130751Search, SourceAndNumberHaveTheirRowOfTable4B) {
    shows_search_rule();
    for (unsigned source = 0; source <= 255; ++source) {
        for (unsigned number = 0; number <= 255; ++number) {
            const auto* const row = own::control_number::find(source, number);
            const ax130751::SourceRef found =
                ax130751::resolve(static_cast<std::uint8_t>(source), static_cast<std::uint8_t>(number));
            ASSERT_EQ(found.quantity, row == nullptr ? ax130751::Quantity::none : row->quantity)
                << source << ' ' << number;
            ASSERT_EQ(unsigned{found.channel}, row == nullptr ? 0U : unsigned{row->channel}) << source << ' ' << number;
        }
    }
}

TEST(Ax130751Search, RowOfTheLimitsHasTheNumberOfItsQuantity) {
    shows_search_rule();
    std::size_t number = 0;
    for (const own::value_limits::Row& row : own::value_limits::rows) {
        EXPECT_EQ(static_cast<std::size_t>(row.quantity), number);
        ++number;
    }
}

TEST(Ax130751Search, OperatorAndResultsHaveTheirRowsOfTables18And19) {
    shows_search_rule();
    constexpr std::array<ConditionResult, 4> all{ConditionResult::fulfilled, ConditionResult::not_fulfilled,
                                                 ConditionResult::error, ConditionResult::not_applicable};
    for (unsigned number = 0; number <= 255; ++number) {
        const auto logical = static_cast<std::uint8_t>(number);
        for (const ConditionResult first : all) {
            for (const ConditionResult second : all) {
                for (const ConditionResult third : all) {
                    const auto* const row = own::table_selection::find(logical, counts(logical, first),
                                                                       counts(logical, second), counts(logical, third));
                    ASSERT_EQ(ax130751::selects(logical, {first, second, third}), row != nullptr && row->selects)
                        << number;
                }
            }
        }
    }
}

}  // namespace canproof::test
