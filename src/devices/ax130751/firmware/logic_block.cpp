// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/logic_block.hpp"

#include <algorithm>

#include "devices/ax130751/firmware/linear_scaling.hpp"
#include "devices/ax130751/firmware/number_order.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax130751/requirements.hpp"
#include "generated/ax130751/tables.hpp"

namespace canproof::ax130751 {

namespace {

namespace own = generated::ax130751;

/// Returns the first of the rows of a table at `begin` to `end` - 1 that fits; nullptr without one. The rows of an
/// operator are adjacent in its table. A cycle evaluates up to 27 conditions, so it searches only these rows.
template <typename Row, std::size_t count, typename Fits>
const Row* row_between(const std::array<Row, count>& rows, const std::size_t begin, const std::size_t end,
                       const Fits& fits) noexcept {
    for (std::size_t at = begin; (at < end) && (at < count); ++at) {
        if (fits(rows[at])) {
            return &rows[at];
        }
    }
    return nullptr;
}

const own::condition_operator::Row* relation_row(const std::uint32_t comparison,
                                                 const own::condition_operator::Relation relation) noexcept {
    constexpr std::size_t relations{3U};
    const std::size_t first = comparison * relations;
    return row_between(
        own::condition_operator::rows, first, first + relations,
        [relation](const own::condition_operator::Row& row) noexcept { return row.relation == relation; });
}

const own::table_selection::Row* selection_row(const std::uint32_t logical, const bool first, const bool second,
                                               const bool third) noexcept {
    constexpr std::size_t combinations{8U};
    const std::size_t at = logical * combinations;
    return row_between(own::table_selection::rows, at, at + combinations,
                       [first, second, third](const own::table_selection::Row& row) noexcept {
                           return (row.first == first) && (row.second == second) && (row.third == third);
                       });
}

/// The operators from 2 on share the last rows of Table 19.
const own::condition_count::Row* count_row(const std::uint32_t logical, const ConditionResult result) noexcept {
    constexpr std::size_t results{4U};
    constexpr std::uint32_t shared{2U};
    const std::size_t first = std::min(logical, shared) * results;
    return row_between(own::condition_count::rows, first, first + results,
                       [logical, result](const own::condition_count::Row& row) noexcept {
                           return (logical <= row.logical_last) && (row.result == result);
                       });
}

static_assert(implements<req::AOR_T16> && implements<req::AOR_LOGIC_001>);
bool holds(const LogicCondition& condition) noexcept {
    namespace table = own::condition_operator;
    table::Relation relation{table::Relation::equal};
    if (is_same(condition.first.value, condition.second.value)) {
        // tested first, because most conditions have no source: both values are then 0
    } else if (condition.first.value < condition.second.value) {
        relation = table::Relation::less;
    } else if (condition.first.value > condition.second.value) {
        relation = table::Relation::greater;
    } else {
        // one of the values is NaN: this does not occur, because no signal has the value NaN
    }
    return cell_or(relation_row(condition.comparison, relation), &table::Row::holds, false);
}

static_assert(implements<req::AOR_T19>);
bool counts(const std::uint8_t logical, const ConditionResult result) noexcept {
    return cell_or(count_row(logical, result), &own::condition_count::Row::counts, false);
}

}  // namespace

static_assert(implements<req::AOR_T17> && implements<req::AOR_E_CONDITION> && implements<req::AOR_LOGIC_002>);
ConditionResult evaluate(const LogicCondition& condition) noexcept {
    const bool in_error = condition.first.is_in_error() || condition.second.is_in_error();
    const bool unavailable = (!condition.first.is_available()) || (!condition.second.is_available());
    return cell_or(own::condition_result::find(in_error, unavailable, holds(condition)),
                   &own::condition_result::Row::result, ConditionResult::error);
}

static_assert(implements<req::AOR_T18> && implements<req::AOR_LOGIC_004> && implements<req::AOR_LOGIC_011>);
bool selects(const std::uint8_t logical, const std::array<ConditionResult, logic_conditions>& results) noexcept {
    const auto* const row = selection_row(logical, counts(logical, results[0U]), counts(logical, results[1U]),
                                          counts(logical, results[2U]));
    return cell_or(row, &own::table_selection::Row::selects, false);
}

static_assert(implements<req::AOR_LOGIC_003> && implements<req::AOR_LOGIC_010> && implements<req::AOR_LOGIC_005>);
bool selects(const LogicFunction& function) noexcept {
    const std::array<ConditionResult, logic_conditions> results{
        {evaluate(function.conditions[0U]), evaluate(function.conditions[1U]), evaluate(function.conditions[2U])}};
    return selects(function.logical, results);
}

static_assert(implements<req::AOR_LOGIC_007> && implements<req::AOR_LOGIC_012>);
double percentage_of_limits(const BlockSignal& table) noexcept {
    if (table.upper <= table.lower) {
        return 0.0;
    }
    return scale(table.value, LinearScaling{table.lower, table.upper, 0.0, 100.0});
}

}  // namespace canproof::ax130751
