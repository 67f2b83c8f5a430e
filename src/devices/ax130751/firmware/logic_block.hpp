// Programmable logic: which of three lookup tables is passed on (AX130751, 1.6). Its choices are the manual's tables
// 16 to 19, from the register.
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
    std::uint8_t comparison{0U};  ///< Table 16
};

struct LogicFunction {
    std::array<LogicCondition, logic_conditions> conditions{};
    std::uint8_t logical{0U};  ///< Table 18
};

/// Table 17.
ConditionResult evaluate(const LogicCondition& condition) noexcept;

/// Tables 18 and 19 for the results of the three conditions.
bool selects(std::uint8_t logical, const std::array<ConditionResult, logic_conditions>& results) noexcept;

/// Whether its three conditions let a function select its table.
bool selects(const LogicFunction& function) noexcept;

/// The function (0: A, 1: B, 2: C) whose table is passed on: the first that selects, else A. `function_at` gives a
/// function when its turn has come.
template <typename FunctionAt>
std::size_t select_function(const FunctionAt& function_at) noexcept {
    for (std::size_t number = 0U; number < logic_functions; ++number) {
        if (selects(function_at(number))) {
            return number;
        }
    }
    return 0U;
}

/// A value as a percentage of its limits, 0…100; 0 where they coincide.
double percentage_of_limits(const BlockSignal& table) noexcept;

}  // namespace canproof::ax130751
