// SPDX-License-Identifier: Apache-2.0
// Programmable logic: selects one of three lookup tables (AX130751, 1.6). Its decision tables are the manual's Tables
// 16 to 19, which come from the requirements register.
#pragma once

#include <array>

#include "devices/ax130751/firmware/block_signal.hpp"
#include "generated/ax130751/enumerations.hpp"

namespace canproof::ax130751 {

using generated::ax130751::ConditionResult;

constexpr std::size_t logic_functions = 3U;
constexpr std::size_t logic_conditions = 3U;

struct LogicCondition {
    BlockSignal first{};
    BlockSignal second{};
    std::uint8_t comparison{0U};  ///< operator of Table 16
};

struct LogicFunction {
    std::array<LogicCondition, logic_conditions> conditions{};
    std::uint8_t logical{0U};  ///< operator of Table 18
};

/// Compares the two signals of a condition by its operator, and returns true, false, error or not applicable by the
/// manual's Table 17.
ConditionResult evaluate(const LogicCondition& condition) noexcept;

/// Returns whether a function selects its lookup table, by the manual's Tables 18 and 19 and the results of the three
/// conditions.
bool selects(std::uint8_t logical, const std::array<ConditionResult, logic_conditions>& results) noexcept;

/// Returns whether the three conditions of a function select its lookup table.
bool selects(const LogicFunction& function) noexcept;

/// Returns the function (0: A, 1: B, 2: C) whose lookup table is passed on: the first function that selects its table,
/// or A if none does. Calls `function_at` for each function that it evaluates.
template <typename FunctionAt>
std::size_t select_function(const FunctionAt& function_at) noexcept {
    for (std::size_t number = 0U; number < logic_functions; ++number) {
        if (selects(function_at(number))) {
            return number;
        }
    }
    return 0U;
}

/// Returns the position of the value of `table` between its lower limit (0) and its upper limit (100), clamped to
/// 0…100. Returns 0 when the upper limit is not above the lower one.
double percentage_of_limits(const BlockSignal& table) noexcept;

}  // namespace canproof::ax130751
